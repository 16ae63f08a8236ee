#include "scanfuse/io/folder/scan_folder.hpp"

#include <algorithm>

#include "scanfuse/io/text/byte_source.hpp"
#include "scanfuse/io/text/stamp_watch.hpp"

namespace scanfuse::io {
namespace {

Result<std::string> read_small_file(const std::filesystem::path& path) {
  constexpr std::size_t kMost = std::size_t{2} << 30;
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  auto bytes = read_start(**source, kMost + 1);
  if (bytes && bytes->size() > kMost) {
    return fail(Error::Code::kUnsupported, "{}: more than 2 GiB in one scan", path.string());
  }
  return bytes;
}

class ScanFolderReader final : public RecordingReader {
 public:
  ScanFolderReader(ScanFolder folder, const OpenOptions& options) : folder_(std::move(folder)) {
    const auto wanted = [&](const std::string& topic) {
      return options.topics.empty() ||
             std::find(options.topics.begin(), options.topics.end(), topic) != options.topics.end();
    };
    info_.path = folder_.path;
    info_.format = folder_.format;
    info_.compression = "none";
    add_topic(folder_.topic, folder_.type, folder_.files.size(), true);
    add_topic(folder_.pose_topic, folder_.format + " pose", folder_.poses.size(), false);
    add_topic("/tf_static", folder_.format + " mount", folder_.mounts.empty() ? 0 : 1, false);
    for (const auto& file : folder_.files) widen(file.stamp);
    for (const auto& pose : folder_.poses) widen(pose.stamp);
    if (!wanted(folder_.topic)) folder_.files.clear();
    if (!wanted(folder_.pose_topic)) folder_.poses.clear();
  }

  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override { return folder_.diagnostics; }

  /// Loads files until one is good; an error where there are files and none is good.
  Result<void> look_ahead() {
    if (folder_.files.empty()) return {};
    std::optional<Error> first;
    while (!ahead_ && next_file_ < folder_.files.size()) {
      if (auto loaded = load_next(); !loaded && !first) first = loaded.error();
    }
    if (!ahead_ && !any_good_ && first) return tl::unexpected(*first);
    return {};
  }

  Result<std::optional<Event>> next() override {
    if (!folder_.mounts.empty()) {
      auto mounts = std::move(folder_.mounts);
      folder_.mounts.clear();
      return Event{*info_.start, "/tf_static", std::move(mounts)};
    }
    if (!ahead_) {
      if (auto loaded = look_ahead(); !loaded) return tl::unexpected(loaded.error());
    }
    const bool pose_is_next = next_pose_ < folder_.poses.size() &&
                              (!ahead_ || folder_.poses[next_pose_].stamp <= ahead_->stamp);
    if (pose_is_next) {
      const PoseSample& pose = folder_.poses[next_pose_++];
      return Event{pose.stamp, folder_.pose_topic, pose};
    }
    if (!ahead_) return std::nullopt;
    Event event{ahead_->stamp, folder_.topic, std::move(*ahead_)};
    ahead_.reset();
    return event;
  }

 private:
  Result<void> load_next() {
    const ScanFile& file = folder_.files[next_file_];
    const auto number = static_cast<std::int64_t>(next_file_++);
    auto scan = load(file.path);
    if (!scan) {
      folder_.diagnostics.damage("file skipped", scan.error().message);
      return tl::unexpected(scan.error());
    }
    scan->stamp = file.stamp;
    scan->frame = number;
    scan->sensor = folder_.topic;
    scan->frame_id = folder_.frame_id;
    watch_.see(folder_.topic, file.stamp, file.path.filename().string(), folder_.diagnostics);
    any_good_ = true;
    ahead_ = std::move(*scan);
    return {};
  }

  Result<Scan> load(const std::filesystem::path& path) {
    const auto bytes = read_small_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return folder_.read(*bytes, path.string(), folder_.diagnostics);
  }

  void add_topic(const std::string& name, const std::string& type, std::size_t count,
                 bool is_scan) {
    if (count == 0) return;
    info_.topics.push_back(
        {name, type, "binary", static_cast<std::int64_t>(count), true, true, is_scan});
  }
  void widen(Time stamp) {
    info_.start = std::min(info_.start.value_or(stamp), stamp);
    info_.end = std::max(info_.end.value_or(stamp), stamp);
  }

  ScanFolder folder_;
  RecordingInfo info_;
  StampWatch watch_;
  std::optional<Scan> ahead_;
  std::size_t next_file_ = 0;
  std::size_t next_pose_ = 0;
  bool any_good_ = false;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> read_scan_folder(ScanFolder folder,
                                                          const OpenOptions& options) {
  auto reader = std::make_unique<ScanFolderReader>(std::move(folder), options);
  if (auto loaded = reader->look_ahead(); !loaded) return tl::unexpected(loaded.error());
  return reader;
}

}  // namespace scanfuse::io
