#include "scanfuse/io/mcap/summary.hpp"

#include <algorithm>
#include <utility>

#include "scanfuse/io/mcap/record_codec.hpp"
#include "scanfuse/io/mcap/record_reader.hpp"

namespace scanfuse::io::mcap {
namespace {

constexpr std::uint64_t kEndSize = kRecordHeadSize + kFooterSize + kMagicSize;
constexpr std::uint64_t kMaxSummaryBytes = std::uint64_t{1} << 30;

template <class Record>
bool keep(std::span<const std::byte> content, std::vector<Record>& list) {
  auto record = parse<Record>(content);
  if (record) list.push_back(std::move(*record));
  return record.has_value();
}

template <class Record>
bool keep(std::span<const std::byte> content, std::map<std::uint16_t, Record>& map) {
  auto record = parse<Record>(content);
  if (record) map.emplace(record->id, std::move(*record));
  return record.has_value();
}

bool keep_summary_record(const RawRecord& record, Summary& summary) {
  switch (static_cast<Opcode>(record.opcode)) {
    case Opcode::kSchema:
      return keep(record.content, summary.schemas);
    case Opcode::kChannel:
      return keep(record.content, summary.channels);
    case Opcode::kChunkIndex:
      return keep(record.content, summary.chunks);
    case Opcode::kAttachmentIndex:
      return keep(record.content, summary.attachments);
    case Opcode::kMetadataIndex:
      return keep(record.content, summary.metadata);
    case Opcode::kStatistics:
      summary.statistics = parse<Statistics>(record.content);
      return summary.statistics.has_value();
    default:
      return true;
  }
}

Result<std::optional<Footer>> read_footer(ByteSource& source) {
  if (source.size() < kEndSize + kMagicSize) return std::nullopt;
  const std::uint64_t place = source.size() - kEndSize;
  std::vector<std::byte> magic(kMagicSize);
  if (auto done = source.read(source.size() - kMagicSize, magic); !done) {
    return tl::unexpected(done.error());
  }
  if (!is_magic(magic)) return std::nullopt;
  RecordReader reader(source, place, source.size() - kMagicSize);
  auto record = reader.next();
  if (!record) return tl::unexpected(record.error());
  if (!*record || !(*record)->is(Opcode::kFooter) || !(*record)->complete ||
      (*record)->content.size() != kFooterSize) {
    return std::nullopt;
  }
  return parse<Footer>((*record)->content);
}

/// The checksum runs from the summary's first byte to just before the checksum itself.
Result<bool> summary_crc_matches(ByteSource& source, const Footer& footer, std::uint64_t end) {
  if (footer.summary_crc == 0) return true;
  std::vector<std::byte> bytes(
      static_cast<std::size_t>(end + kRecordHeadSize + 16 - footer.summary_start));
  if (auto done = source.read(footer.summary_start, bytes); !done) {
    return tl::unexpected(done.error());
  }
  return crc32(bytes) == footer.summary_crc;
}

Result<std::string> fill_summary(ByteSource& source, const Footer& footer, Summary& summary) {
  const std::uint64_t end = source.size() - kEndSize;
  if (footer.summary_start < kMagicSize || footer.summary_start > end ||
      end - footer.summary_start > kMaxSummaryBytes) {
    return "the footer points outside of the file";
  }
  auto sound = summary_crc_matches(source, footer, end);
  if (!sound) return tl::unexpected(sound.error());
  if (!*sound) return "the checksum of the summary is wrong";
  RecordReader reader(source, footer.summary_start, end);
  for (;;) {
    auto record = reader.next();
    if (!record) return tl::unexpected(record.error());
    if (!*record) break;
    if (!(*record)->complete || !keep_summary_record(**record, summary)) {
      return fmt::format("the summary record at byte {} is damaged", (*record)->offset);
    }
  }
  if (reader.offset() != end) return "the summary is damaged";
  return std::string();
}

void order_chunks(std::vector<ChunkIndex>& chunks) {
  std::stable_sort(chunks.begin(), chunks.end(), [](const auto& a, const auto& b) {
    return a.chunk_start_offset < b.chunk_start_offset;
  });
  const auto repeated = std::unique(chunks.begin(), chunks.end(), [](const auto& a, const auto& b) {
    return a.chunk_start_offset == b.chunk_start_offset;
  });
  chunks.erase(repeated, chunks.end());
}

}  // namespace

Result<FileEnd> read_file_end(ByteSource& source) {
  FileEnd result;
  auto footer = read_footer(source);
  if (!footer) return tl::unexpected(footer.error());
  if (!*footer) return result;
  result.has_footer = true;
  if ((*footer)->summary_start == 0) return result;
  auto problem = fill_summary(source, **footer, result.summary);
  if (!problem) return tl::unexpected(problem.error());
  result.problem = std::move(*problem);
  if (!result.problem.empty()) {
    result.summary = {};
  } else {
    result.summary.start = (*footer)->summary_start;
    order_chunks(result.summary.chunks);
  }
  return result;
}

bool index_is_usable(const Summary& summary) {
  if (summary.chunks.empty() || summary.channels.empty()) return false;
  if (summary.statistics && summary.statistics->chunk_count != summary.chunks.size()) return false;
  if (summary.statistics && summary.statistics->channel_count != summary.channels.size()) {
    return false;
  }
  for (const auto& chunk : summary.chunks) {
    for (const auto& [channel, offset] : chunk.message_index_offsets) {
      if (!summary.channels.contains(channel)) return false;
    }
  }
  return true;
}

}  // namespace scanfuse::io::mcap
