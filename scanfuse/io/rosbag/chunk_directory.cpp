#include "scanfuse/io/rosbag/chunk_directory.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace scanfuse::io::rosbag {

namespace {

constexpr std::string_view kVersionLine = "#ROSBAG V2.0\n";

Result<void> check_version(BagFile& file) {
  const auto start = file.read(0, std::min<std::uint64_t>(file.size(), kVersionLine.size()));
  if (!start) return tl::unexpected(start.error());
  const std::string_view line(reinterpret_cast<const char*>(start->data()), start->size());
  if (line == kVersionLine) return {};
  const auto name = file.name().string();
  if (line.starts_with("#ROSBAG V1.") || line.starts_with("#ROSRECORD V")) {
    return fail(Error::Code::kUnsupported,
                "{}: an old bag ({}); convert it with 'rosbag fix {} new.bag'", name,
                line.substr(1, line.find('\n') - 1), name);
  }
  return fail(Error::Code::kMalformed, "{}: byte 0: no ROS bag: it does not start with {}", name,
              kVersionLine.substr(0, kVersionLine.size() - 1));
}

void add_connection(ChunkDirectory& directory, Connection connection) {
  const auto known = std::any_of(directory.connections.begin(), directory.connections.end(),
                                 [&](const auto& c) { return c.id == connection.id; });
  if (!known) directory.connections.push_back(std::move(connection));
}

/// The entry that a chunk info record describes.
Result<ChunkEntry> read_chunk_info(const RecordFields& fields, std::span<const std::byte> data) {
  const auto offset = fields.u64("chunk_pos");
  const auto start = fields.time("start_time"), end = fields.time("end_time");
  const auto count = fields.u32("count");
  if (!offset || !start || !end || !count || data.size() / 8 < *count) {
    return fail(Error::Code::kMalformed, "a chunk info record that describes no chunk");
  }
  ChunkEntry entry{*offset, *start, *end, {}};
  for (std::size_t i = 0; i < *count; ++i) {
    entry.counts[load_u32(data.subspan(8 * i))] += load_u32(data.subspan(8 * i + 4));
  }
  return entry;
}

Result<void> take_index_record(ChunkDirectory& directory, const RecordFields& fields,
                               std::span<const std::byte> data) {
  if (fields.op() == Op::kConnection) {
    auto connection = read_connection(fields, data);
    if (!connection) return tl::unexpected(connection.error());
    add_connection(directory, std::move(*connection));
  } else if (fields.op() == Op::kChunkInfo) {
    auto entry = read_chunk_info(fields, data);
    if (!entry) return tl::unexpected(entry.error());
    directory.chunks.push_back(std::move(*entry));
  } else {
    return fail(Error::Code::kMalformed, "the index holds a record of another kind");
  }
  return {};
}

/// Two entries for one chunk would give its messages twice.
bool names_a_chunk_twice(const ChunkDirectory& directory) {
  std::set<std::uint64_t> offsets;
  for (const auto& chunk : directory.chunks) offsets.insert(chunk.offset);
  return offsets.size() != directory.chunks.size();
}

/// All of it, or an error: a partial index is worth less than reading the chunks.
Result<ChunkDirectory> read_index(BagFile& file) {
  const auto header = file.record_at(kVersionLine.size());
  if (!header) return tl::unexpected(header.error());
  const auto position = header->fields.u64("index_pos");
  const auto connections = header->fields.u32("conn_count");
  const auto chunks = header->fields.u32("chunk_count");
  if (header->fields.op() != Op::kBagHeader || !position || !connections || !chunks) {
    return fail(Error::Code::kMalformed, "the bag header is damaged");
  }
  if (*position == 0) return fail(Error::Code::kMalformed, "the recording was not closed");
  ChunkDirectory directory;
  for (std::uint64_t offset = *position; offset < file.size();) {
    const auto record = file.record_at(offset);
    if (!record) return tl::unexpected(record.error());
    const auto data = file.read(record->data_begin, record->data_bytes);
    if (!data) return tl::unexpected(data.error());
    const auto taken = take_index_record(directory, record->fields, *data);
    if (!taken || !record->whole) return fail(Error::Code::kMalformed, "the index is damaged");
    offset = record->end();
  }
  if (directory.chunks.size() != *chunks || directory.connections.size() != *connections ||
      names_a_chunk_twice(directory)) {
    return fail(Error::Code::kMalformed, "the index does not match its bag header");
  }
  return directory;
}

/// Adds the chunk at `offset` by reading it.
void survey_chunk(BagFile& file, std::uint64_t offset, ChunkDirectory& directory) {
  auto chunk = read_chunk(file, offset);
  if (!chunk) return;
  for (auto& connection : chunk->connections) add_connection(directory, std::move(connection));
  if (chunk->messages.empty()) return;
  ChunkEntry entry{offset, chunk->messages.front().time, chunk->messages.back().time, {}};
  for (const auto& message : chunk->messages) ++entry.counts[message.connection];
  directory.chunks.push_back(std::move(entry));
}

ChunkDirectory survey(BagFile& file) {
  ChunkDirectory directory;
  std::uint64_t offset = kVersionLine.size();
  while (offset < file.size()) {
    const auto record = file.record_at(offset);
    if (!record) {
      directory.diagnostics.damage("bag cut off or damaged: the rest is not read",
                                   record.error().message);
      break;
    }
    if (record->fields.op() == Op::kChunk) survey_chunk(file, offset, directory);
    offset = record->end();
  }
  return directory;
}

}  // namespace

Result<ChunkDirectory> read_directory(BagFile& file) {
  const auto version = check_version(file);
  if (!version) return tl::unexpected(version.error());
  auto index = read_index(file);
  ChunkDirectory directory = index ? std::move(*index) : survey(file);
  if (!index) {
    directory.diagnostics.damage("bag without a usable index: chunks were searched for",
                                 file.name().string() + ": " + index.error().message);
  }
  std::sort(directory.chunks.begin(), directory.chunks.end(), [](const auto& a, const auto& b) {
    return std::pair(a.start, a.offset) < std::pair(b.start, b.offset);
  });
  return directory;
}

}  // namespace scanfuse::io::rosbag
