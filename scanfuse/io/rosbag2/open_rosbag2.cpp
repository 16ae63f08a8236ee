#include "scanfuse/io/rosbag2/open_rosbag2.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <system_error>
#include <tuple>
#include <utility>

#include "scanfuse/io/mcap/byte_source.hpp"
#include "scanfuse/io/mcap/compression.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/rosbag2/bag_metadata.hpp"
#include "scanfuse/io/rosbag2/db3_source.hpp"

namespace scanfuse::io {

namespace rosbag2 {
namespace {

using SourcePtr = std::unique_ptr<RawMessageSource>;

constexpr std::uint64_t kLargestUnpacked = std::uint64_t{4} << 30;

/// The bytes of one or more zstd frames; their announced size, where there is one, must hold.
Result<std::vector<std::byte>> unpack_zstd(std::span<const std::byte> packed) {
  const auto announced = ZSTD_getFrameContentSize(packed.data(), packed.size());
  const bool known = announced != ZSTD_CONTENTSIZE_UNKNOWN && announced != ZSTD_CONTENTSIZE_ERROR;
  mcap::Decompressor decompressor;
  auto out = decompressor.decompress(
      "zstd", packed,
      known ? std::min<std::uint64_t>(announced, kLargestUnpacked) : kLargestUnpacked);
  if (!out) return tl::unexpected(out.error());
  if (announced == ZSTD_CONTENTSIZE_ERROR || (known && !out->complete)) {
    return fail(Error::Code::kMalformed, "zstd data are damaged");
  }
  return std::move(out->bytes);
}

Result<SourcePtr> open_packed_file(const std::filesystem::path& path,
                                   const std::vector<std::string>& topics) {
  auto file = mcap::open_bytes(path);
  if (!file) return tl::unexpected(file.error());
  std::vector<std::byte> packed((*file)->size());
  const auto read = (*file)->read(0, packed);
  if (!read) return tl::unexpected(read.error());
  auto bytes = unpack_zstd(packed);
  if (!bytes) return fail(bytes.error().code, "{}: {}", path.string(), bytes.error().message);
  if (path.stem().extension() == ".mcap") {
    return open_mcap(mcap::bytes_in_memory(std::move(*bytes), path.string()), topics);
  }
  auto database = Database::open(std::move(*bytes), path.string());
  if (!database) return tl::unexpected(database.error());
  return open_db3(std::move(*database), topics);
}

Result<SourcePtr> open_bag_file(const std::filesystem::path& path,
                                const std::vector<std::string>& topics) {
  if (path.extension() == ".zstd") return open_packed_file(path, topics);
  if (path.extension() == ".mcap") return open_mcap(path, topics);
  auto database = Database::open(path);
  if (!database) return tl::unexpected(database.error());
  return open_db3(std::move(*database), topics);
}

/// The files of one bag, one after the other.
class JoinedSource final : public RawMessageSource {
 public:
  [[nodiscard]] static Result<SourcePtr> make(BagFiles files, std::filesystem::path name,
                                              const std::vector<std::string>& topics) {
    auto joined =
        std::unique_ptr<JoinedSource>(new JoinedSource(std::move(files), std::move(name), topics));
    const auto surveyed = joined->survey();
    if (!surveyed) return tl::unexpected(surveyed.error());
    return joined;
  }

  const std::vector<RawChannel>& channels() const override { return channels_; }
  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override {
    all_diagnostics_ = diagnostics_;
    if (current_) all_diagnostics_.merge(current_->diagnostics());
    return all_diagnostics_;
  }

  Result<std::optional<RawMessage>> next() override {
    while (current_ || open_next()) {
      auto message = current_->next();
      if (!message) {
        diagnostics_.damage("rest of a split file is not read", message.error().message);
      }
      if (!message || !*message) {
        close_current();
        continue;
      }
      take_channels(*current_);
      (*message)->channel = channel_of_[(*message)->channel];
      if (is_zstd(**message) && !unpack_message(**message)) continue;
      return message;
    }
    return std::optional<RawMessage>{};
  }

 private:
  JoinedSource(BagFiles files, std::filesystem::path name, const std::vector<std::string>& topics)
      : files_(std::move(files)), topics_(topics) {
    info_.path = std::move(name);
    info_.format = "rosbag2";
    for (const auto& missing : files_.missing) {
      diagnostics_.damage("split file of the bag is missing", missing);
    }
  }

