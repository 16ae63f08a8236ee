#include "scanfuse/io/rosbag/bag_record.hpp"

#include <utility>

namespace scanfuse::io::rosbag {

namespace {

/// Longer headers are damage: fields are numbers, names and, in connections, a topic.
constexpr std::uint32_t kLongestHeader = 1 << 20;

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::uint32_t load_u32(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

Result<RecordFields> RecordFields::parse(std::span<const std::byte> bytes) {
  RecordFields fields;
  while (!bytes.empty()) {
    if (bytes.size() < 4 || load_u32(bytes) > bytes.size() - 4) {
      return fail(Error::Code::kMalformed, "a header field is longer than its header");
    }
    const auto field = bytes.subspan(4, load_u32(bytes));
    const auto equals = as_text(field).find('=');
    if (equals == std::string_view::npos) {
      return fail(Error::Code::kMalformed, "a header field without '='");
    }
    fields.entries_.push_back({as_text(field).substr(0, equals), field.subspan(equals + 1)});
    bytes = bytes.subspan(4 + field.size());
  }
  return fields;
}

std::optional<std::span<const std::byte>> RecordFields::find(std::string_view name) const {
  for (const auto& entry : entries_) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

std::string RecordFields::text(std::string_view name) const {
  const auto value = find(name);
  return value ? std::string(as_text(*value)) : std::string();
}

std::optional<std::uint32_t> RecordFields::u32(std::string_view name) const {
  const auto value = find(name);
  if (!value || value->size() != 4) return std::nullopt;
  return load_u32(*value);
}

std::optional<std::uint64_t> RecordFields::u64(std::string_view name) const {
  const auto value = find(name);
  if (!value || value->size() != 8) return std::nullopt;
  return std::uint64_t{load_u32(value->subspan(4))} << 32 | load_u32(*value);
}

std::optional<Time> RecordFields::time(std::string_view name) const {
  const auto value = find(name);
  if (!value || value->size() != 8) return std::nullopt;
  const std::int64_t seconds = load_u32(*value), nanos = load_u32(value->subspan(4));
  return time_from_nanos(seconds * 1'000'000'000 + nanos);
}

Op RecordFields::op() const {
  const auto value = find("op");
  return value && value->size() == 1 ? static_cast<Op>((*value)[0]) : Op::kNone;
}

Result<RecordView> view_record(std::span<const std::byte> bytes) {
  const auto cut = [] { return fail(Error::Code::kMalformed, "a record is cut off"); };
  if (bytes.size() < 4) return cut();
  const std::size_t header_bytes = load_u32(bytes);
  if (bytes.size() - 4 < header_bytes || bytes.size() - 4 - header_bytes < 4) return cut();
  auto fields = RecordFields::parse(bytes.subspan(4, header_bytes));
  if (!fields) return tl::unexpected(fields.error());
  const auto rest = bytes.subspan(4 + header_bytes);
  const std::size_t data_bytes = load_u32(rest);
  if (rest.size() - 4 < data_bytes) return cut();
  return RecordView{std::move(*fields), rest.subspan(4, data_bytes), 8 + header_bytes + data_bytes};
}

BagFile::BagFile(std::unique_ptr<std::istream> stream, std::filesystem::path name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  stream_->seekg(0, std::ios::end);
  const auto end = stream_->tellg();
  size_ = end > 0 ? static_cast<std::uint64_t>(end) : 0;
}

std::string BagFile::place(std::uint64_t offset) const {
  return fmt::format("{}: byte {}", name_.string(), offset);
}

Result<std::vector<std::byte>> BagFile::read(std::uint64_t offset, std::uint64_t count) {
  if (offset > size_ || count > size_ - offset) {
    return fail(Error::Code::kMalformed, "{}: the file ends before {} more bytes", place(offset),
                count);
  }
  std::vector<std::byte> bytes(count);
  stream_->clear();
  stream_->seekg(static_cast<std::streamoff>(offset));
  stream_->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
  if (static_cast<std::uint64_t>(stream_->gcount()) != count) {
    return fail(Error::Code::kMalformed, "{}: reading failed", place(offset));
  }
  return bytes;
}

Result<FileRecord> BagFile::record_at(std::uint64_t offset) {
  const auto length = read(offset, 4);
  if (!length) return tl::unexpected(length.error());
  const auto header_bytes = load_u32(*length);
  if (header_bytes > kLongestHeader) {
    return fail(Error::Code::kMalformed, "{}: a record header of {} bytes", place(offset),
                header_bytes);
  }
  auto header = read(offset + 4, std::uint64_t{header_bytes} + 4);
  if (!header) return tl::unexpected(header.error());
  FileRecord record;
  record.header = std::move(*header);
  const auto view = std::span<const std::byte>(record.header);
  auto fields = RecordFields::parse(view.first(header_bytes));
  if (!fields) {
    return fail(Error::Code::kMalformed, "{}: {}", place(offset), fields.error().message);
  }
  record.fields = std::move(*fields);
  record.data_begin = offset + 8 + header_bytes;
  record.data_bytes = load_u32(view.subspan(header_bytes));
  record.whole = record.data_bytes <= size_ - record.data_begin;
  if (!record.whole) record.data_bytes = size_ - record.data_begin;
  return record;
}

}  // namespace scanfuse::io::rosbag
