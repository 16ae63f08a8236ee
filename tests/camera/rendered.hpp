#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "scanfuse/camera/boards.hpp"
#include "scanfuse/camera/stripe.hpp"
#include "scanfuse/simulate/turntable_images.hpp"

/// Rendered images and the truth that belongs to them.
namespace scanfuse::camera_testing {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Root mean square of a corner coordinate's error.
inline double corner_error(const simulate::TurntableWorld& world, std::size_t b,
                           const camera::DetectedBoard& board) {
  double sum = 0;
  for (std::size_t i = 0; i < board.corners_px.size(); ++i) {
    const auto columns = static_cast<std::size_t>(board.spec.columns);
    const Vector3d at(static_cast<double>(i % columns) * board.spec.square_m,
                      static_cast<double>(i / columns) * board.spec.square_m, 0);
    const Vector2d truth = world.camera.project(world.camera_from_board[b] * at);
    sum += (board.corners_px[i] - truth).squaredNorm();
  }
  return std::sqrt(sum / (2.0 * static_cast<double>(board.corners_px.size())));
}

/// Distances in pixels of stripe points from the true line, and on which square each lies.
class StripeTruth {
 public:
  StripeTruth(const simulate::TurntableWorld& world, std::size_t b, double turned_rad)
      : world_(&world), board_(b), lidar_(world.rig.pose(turned_rad)) {}

  [[nodiscard]] Vector3d on_board(const Vector2d& pixel) const {
    const Pose3& board = world_->camera_from_board[board_];
    const Vector3d n = board.rotation * Vector3d::UnitZ();
    const Vector3d ray = simulate::ray_of_pixel(world_->camera, pixel);
    return n.dot(board.translation_m) / n.dot(ray) * ray;
  }
  [[nodiscard]] double error_px(const Vector2d& p) const {
    constexpr double kStep = 0.01;
    const auto slope = [&](const Vector2d& d) { return (off(p + d) - off(p - d)) / (2 * kStep); };
    const Vector2d gradient(slope({kStep, 0}), slope({0, kStep}));
    return off(p) / gradient.norm();
  }
  [[nodiscard]] int square(const Vector2d& p) const {
    return world_->square_at(board_,
                             (world_->camera_from_board[board_].inverse() * on_board(p)).head<2>());
  }

 private:
  [[nodiscard]] double off(const Vector2d& p) const {
    return (lidar_.rotation * Vector3d::UnitZ()).dot(on_board(p) - lidar_.translation_m);
  }
  const simulate::TurntableWorld* world_;
  std::size_t board_;
  Pose3 lidar_;
};

/// Errors of all stripe points of some positions of a rendered session.
struct StripeErrors {
  double sum = 0, squares = 0;
  int count = 0;
  double on_square[2] = {0, 0};
  int count_on_square[2] = {0, 0};
  int missing = 0;
  double saturated = 0;

  void add(const StripeTruth& truth, const camera::Stripe& stripe) {
    if (!stripe.found()) ++missing;
    saturated = std::max(saturated, stripe.saturated_share);
    for (const auto& point : stripe.points) {
      const double error = truth.error_px(point.position_px);
      sum += error;
      squares += error * error;
      ++count;
      const int square = truth.square(point.position_px);
      if (square < 0) continue;
      on_square[square] += error;
      ++count_on_square[square];
    }
  }
  [[nodiscard]] double rms() const { return std::sqrt(squares / count); }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] double mean_on(int square) const {
    return count_on_square[square] > 0 ? on_square[square] / count_on_square[square] : 0;
  }
};

}  // namespace scanfuse::camera_testing
