#include "scanfuse/camera/grid.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace scanfuse::camera {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

/// Mean step from one corner to the next, along rows and along columns.
struct Steps {
  Eigen::Vector2d along_row, along_column;
};

Steps mean_steps(const Corners& corners, int rows, int columns) {
  const auto at = [&](int r, int c) { return corners[static_cast<std::size_t>(r * columns + c)]; };
  Steps steps{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  for (int r = 0; r < rows; ++r) steps.along_row += at(r, columns - 1) - at(r, 0);
  for (int c = 0; c < columns; ++c) steps.along_column += at(rows - 1, c) - at(0, c);
  steps.along_row /= rows * (columns - 1);
  steps.along_column /= columns * (rows - 1);
  return steps;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool is_level(const Eigen::Vector2d& d) { return std::abs(d.x()) >= std::abs(d.y()); }

void mirror_rows(Corners& corners, int columns) {
  for (auto row = corners.begin(); row != corners.end(); row += columns) {
    std::reverse(row, row + columns);
  }
}

/// Scales and shifts points so that sums of their products are well conditioned.
Eigen::Matrix3d conditioner(const Corners& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  double spread = 0;
  for (const auto& p : points) spread += (p - mean).squaredNorm();
  const double s = std::sqrt(2.0 * static_cast<double>(points.size()) / std::max(spread, 1e-300));
  return (Eigen::Matrix3d() << s, 0, -s * mean.x(), 0, s, -s * mean.y(), 0, 0, 1).finished();
}

/// Adds a a' to the normal matrix.
void add_row(Eigen::MatrixXd& normal, const std::array<double, 9>& a) {
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      normal(i, j) += a[static_cast<std::size_t>(i)] * a[static_cast<std::size_t>(j)];
    }
  }
}

Corners grid_points(const BoardSpec& spec) {
  Corners points;
  for (int r = 0; r < spec.rows; ++r) {
    for (int c = 0; c < spec.columns; ++c) points.emplace_back(c, r);
  }
  return points;
}

}  // namespace

Corners in_order(Corners corners, const BoardSpec& spec) {
  const Steps found = mean_steps(corners, spec.rows, spec.columns);
  if (spec.rows == spec.columns && !is_level(found.along_row)) {
    corners = transposed(corners, spec);
  }
  const Steps steps = mean_steps(corners, spec.rows, spec.columns);
  if (cross(steps.along_row, steps.along_column) < 0) mirror_rows(corners, spec.columns);
  const Eigen::Vector2d x = mean_steps(corners, spec.rows, spec.columns).along_row;
  if ((is_level(x) ? x.x() : x.y()) < 0) std::reverse(corners.begin(), corners.end());
  return corners;
}

Corners transposed(const Corners& corners, const BoardSpec& spec) {
  Corners out;
  out.reserve(corners.size());
  for (int c = 0; c < spec.columns; ++c) {
    for (int r = 0; r < spec.rows; ++r) {
      out.push_back(corners[static_cast<std::size_t>(r * spec.columns + c)]);
    }
  }
  return out;
}

double corner_sigma(const Corners& corners, const BoardSpec& spec) {
  double sum = 0;
  std::size_t count = 0;
  const auto add = [&](std::size_t first, std::size_t step) {
    const Eigen::Vector2d third = corners[first + 3 * step] - corners[first] +
                                  3 * (corners[first + step] - corners[first + 2 * step]);
    sum += third.squaredNorm();
    count += 2;
  };
  const auto columns = static_cast<std::size_t>(spec.columns);
  const auto rows = static_cast<std::size_t>(spec.rows);
  if (columns < 4 || rows < 4) return std::numeric_limits<double>::quiet_NaN();
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      if (c + 3 < columns) add(r * columns + c, 1);
      if (r + 3 < rows) add(r * columns + c, columns);
    }
  }
  // The coefficients 1, 3, 3, 1 of a third difference, squared and summed, are 20.
  return std::sqrt(sum / (20.0 * static_cast<double>(count)));
}

double shortest_side(const Corners& corners, const BoardSpec& spec) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int r = 0; r < spec.rows; ++r) {
    for (int c = 0; c < spec.columns; ++c) {
      const auto i = static_cast<std::size_t>(r * spec.columns + c);
      const auto next_row = i + static_cast<std::size_t>(spec.columns);
      if (c + 1 < spec.columns) shortest = std::min(shortest, (corners[i + 1] - corners[i]).norm());
      if (r + 1 < spec.rows) shortest = std::min(shortest, (corners[next_row] - corners[i]).norm());
    }
  }
  return shortest;
}

Eigen::Matrix3d grid_homography(const Corners& corners, const BoardSpec& spec) {
  const Corners grid = grid_points(spec);
  const Eigen::Matrix3d to_px = conditioner(corners), to_grid = conditioner(grid);
  // Each corner gives two rows of A h = 0; h is the eigenvector of A'A of the smallest eigenvalue.
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(9, 9);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Eigen::Vector3d g = to_grid * grid[i].homogeneous();
    const Eigen::Vector3d p = to_px * corners[i].homogeneous();
    add_row(normal, {g.x(), g.y(), g.z(), 0, 0, 0, -p.x() * g.x(), -p.x() * g.y(), -p.x() * g.z()});
    add_row(normal, {0, 0, 0, g.x(), g.y(), g.z(), -p.y() * g.x(), -p.y() * g.y(), -p.y() * g.z()});
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(normal);
  const auto h = solver.eigenvectors().col(0);
  Eigen::Matrix3d inner;
  inner << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  Eigen::Matrix3d whole = to_px.inverse() * inner * to_grid;
  return whole / whole(2, 2);
}

bool is_flat_grid(const Corners& corners, const BoardSpec& spec) {
  for (const auto& corner : corners) {
    if (!corner.allFinite()) return false;
  }
  const double side = shortest_side(corners, spec);
  if (!(side > 1)) return false;
  const Eigen::Matrix3d h = grid_homography(corners, spec);
  const Corners grid = grid_points(spec);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double off = (mapped(h, grid[i]) - corners[i]).norm();
    if (!(off < std::max(0.25 * side, 1.0))) return false;
  }
  return true;
}

Corners grid_outline(const Eigen::Matrix3d& px_from_squares, const BoardSpec& spec, double margin) {
  const double right = spec.columns - 1 + margin, low = spec.rows - 1 + margin;
  return {mapped(px_from_squares, {-margin, -margin}), mapped(px_from_squares, {right, -margin}),
          mapped(px_from_squares, {right, low}), mapped(px_from_squares, {-margin, low})};
}

}  // namespace scanfuse::camera
