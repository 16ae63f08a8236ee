#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "scanfuse/simulate/world.hpp"

// What the scenarios of streets share: courses to drive, and the cast that drives them.
namespace scanfuse::simulate {

/// A course of straight runs and arcs, sampled about every metre.
class Course {
 public:
  explicit Course(const Pose2& start) : at_(start), poses_{start} {}

  Course& run(double length_m) { return arc(length_m, 0); }
  /// Turns by `angle_rad` (left is positive) over `length_m`.
  Course& arc(double length_m, double angle_rad);
  /// The same way back, on a lane so far to the left.
  [[nodiscard]] Course back(double left_m) const;
  [[nodiscard]] const std::vector<Pose2>& poses() const { return poses_; }
  /// `speed_at(metres from the start)`; the course begins at `start_s`.
  [[nodiscard]] PlanarMotion drive(double start_s,
                                   const std::function<double(double)>& speed_at) const;

 private:
  Pose2 at_;
  std::vector<Pose2> poses_;
};

[[nodiscard]] std::function<double(double)> steady(double speed_m_per_s);
/// Slows from `fast` to `slow` around `where_m` and picks up again.
[[nodiscard]] std::function<double(double)> slowing(double fast, double slow, double where_m,
                                                    double width_m);

/// Hands out ids and keeps the actors of a street. Each `add` leaves out whom it would run into
/// somebody before the end of the scenario, and tells whether it did not.
class Cast {
 public:
  Cast(World& of, RandomStream& from) : world_(&of), random_(&from) {}

  [[nodiscard]] std::int64_t next_id() const {
    return static_cast<std::int64_t>(world_->actors.size()) + 1;
  }
  bool add(Actor actor, PlanarMotion motion) const;
  bool car(PlanarMotion motion) const;
  bool van(PlanarMotion motion) const;
  bool truck(PlanarMotion motion) const;
  bool pedestrian(PlanarMotion motion) const;
  bool cyclist(PlanarMotion motion) const;

 private:
  [[nodiscard]] bool runs_free(const Actor& actor) const;

  World* world_;
  RandomStream* random_;
};

}  // namespace scanfuse::simulate
