#include "scanfuse/io/mcap/chunk_loader.hpp"

#include <algorithm>
#include <utility>

namespace scanfuse::io::mcap {
namespace {

std::string at_byte(std::uint64_t offset) { return fmt::format("byte {}", offset); }

/// Whether what the decompressor gave may be used: all of it, checked; or what a cut-off chunk
/// left.
std::string chunk_problem(const ChunkHead& head, const Decompressed& result) {
  if (!result.complete) return "chunk that does not decompress skipped";
  if (head.uncompressed_crc != 0 && crc32(result.bytes) != head.uncompressed_crc) {
    return "chunk with a wrong checksum skipped";
  }
  return {};
}

}  // namespace

void Directory::add(Schema schema) {
  if (schema.id != 0) schemas.emplace(schema.id, std::move(schema));
}

void Directory::add(Channel channel) {
  const auto id = channel.id;
  if (channels.emplace(id, std::move(channel)).second) channel_order.push_back(id);
}

bool Directory::wants(std::uint16_t channel_id) const {
  if (wanted_topics.empty()) return true;
  const auto found = channels.find(channel_id);
  return found != channels.end() && wanted_topics.contains(found->second.topic);
}

std::optional<std::vector<std::byte>> ChunkLoader::sound_bytes(const RawRecord& record,
                                                               Directory& directory,
                                                               Diagnostics& diagnostics) {
  const auto chunk = parse<ChunkView>(record.content);
  const std::string where = at_byte(record.offset);
  if (record.skipped || (chunk && chunk->head.uncompressed_size > max_chunk_bytes_)) {
    diagnostics.damage("over-long chunk skipped", where);
    return std::nullopt;
  }
  const bool cut = !record.complete;
  if (!chunk || (!cut && chunk->records.size() != chunk->head.compressed_size)) {
    if (!cut) diagnostics.damage("chunk with a damaged head skipped", where);
    return std::nullopt;
  }
  auto result = decompressor_.decompress(chunk->head.compression, chunk->records,
                                         chunk->head.uncompressed_size);
  if (!result) {
    diagnostics.damage("chunk of unknown compression skipped",
                       fmt::format("{}: {}", where, result.error().message));
    return std::nullopt;
  }
  const std::string problem = cut ? std::string() : chunk_problem(chunk->head, *result);
  if (!problem.empty()) {
    diagnostics.damage(problem, where);
    return std::nullopt;
  }
  directory.compressions.insert(chunk->head.compression.empty() ? "none" : chunk->head.compression);
  return std::move(result->bytes);
}

std::optional<OpenChunk> ChunkLoader::load(const RawRecord& record, Directory& directory,
                                           Diagnostics& diagnostics) {
  auto bytes = sound_bytes(record, directory, diagnostics);
  if (!bytes) return std::nullopt;
  OpenChunk chunk;
  chunk.file_offset = record.offset;
  chunk.bytes = std::move(*bytes);
  ChunkRecords records(chunk.bytes);
  while (const auto inner = records.next()) {
    bool sound = true;
    if (inner->is(Opcode::kSchema)) {
      auto schema = parse<Schema>(inner->content);
      sound = schema.has_value();
      if (schema) directory.add(std::move(*schema));
    } else if (inner->is(Opcode::kChannel)) {
      auto channel = parse<Channel>(inner->content);
      sound = channel.has_value();
      if (channel) directory.add(std::move(*channel));
    } else if (inner->is(Opcode::kMessage)) {
      const auto message = parse<MessageView>(inner->content);
      sound = message && directory.channels.contains(message->channel_id);
      if (sound && directory.wants(message->channel_id)) chunk.messages.push_back(*message);
    }
    if (!sound) diagnostics.damage("damaged record in a chunk skipped", at_byte(record.offset));
  }
  if (record.complete && !records.ended_well()) {
    diagnostics.damage("chunk with a torn last record", at_byte(record.offset));
  }
  std::stable_sort(chunk.messages.begin(), chunk.messages.end(),
                   [](const auto& a, const auto& b) { return a.log_time < b.log_time; });
  return chunk;
}

}  // namespace scanfuse::io::mcap
