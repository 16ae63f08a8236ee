#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "scanfuse/io/mcap/compression.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"
#include "scanfuse/io/mcap/record_reader.hpp"
#include "scanfuse/io/mcap/writer.hpp"

// The official conformance files: every combination of the format's features over six inputs, each
// with the records it holds as JSON.
namespace scanfuse::io::mcap {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kConformance = SCANFUSE_SHARED_DATA "/formats/mcap_conformance";

std::vector<std::byte> file_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::vector<fs::path> conformance_files() {
  std::vector<fs::path> files;
  if (!fs::exists(kConformance)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(kConformance)) {
    if (entry.path().extension() == ".mcap") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

template <class Bytes>
json bytes_json(const Bytes& bytes) {
  json list = json::array();
  for (const auto byte : bytes) list.push_back(std::to_string(static_cast<unsigned char>(byte)));
  return list;
}

template <class Map>
json numbers_json(const Map& map) {
  json object = json::object();
  for (const auto& [key, value] : map) object[std::to_string(key)] = std::to_string(value);
  return object;
}

json texts_json(const std::map<std::string, std::string>& map) { return json(map); }
std::string n(std::uint64_t value) { return std::to_string(value); }

json fields(const Header& r) { return {{"library", r.library}, {"profile", r.profile}}; }
json fields(const Footer& r) {
  return {{"summary_crc", n(r.summary_crc)},
          {"summary_offset_start", n(r.summary_offset_start)},
          {"summary_start", n(r.summary_start)}};
}
json fields(const Schema& r) {
  return {
      {"data", bytes_json(r.data)}, {"encoding", r.encoding}, {"id", n(r.id)}, {"name", r.name}};
}
json fields(const Channel& r) {
  return {{"id", n(r.id)},
          {"message_encoding", r.message_encoding},
          {"metadata", texts_json(r.metadata)},
          {"schema_id", n(r.schema_id)},
          {"topic", r.topic}};
}
json fields(const MessageView& r) {
  return {{"channel_id", n(r.channel_id)},
          {"data", bytes_json(r.data)},
          {"log_time", n(r.log_time)},
          {"publish_time", n(r.publish_time)},
          {"sequence", n(r.sequence)}};
}
json fields(const CheckedAttachment& r) {
  EXPECT_TRUE(r.crc_matches);
  return {{"create_time", n(r.attachment.create_time)},
          {"data", bytes_json(r.attachment.data)},
          {"log_time", n(r.attachment.log_time)},
          {"media_type", r.attachment.media_type},
          {"name", r.attachment.name}};
}
json fields(const AttachmentIndex& r) {
  return {{"create_time", n(r.create_time)},
          {"data_size", n(r.data_size)},
          {"length", n(r.length)},
          {"log_time", n(r.log_time)},
          {"media_type", r.media_type},
          {"name", r.name},
          {"offset", n(r.offset)}};
}
json fields(const ChunkIndex& r) {
  return {{"chunk_length", n(r.chunk_length)},
          {"chunk_start_offset", n(r.chunk_start_offset)},
          {"compressed_size", n(r.compressed_size)},
          {"compression", r.compression},
          {"message_end_time", n(r.message_end_time)},
          {"message_index_length", n(r.message_index_length)},
          {"message_index_offsets", numbers_json(r.message_index_offsets)},
          {"message_start_time", n(r.message_start_time)},
          {"uncompressed_size", n(r.uncompressed_size)}};
}
json fields(const Statistics& r) {
  return {{"attachment_count", n(r.attachment_count)},
          {"channel_count", n(r.channel_count)},
          {"channel_message_counts", numbers_json(r.channel_message_counts)},
          {"chunk_count", n(r.chunk_count)},
          {"message_count", n(r.message_count)},
          {"message_end_time", n(r.message_end_time)},
          {"message_start_time", n(r.message_start_time)},
          {"metadata_count", n(r.metadata_count)},
          {"schema_count", n(r.schema_count)}};
}
json fields(const Metadata& r) { return {{"metadata", texts_json(r.metadata)}, {"name", r.name}}; }
json fields(const MetadataIndex& r) {
  return {{"length", n(r.length)}, {"name", r.name}, {"offset", n(r.offset)}};
}
json fields(const SummaryOffset& r) {
  return {{"group_length", n(r.group_length)},
          {"group_opcode", n(r.group_opcode)},
          {"group_start", n(r.group_start)}};
}
json fields(const DataEnd& r) { return {{"data_section_crc", n(r.data_section_crc)}}; }

template <class Record>
json described(const char* type, const RawRecord& raw) {
  const auto record = parse<Record>(raw.content);
  EXPECT_TRUE(record.has_value()) << type;
  if (!record) return nullptr;
  json object = fields(*record);
  json list = json::array();
  for (const auto& [key, value] : object.items()) list.push_back(json::array({key, value}));
  return {{"type", type}, {"fields", list}};
}

json described(const RawRecord& raw) {
  switch (static_cast<Opcode>(raw.opcode)) {
    case Opcode::kHeader:
      return described<Header>("Header", raw);
    case Opcode::kFooter:
      return described<Footer>("Footer", raw);
    case Opcode::kSchema:
      return described<Schema>("Schema", raw);
    case Opcode::kChannel:
      return described<Channel>("Channel", raw);
    case Opcode::kMessage:
      return described<MessageView>("Message", raw);
    case Opcode::kChunkIndex:
      return described<ChunkIndex>("ChunkIndex", raw);
    case Opcode::kAttachment:
      return described<CheckedAttachment>("Attachment", raw);
    case Opcode::kAttachmentIndex:
      return described<AttachmentIndex>("AttachmentIndex", raw);
    case Opcode::kStatistics:
      return described<Statistics>("Statistics", raw);
    case Opcode::kMetadata:
      return described<Metadata>("Metadata", raw);
    case Opcode::kMetadataIndex:
      return described<MetadataIndex>("MetadataIndex", raw);
    case Opcode::kSummaryOffset:
      return described<SummaryOffset>("SummaryOffset", raw);
    case Opcode::kDataEnd:
      return described<DataEnd>("DataEnd", raw);
    default:
      return nullptr;
  }
}

/// All records as the expected JSON lists them: chunks opened, message indexes left out.
json described_file(const fs::path& path) {
  auto source = open_bytes(path);
  EXPECT_TRUE(source.has_value());
  RecordReader reader(**source, kMagicSize, (*source)->size() - kMagicSize);
  Decompressor decompressor;
  json list = json::array();
  for (;;) {
    const auto record = reader.next();
    EXPECT_TRUE(record.has_value());
    if (!record || !*record) break;
    EXPECT_TRUE((*record)->complete);
    if ((*record)->is(Opcode::kMessageIndex)) {
      EXPECT_TRUE(parse<MessageIndex>((*record)->content).has_value());
      continue;
    }
    if (!(*record)->is(Opcode::kChunk)) {
      list.push_back(described(**record));
      continue;
    }
    const auto chunk = parse<ChunkView>((*record)->content);
    const auto bytes = decompressor.decompress(chunk->head.compression, chunk->records,
                                               chunk->head.uncompressed_size);
    EXPECT_TRUE(bytes && bytes->complete);
    EXPECT_EQ(crc32(bytes->bytes), chunk->head.uncompressed_crc);
    ChunkRecords inner(bytes->bytes);
    while (const auto record_inside = inner.next()) list.push_back(described(*record_inside));
    EXPECT_TRUE(inner.ended_well());
  }
  return list;
}

json expected_json(const fs::path& mcap) {
  std::ifstream file(fs::path(mcap).replace_extension(".json"));
  return json::parse(file);
}

TEST(McapConformance, EveryOfficialFileReadsAsItsExpectedJson) {
  const auto files = conformance_files();
  if (files.empty()) GTEST_SKIP() << "no shared data: skipped";
  EXPECT_EQ(files.size(), 416u);
  for (const auto& path : files) {
    EXPECT_EQ(described_file(path), expected_json(path)["records"]) << path;
  }
}

WriterOptions options_of(const std::set<std::string>& features) {
  WriterOptions options;
  options.library = "";
  options.compression = Compression::kNone;
  options.chunks = features.contains("ch");
  options.message_index = features.contains("mx");
  options.chunk_index = features.contains("chx");
  options.statistics = features.contains("st");
  options.repeated_schemas = features.contains("rsh");
  options.repeated_channels = features.contains("rch");
  options.attachment_index = features.contains("ax");
  options.metadata_index = features.contains("mdx");
  options.summary_offsets = features.contains("sum");
  return options;
}

/// Writes again what the records of the data section say.
std::vector<std::byte> rewritten(const fs::path& path, const WriterOptions& options) {
  std::vector<std::byte> out;
  auto writer = Writer::create(sink_to_memory(out), options);
  auto source = open_bytes(path);
  RecordReader file(**source, kMagicSize, (*source)->size() - kMagicSize);
  const auto repeat = [&](const RawRecord& record) {
    if (record.is(Opcode::kSchema)) {
      EXPECT_TRUE(writer->add_schema(*parse<Schema>(record.content)));
    } else if (record.is(Opcode::kChannel)) {
      EXPECT_TRUE(writer->add_channel(*parse<Channel>(record.content)));
    } else if (record.is(Opcode::kMessage)) {
      EXPECT_TRUE(writer->write(*parse<MessageView>(record.content)));
    } else if (record.is(Opcode::kAttachment)) {
      EXPECT_TRUE(writer->write(parse<CheckedAttachment>(record.content)->attachment));
    } else if (record.is(Opcode::kMetadata)) {
      EXPECT_TRUE(writer->write(*parse<Metadata>(record.content)));
    }
  };
  for (;;) {
    const auto record = file.next();
    if (!record || !*record || (*record)->is(Opcode::kDataEnd)) break;
    if ((*record)->is(Opcode::kChunk)) {
      ChunkRecords inner(parse<ChunkView>((*record)->content)->records);
      while (const auto record_inside = inner.next()) repeat(*record_inside);
    } else {
      repeat(**record);
    }
  }
  EXPECT_TRUE(writer->finish());
  return out;
}

// All but those whose records are padded with unknown fields, which a writer has no reason to make.
TEST(McapConformance, RewritingAFileWithItsFeaturesGivesTheSameBytes) {
  const auto files = conformance_files();
  if (files.empty()) GTEST_SKIP() << "no shared data: skipped";
  int equal = 0, tried = 0;
  for (const auto& path : files) {
    const json expected = expected_json(path);
    const auto features = expected["meta"]["variant"]["features"].get<std::set<std::string>>();
    if (features.contains("pad")) continue;
    ++tried;
    const bool same = rewritten(path, options_of(features)) == file_bytes(path);
    EXPECT_TRUE(same) << path;
    equal += same ? 1 : 0;
  }
  RecordProperty("byte_equal", equal);
  EXPECT_EQ(equal, tried);
  EXPECT_EQ(tried, 208);
}

}  // namespace
}  // namespace scanfuse::io::mcap