  /// Opens every file once, for the description; one at a time, as a bag may have thousands.
  Result<void> survey() {
    std::optional<Error> trouble;
    std::vector<std::filesystem::path> readable;
    for (const auto& path : files_.paths) {
      auto source = open_bag_file(path, topics_);
      if (!source) {
        diagnostics_.damage("split file of the bag cannot be read", source.error().message);
        if (!trouble) trouble = source.error();
        continue;
      }
      describe(**source);
      channel_of_.clear();
      take_channels(**source);
      if (readable.empty()) current_ = std::move(*source);
      readable.push_back(path);
    }
    if (readable.empty()) return tl::unexpected(*trouble);
    files_.paths = std::move(readable);
    channel_of_.clear();
    take_channels(*current_);
    if (files_.messages_compressed || files_.paths.front().extension() == ".zstd") {
      info_.compression = "zstd";
    }
    return {};
  }

  void describe(const RawMessageSource& source) {
    const auto& part = source.info();
    if (part.start) info_.start = std::min(info_.start.value_or(*part.start), *part.start);
    if (part.end) info_.end = std::max(info_.end.value_or(*part.end), *part.end);
    if (info_.compression.empty()) info_.compression = part.compression;
    for (const auto& topic : part.topics) {
      const auto same = std::find_if(info_.topics.begin(), info_.topics.end(), [&](const auto& t) {
        return t.name == topic.name && t.type == topic.type && t.encoding == topic.encoding;
      });
      if (same == info_.topics.end()) {
        info_.topics.push_back(topic);
      } else {
        same->messages += topic.messages;
        same->counted = same->counted && topic.counted;
      }
    }
  }

  /// Gives every channel of the file at hand its number among the bag's.
  void take_channels(const RawMessageSource& source) {
    for (auto i = channel_of_.size(); i < source.channels().size(); ++i) {
      const auto& channel = source.channels()[i];
      const auto number = static_cast<std::uint32_t>(channels_.size());
      const auto [place, is_new] =
          numbers_.try_emplace(std::tuple(channel.topic, channel.type, channel.encoding), number);
      if (is_new) channels_.push_back(channel);
      channel_of_.push_back(place->second);
    }
  }

  bool open_next() {
    while (++next_file_ < files_.paths.size()) {
      auto source = open_bag_file(files_.paths[next_file_], topics_);
      if (source) {
        current_ = std::move(*source);
        channel_of_.clear();
        return true;
      }
      diagnostics_.damage("split file of the bag cannot be read", source.error().message);
    }
    return false;
  }

  void close_current() {
    diagnostics_.merge(current_->diagnostics());
    current_.reset();
  }

  /// Compressed one by one? A CDR message starts with 0, a zstd frame with its magic number; so one
  /// file of a bag reads without the bag's metadata.
  bool is_zstd(const RawMessage& message) const {
    constexpr std::array kMagic{std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f}, std::byte{0xfd}};
    return channels_[message.channel].encoding == "cdr" && message.bytes.size() >= kMagic.size() &&
           std::equal(kMagic.begin(), kMagic.end(), message.bytes.begin());
  }

  bool unpack_message(RawMessage& message) {
    auto bytes = unpack_zstd(message.bytes);
    if (!bytes) {
      diagnostics_.damage("compressed message that cannot be unpacked skipped",
                          channels_[message.channel].topic + ": " + bytes.error().message);
      return false;
    }
    message.bytes = std::move(*bytes);
    return true;
  }

  BagFiles files_;
  std::vector<std::string> topics_;
  std::size_t next_file_ = 0;  ///< the file at hand, or the last one
  SourcePtr current_;
  std::vector<std::uint32_t> channel_of_;  ///< the current file's channel -> ours
  std::map<std::tuple<std::string, std::string, std::string>, std::uint32_t> numbers_;
  std::vector<RawChannel> channels_;
  RecordingInfo info_;
  Diagnostics diagnostics_;
  mutable Diagnostics all_diagnostics_;
};

}  // namespace
}  // namespace rosbag2

Result<std::unique_ptr<RawMessageSource>> open_rosbag2(const std::filesystem::path& path,
                                                       const std::vector<std::string>& topics) {
  std::error_code trouble;
  const bool is_metadata = path.filename() == "metadata.yaml";
  if (!is_metadata && !std::filesystem::is_directory(path, trouble)) {
    return rosbag2::JoinedSource::make({{path}, {}, false}, path, topics);
  }
  const auto folder = is_metadata ? path.parent_path() : path;
  auto files = rosbag2::list_bag_files(folder.empty() ? "." : folder);
  if (!files) return tl::unexpected(files.error());
  return rosbag2::JoinedSource::make(std::move(*files), path, topics);
}

}  // namespace scanfuse::io
