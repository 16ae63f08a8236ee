#pragma once

#include <optional>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::pipeline {

/// Finds where a pose froze: it stays the same to the last bit for `least` and `messages` or more,
/// and came to that from a speed that no brake takes off within one message (8 m/s^2). A vehicle
/// that comes to rest is not meant, nor a pose that is told oftener than it is made: it must stay
/// three times as long as it ever did before moving on. Samples in order of time; what steps back
/// is left out.
class FrozenPoses {
 public:
  explicit FrozenPoses(Duration least = std::chrono::milliseconds(500), int messages = 5)
      : least_(least), least_messages_(messages) {}

  void add(Time stamp, const Pose3& pose);
  /// Since when the pose at `stamp` had been frozen; nothing where it was not, as far as the
  /// samples so far tell.
  [[nodiscard]] std::optional<Time> frozen_since(Time stamp) const;

 private:
  struct Span {
    Time from;
    Time to;
  };
  void start_run(Time stamp, const Pose3& pose);

  Duration least_;
  int least_messages_;
  Duration longest_{0};  ///< that it stayed before moving on, after stopping dead
  std::vector<Span> spans_;
  std::optional<Span> run_;  ///< of the last pose
  Pose3 pose_;
  int messages_ = 0;
  bool stopped_dead_ = false;
  bool listed_ = false;  ///< the run is the last of `spans_`
};

}  // namespace scanfuse::pipeline
