#pragma once

#include <Eigen/Core>
#include <vector>

#include "scanfuse/camera/boards.hpp"

namespace scanfuse::camera {

/// Corners in any row-major order (mirrored, turned), brought into the one that DetectedBoard
/// promises.
[[nodiscard]] std::vector<Eigen::Vector2d> in_order(std::vector<Eigen::Vector2d> corners,
                                                    const BoardSpec& spec);

/// Rows become columns.
[[nodiscard]] std::vector<Eigen::Vector2d> transposed(const std::vector<Eigen::Vector2d>& corners,
                                                      const BoardSpec& spec);

/// Standard deviation of one coordinate of a corner, from third differences; NaN under 4 x 4.
[[nodiscard]] double corner_sigma(const std::vector<Eigen::Vector2d>& corners,
                                  const BoardSpec& spec);

/// Shortest distance between neighbours.
[[nodiscard]] double shortest_side(const std::vector<Eigen::Vector2d>& corners,
                                   const BoardSpec& spec);

/// Whether the corners can be a picture of a flat grid: they follow a homography but for what a
/// lens bends (a quarter of a square).
[[nodiscard]] bool is_flat_grid(const std::vector<Eigen::Vector2d>& corners, const BoardSpec& spec);

/// Maps board coordinates in squares (column, row) to pixels; least squares over all corners.
[[nodiscard]] Eigen::Matrix3d grid_homography(const std::vector<Eigen::Vector2d>& corners,
                                              const BoardSpec& spec);

/// The image of a point under a homography.
[[nodiscard]] inline Eigen::Vector2d mapped(const Eigen::Matrix3d& h, const Eigen::Vector2d& p) {
  const Eigen::Vector3d q = h * p.homogeneous();
  return q.hnormalized();
}

/// The outline of the grid, `margin` squares beyond the outermost inner corners, clockwise.
[[nodiscard]] std::vector<Eigen::Vector2d> grid_outline(const Eigen::Matrix3d& px_from_squares,
                                                        const BoardSpec& spec, double margin);

}  // namespace scanfuse::camera
