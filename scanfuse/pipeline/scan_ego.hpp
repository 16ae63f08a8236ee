#pragma once

#include <map>
#include <optional>
#include <string>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/pipeline/pose_buffer.hpp"
#include "scanfuse/preprocess/scan_odometry.hpp"
#include "scanfuse/preprocess/virtual_scan_builder.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::pipeline {

/// Where the ego is, from the scans themselves, while nothing else tells it. Sensors whose places
/// on the ego are known share one motion, which the first of them is matched for; one of unknown
/// place has its own.
class ScanEgo {
 public:
  struct Placement {
    Pose3 world_from_ego;
    PoseBuffer::Twist twist;
  };

  /// The ego at a scan, the world being the ego's first place; nothing while it seems to stand.
  /// Scans in order of time.
  [[nodiscard]] std::optional<Placement> operator()(const Scan& scan, const Pose3& ego_from_sensor,
                                                    bool mount_is_known);
  /// The same for a moving ego that was told of until now; `start` is where this scan is expected,
  /// if it is the first. Nothing where there is too little to see.
  [[nodiscard]] std::optional<Placement> go_on(const Scan& scan, const Pose3& ego_from_sensor,
                                               const Placement& start);
  /// Its place is told again.
  void forget() { streams_.clear(); }

 private:
  struct Stream {
    std::string leader;  ///< the sensor that is matched
    Pose2 ego_from_level;
    Pose3 world_from_start;
    preprocess::ScanOdometry odometry;
  };
  Stream& stream_of(const Scan& scan, const Pose3& ego_from_sensor, bool mount_is_known);
  Placement place(Stream& stream, const Scan& scan, const Pose3& ego_from_sensor);

  preprocess::VirtualScanBuilder flatten_;
  std::map<std::string, Stream> streams_;  ///< by frame, where its place is not known
};

}  // namespace scanfuse::pipeline
