#include "scanfuse/io/mcap/topic_writer.hpp"

#include <algorithm>

#include "scanfuse/io/mcap/result_messages.hpp"

namespace scanfuse::io::mcap {

Result<TopicWriter> TopicWriter::create(const std::filesystem::path& path,
                                        const WriterOptions& options) {
  auto writer = Writer::create(path, options);
  if (!writer) return tl::unexpected(writer.error());
  return TopicWriter(std::move(*writer));
}

Result<TopicWriter::Topic*> TopicWriter::find(std::string_view topic, const Schema& schema,
                                              std::string_view encoding) {
  const std::pair key(std::string(topic), schema.name);
  if (const auto found = topics_.find(key); found != topics_.end()) return &found->second;
  auto known = schemas_.find(schema.name);
  if (known == schemas_.end()) {
    const auto id = writer_.add_schema(schema);
    if (!id) return tl::unexpected(id.error());
    known = schemas_.emplace(schema.name, *id).first;
  }
  const auto channel =
      writer_.add_channel({0, known->second, std::string(topic), std::string(encoding), {}});
  if (!channel) return tl::unexpected(channel.error());
  return &topics_.emplace(key, Topic{*channel, 0}).first->second;
}

Result<void> TopicWriter::write(std::string_view topic, const Schema& schema,
                                std::string_view encoding, Time time,
                                std::span<const std::byte> bytes) {
  auto found = find(topic, schema, encoding);
  if (!found) return tl::unexpected(found.error());
  // MCAP counts from 1970 on; an earlier instant keeps its place in the message only.
  const auto nanos = static_cast<std::uint64_t>(std::max<std::int64_t>(0, to_nanos(time)));
  return writer_.write(MessageView{(*found)->channel, (*found)->messages++, nanos, nanos, bytes});
}

Result<void> TopicWriter::write_json(std::string_view topic, std::string_view type, Time time,
                                     std::string_view text) {
  const Schema schema{0, std::string(type), "jsonschema", std::string(json_schema(type))};
  return write(topic, schema, "json", time, std::as_bytes(std::span(text.data(), text.size())));
}

Result<void> TopicWriter::write_cdr(std::string_view topic, Time time,
                                    const ros::EncodedMessage& message) {
  const Schema schema{0, message.type, "ros2msg", message.definition};
  return write(topic, schema, "cdr", time, message.bytes);
}

std::string topic_of(std::string_view name) {
  if (name.empty()) return "/scan";
  return name.front() == '/' ? std::string(name) : "/" + std::string(name);
}

}  // namespace scanfuse::io::mcap
