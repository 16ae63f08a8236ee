#pragma once

#include <filesystem>
#include <memory>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// Writes events as an MCAP recording that this library, ROS 2 and Foxglove read: scans as
/// LaserScan or PointCloud2, poses as Odometry, transforms as TFMessage (all CDR), truth as
/// scanfuse.Truth (JSON). Appears under its name when finished; docs/mcap.md lists the topics.
class McapRecordingWriter {
 public:
  [[nodiscard]] static Result<McapRecordingWriter> create(const std::filesystem::path& path);
  McapRecordingWriter(McapRecordingWriter&&) noexcept;
  McapRecordingWriter& operator=(McapRecordingWriter&&) noexcept;
  ~McapRecordingWriter();

  /// Events should come in order of `log_time`. An empty topic gets the usual one of its kind.
  [[nodiscard]] Result<void> write(const Event& event);
  /// What was written so far outlives this process, in the file's ".part".
  [[nodiscard]] Result<void> checkpoint();
  [[nodiscard]] Result<void> finish();

 private:
  struct State;
  explicit McapRecordingWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scanfuse::io
