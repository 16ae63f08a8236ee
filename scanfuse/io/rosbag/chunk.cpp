#include "scanfuse/io/rosbag/chunk.hpp"

#include <algorithm>
#include <utility>

namespace scanfuse::io::rosbag {

namespace {

/// Takes one record of a chunk in; false at the first one that makes no sense.
bool take_record(Chunk& chunk, const RecordView& record) {
  if (record.fields.op() == Op::kConnection) {
    auto connection = read_connection(record.fields, record.data);
    if (!connection) return false;
    chunk.connections.push_back(std::move(*connection));
    return true;
  }
  if (record.fields.op() != Op::kMessage) return true;
  const auto connection = record.fields.u32("conn");
  const auto time = record.fields.time("time");
  if (!connection || !time) return false;
  const auto begin = static_cast<std::size_t>(record.data.data() - chunk.bytes.data());
  chunk.messages.push_back({*connection, *time, begin, record.data.size()});
  return true;
}

void take_records(Chunk& chunk) {
  std::size_t offset = 0;
  while (offset < chunk.bytes.size()) {
    const auto record = view_record(std::span<const std::byte>(chunk.bytes).subspan(offset));
    if (!record || !take_record(chunk, *record)) {
      if (chunk.problem.empty()) {
        chunk.problem =
            fmt::format("a record at byte {} of the unpacked chunk makes no sense", offset);
      }
      break;
    }
    offset += record->bytes;
  }
  std::sort(chunk.messages.begin(), chunk.messages.end(), [](const auto& a, const auto& b) {
    return std::pair(a.time, a.begin) < std::pair(b.time, b.begin);
  });
}

}  // namespace

Result<Connection> read_connection(const RecordFields& fields, std::span<const std::byte> data) {
  const auto id = fields.u32("conn");
  const auto description = RecordFields::parse(data);
  if (!id || !description) {
    return fail(Error::Code::kMalformed, "a connection record that describes no connection");
  }
  Connection connection{*id, fields.text("topic"), description->text("type"),
                        description->text("message_definition")};
  if (connection.topic.empty()) connection.topic = description->text("topic");
  if (connection.topic.empty() || connection.type.empty()) {
    return fail(Error::Code::kMalformed, "a connection without topic or type");
  }
  return connection;
}

Result<Chunk> read_chunk(BagFile& file, std::uint64_t offset) {
  const auto record = file.record_at(offset);
  if (!record) return tl::unexpected(record.error());
  const auto size = record->fields.u32("size");
  if (record->fields.op() != Op::kChunk || !size) {
    return fail(Error::Code::kMalformed, "{}: no chunk where one should be", file.place(offset));
  }
  auto packed = file.read(record->data_begin, record->data_bytes);
  if (!packed) return tl::unexpected(packed.error());
  auto unpacked = unpack(record->fields.text("compression"), std::move(*packed), *size);
  Chunk chunk;
  chunk.bytes = std::move(unpacked.bytes);
  chunk.problem = record->whole ? std::move(unpacked.problem) : "the file ends within the chunk";
  take_records(chunk);
  return chunk;
}

}  // namespace scanfuse::io::rosbag
