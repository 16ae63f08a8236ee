#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "scanfuse/core/time.hpp"
#include "scanfuse/io/mcap/writer.hpp"
#include "scanfuse/io/ros/encode.hpp"

namespace scanfuse::io::mcap {

/// Writes messages by topic; schemas and channels are added when first used. Messages of one topic
/// but of different types go to channels of their own.
class TopicWriter {
 public:
  [[nodiscard]] static Result<TopicWriter> create(const std::filesystem::path& path,
                                                  const WriterOptions& options = {});

  /// A message in JSON; its schema is that of `json_schema(type)`.
  [[nodiscard]] Result<void> write_json(std::string_view topic, std::string_view type, Time time,
                                        std::string_view text);
  [[nodiscard]] Result<void> write_cdr(std::string_view topic, Time time,
                                       const ros::EncodedMessage& message);
  [[nodiscard]] Result<void> write(const Metadata& metadata) { return writer_.write(metadata); }
  [[nodiscard]] Result<void> checkpoint() { return writer_.checkpoint(); }
  [[nodiscard]] Result<void> finish() { return writer_.finish(); }

 private:
  struct Topic {
    std::uint16_t channel = 0;
    std::uint32_t messages = 0;
  };
  explicit TopicWriter(Writer writer) : writer_(std::move(writer)) {}
  [[nodiscard]] Result<void> write(std::string_view topic, const Schema& schema,
                                   std::string_view encoding, Time time,
                                   std::span<const std::byte> bytes);
  [[nodiscard]] Result<Topic*> find(std::string_view topic, const Schema& schema,
                                    std::string_view encoding);

  Writer writer_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::pair<std::string, std::string>, Topic> topics_;  ///< by topic and type
};

/// "/name": the topic of a sensor or column name.
[[nodiscard]] std::string topic_of(std::string_view name);

}  // namespace scanfuse::io::mcap
