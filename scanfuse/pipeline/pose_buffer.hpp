#pragma once

#include <deque>
#include <optional>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::pipeline {

/// Poses by time, interpolated between samples. Samples may come a little out of order.
class PoseBuffer {
 public:
  struct Found {
    Pose3 pose;
    bool extrapolated = false;  ///< `stamp` lies outside the samples
  };
  struct Twist {
    double speed_m_per_s = 0;  ///< along the ego's x axis
    double lateral_m_per_s = 0;
    double yaw_rate_rad_per_s = 0;
  };

  /// Keeps samples in order of stamp; of two with one stamp the later given wins.
  void add(Time stamp, const Pose3& pose);
  /// The pose at `stamp`: interpolated; beyond the ends carried on with the last motion, for up to
  /// `kReach`, then held. Nothing when there is no sample.
  [[nodiscard]] std::optional<Found> at(Time stamp) const;
  /// Planar motion around `stamp` in the ego's own axes; zero with fewer than two samples.
  [[nodiscard]] Twist twist_at(Time stamp) const;
  /// True when a sample at or after `stamp` has come.
  [[nodiscard]] bool covers(Time stamp) const;
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  /// Forgets what lies before `stamp`, but for one sample.
  void forget_before(Time stamp);

 private:
  struct Sample {
    Time stamp;
    Pose3 pose;
  };
  static constexpr Duration kReach = std::chrono::milliseconds(250);
  [[nodiscard]] std::size_t first_after(Time stamp) const;

  std::deque<Sample> samples_;
};

}  // namespace scanfuse::pipeline
