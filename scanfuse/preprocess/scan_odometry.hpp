#pragma once

#include <optional>

#include "scanfuse/core/time.hpp"
#include "scanfuse/preprocess/scan_match.hpp"

namespace scanfuse::preprocess {

/// The motion of one sensor from its own scans, where nothing else tells it. Scans are matched to a
/// scan kept from before (a new one after 0.3 m or 0.2 rad), so that what stands does not drift.
///
/// A sensor is believed to stand until the scene says otherwise: three scans in a row that do not
/// fit where it was, while one motion explains most of what is seen, in so many directions that no
/// vehicle could fill them. Until then the pose is exactly the first. From then on it is followed.
class ScanOdometry {
 public:
  /// The sensor at `scan.stamp` in the frame of its first scan. Valid scans in order of time.
  Pose2 operator()(const VirtualScan& scan);
  /// The pose expected at `stamp` before that scan is seen.
  [[nodiscard]] Pose2 expected(Time stamp) const;
  /// Of the last step, in the sensor's axes: m/s, m/s, rad/s.
  [[nodiscard]] Eigen::Vector3d twist() const { return twist_; }
  [[nodiscard]] bool moves() const { return moves_; }
  /// Whether the last scan could be matched; else the pose is the expected one.
  [[nodiscard]] bool is_found() const { return found_; }
  /// Before the first scan: it is known to move, so.
  void start_moving(const Eigen::Vector3d& twist) {
    moves_ = true;
    twist_ = twist;
  }

 private:
  void watch(const VirtualScan& scan);
  [[nodiscard]] ScanMatch from_any_speed(const VirtualScan& scan, double dt_s) const;
  void follow(const VirtualScan& scan);
  void keep(const VirtualScan& scan, const Pose2& pose);

  ScanMatcher matcher_;
  Pose2 world_from_reference_;
  Pose2 world_from_sensor_;
  Eigen::Vector3d twist_ = Eigen::Vector3d::Zero();
  std::optional<Time> last_;
  Time kept_;
  int doubts_ = 0;
  int lost_ = 0;
  bool moves_ = false;
  bool found_ = true;
};

}  // namespace scanfuse::preprocess
