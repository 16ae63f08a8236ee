#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/ego.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::io {

/// One topic (or sensor column) of a recording.
struct TopicInfo {
  std::string name;
  std::string type;      ///< "sensor_msgs/LaserScan", "csv points", ...
  std::string encoding;  ///< "ros1", "cdr", "json", "text", ...
  std::int64_t messages = 0;
  bool counted = true;   ///< false: the format has no index; `messages` is 0
  bool decoded = false;  ///< scanfuse understands this type
  bool is_scan = false;
};

struct RecordingInfo {
  std::filesystem::path path;
  std::string format;  ///< "mcap", "rosbag1", "rosbag2", "carmen", "pcd", "kitti", "csv points"
  std::string compression;  ///< "none", "lz4", "zstd, none", ...
  std::vector<TopicInfo> topics;
  std::optional<Time> start;  ///< of the first message
  std::optional<Time> end;
};

/// One decoded message. `log_time` is when it was recorded; the payload has its own header stamp.
struct Event {
  Time log_time;
  std::string topic;
  std::variant<Scan, PoseSample, std::vector<TransformSample>, ImuSample, TruthFrame> payload;
};

/// Reads a recording front to back, never holding more than a chunk of it. Events come in order of
/// `log_time` as far as the format can give it without loading the file.
/// Unknown message types are passed over and counted in `info()`; damage is counted and skipped.
class RecordingReader {
 public:
  virtual ~RecordingReader() = default;
  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
  /// The next event; nothing at the end. An error is final.
  [[nodiscard]] virtual Result<std::optional<Event>> next() = 0;
  /// What was odd so far. Grows while reading.
  [[nodiscard]] virtual const Diagnostics& diagnostics() const = 0;
};

struct OpenOptions {
  std::vector<std::string> topics;  ///< only these; empty: all
  bool paper_axes = false;          ///< CSV only: x lateral (right), y forward, as in [Lu2018]
};

/// Finds the format by content (name only where content cannot tell) and opens it. A file or a
/// folder (rosbag2, PCD files, KITTI .bin files). Never succeeds with an empty guess: an unknown
/// format is an error that lists the known ones.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> open_recording(
    const std::filesystem::path& path, const OpenOptions& options = {});

}  // namespace scanfuse::io
