#pragma once

#include <array>

#include "scanfuse/geometry/pose.hpp"

namespace scanfuse {

/// A rectangle in the plane: centre, heading of its long axis, extent.
struct Box2 {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double heading_rad = 0;
  double length_m = 0;
  double width_m = 0;

  [[nodiscard]] Pose2 pose() const { return {centre_m.x(), centre_m.y(), heading_rad}; }

  /// Front left, rear left, rear right, front right.
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners() const {
    const double l = length_m / 2, w = width_m / 2;
    const Pose2 p = pose();
    return {p * Eigen::Vector2d(l, w), p * Eigen::Vector2d(-l, w), p * Eigen::Vector2d(-l, -w),
            p * Eigen::Vector2d(l, -w)};
  }
  [[nodiscard]] bool contains(const Eigen::Vector2d& point, double margin_m = 0) const;
};

/// Whether points lie in a box that a margin makes larger on every side: for many points of one
/// box.
class InBox {
 public:
  InBox(const Box2& box, double margin_m)
      : centre_m_(box.centre_m),
        axis_(std::cos(box.heading_rad), std::sin(box.heading_rad)),
        half_m_(box.length_m / 2 + margin_m, box.width_m / 2 + margin_m) {}
  [[nodiscard]] bool operator()(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d d = point - centre_m_;
    return std::abs(axis_.dot(d)) <= half_m_.x() &&
           std::abs(axis_.x() * d.y() - axis_.y() * d.x()) <= half_m_.y();
  }

 private:
  Eigen::Vector2d centre_m_, axis_, half_m_;
};

inline bool Box2::contains(const Eigen::Vector2d& point, double margin_m) const {
  const double reach_m = (length_m + width_m) / 2 + 2 * margin_m;
  if ((point - centre_m).cwiseAbs().maxCoeff() > reach_m) return false;  // most are far away
  return InBox(*this, margin_m)(point);
}

/// The box with another extent whose faces turned to `seen_from` stay where they are: what is known
/// of a partly seen object is its near side, not its centre.
[[nodiscard]] inline Box2 resize_about_seen_side(const Box2& box, double length_m, double width_m,
                                                 const Eigen::Vector2d& seen_from) {
  const Eigen::Vector2d viewer = box.pose().inverse() * seen_from;
  const Eigen::Vector2d shift(std::copysign((length_m - box.length_m) / 2, -viewer.x()),
                              std::copysign((width_m - box.width_m) / 2, -viewer.y()));
  return {box.pose() * shift, box.heading_rad, length_m, width_m};
}

}  // namespace scanfuse
