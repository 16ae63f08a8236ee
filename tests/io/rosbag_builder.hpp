#pragma once

#include <bzlib.h>
#include <lz4frame.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace scanfuse::io {

/// Writes small ROS 1 bags for tests, to the published format.
class RosbagBuilder {
 public:
  explicit RosbagBuilder(std::string compression = "none") : compression_(std::move(compression)) {}

  void connection(std::uint32_t id, const std::string& topic, const std::string& type) {
    const auto record =
        make_record(field("conn", u32(id)) + field("op", "\x07") + field("topic", topic),
                    field("type", type) + field("md5sum", "*") + field("message_definition", "") +
                        field("topic", topic));
    connections_ += record;
    ++connection_count_;
    chunk_ += record;
  }

  void message(std::uint32_t id, std::uint32_t seconds, const std::string& bytes) {
    const auto time = u32(seconds) + u32(0);
    chunk_ +=
        make_record(field("conn", u32(id)) + field("op", "\x02") + field("time", time), bytes);
    start_ = std::min(start_, seconds);
    end_ = std::max(end_, seconds);
    ++counts_[id];
  }

  void close_chunk() {
    std::string info;
    for (const auto& [id, count] : counts_) info += u32(id) + u32(count);
    const auto offset = kHeader + body_.size();
    infos_ += make_record(field("chunk_pos", u32(static_cast<std::uint32_t>(offset)) + u32(0)) +
                              field("count", u32(static_cast<std::uint32_t>(counts_.size()))) +
                              field("end_time", u32(end_) + u32(0)) + field("op", "\x06") +
                              field("start_time", u32(start_) + u32(0)) + field("ver", u32(1)),
                          info);
    body_ += make_record(field("compression", compression_) + field("op", "\x05") +
                             field("size", u32(static_cast<std::uint32_t>(chunk_.size()))),
                         packed());
    body_ += make_record(
        field("conn", u32(0)) + field("count", u32(0)) + field("op", "\x04") + field("ver", u32(1)),
        "");
    chunk_.clear();
    counts_.clear();
    start_ = ~0U;
    end_ = 0;
    ++chunk_count_;
  }

  /// `with_index` false: as a recorder leaves a bag that it could not close.
  std::string finish(bool with_index = true) const {
    const auto position = static_cast<std::uint32_t>(with_index ? kHeader + body_.size() : 0);
    const auto head = field("chunk_count", u32(with_index ? chunk_count_ : 0)) +
                      field("conn_count", u32(with_index ? connection_count_ : 0)) +
                      field("index_pos", u32(position) + u32(0)) + field("op", "\x03");
    const auto magic = std::string("#ROSBAG V2.0\n");
    const auto padding = kHeader - magic.size() - 8 - head.size();
    auto bag = magic + make_record(head, std::string(padding, ' ')) + body_;
    return with_index ? bag + connections_ + infos_ : bag;
  }

  static std::string u32(std::uint32_t value) {
    std::string text;
    for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> 8 * i & 255U);
    return text;
  }

 private:
  static constexpr std::size_t kHeader = 256;  // ROS pads to 4096; any length is valid

  static std::string field(const std::string& name, const std::string& value) {
    return u32(static_cast<std::uint32_t>(name.size() + 1 + value.size())) + name + "=" + value;
  }
  static std::string make_record(const std::string& header, const std::string& data) {
    return u32(static_cast<std::uint32_t>(header.size())) + header +
           u32(static_cast<std::uint32_t>(data.size())) + data;
  }

  std::string packed() {
    if (compression_ == "bz2") {
      auto length = static_cast<unsigned>(chunk_.size() + chunk_.size() / 100 + 600);
      std::string out(length, '\0');
      BZ2_bzBuffToBuffCompress(out.data(), &length, chunk_.data(),
                               static_cast<unsigned>(chunk_.size()), 9, 0, 0);
      out.resize(length);
      return out;
    }
    if (compression_ == "lz4") {
      std::string out(LZ4F_compressFrameBound(chunk_.size(), nullptr), '\0');
      out.resize(LZ4F_compressFrame(out.data(), out.size(), chunk_.data(), chunk_.size(), nullptr));
      return out;
    }
    return chunk_;
  }

  std::string compression_;
  std::string chunk_, body_, connections_, infos_;
  std::uint32_t chunk_count_ = 0, connection_count_ = 0;
  std::uint32_t start_ = ~0U, end_ = 0;
  std::map<std::uint32_t, std::uint32_t> counts_;
};

}  // namespace scanfuse::io
