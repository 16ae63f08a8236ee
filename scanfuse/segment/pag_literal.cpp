#include "scanfuse/segment/pag_literal.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::segment {

double pag_min_points(double points, double occupied_cells, double fullest_cell) {
  if (!(occupied_cells > 0)) return 0;
  const double c = points / occupied_cells;
  const int n = static_cast<int>(std::floor(std::sqrt(fullest_cell)));
  if (n < 2) return c;
  double sum_a = 0, sum_b = 0;
  for (int i = 0; i < n; ++i) {
    const double a = fullest_cell - static_cast<double>(i) * n;
    sum_a += a;
    if (i > 0) sum_b += (a + (a + n)) / 2;
  }
  return sum_a > 0 ? (sum_b / (n - 1)) / (sum_a / n) * c : c;
}

const Clusters& PagLiteral::operator()(const VirtualScan& scan) {
  fill_cells(scan);
  mark_cells();
  join_cells();
  labels_.resize(scan.points.size());
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const std::uint32_t cell = cell_of_[i];
    labels_[i] = kept_[cell] ? sets_.find(cell) : Gatherer::kNoise;
  }
  return gather_(labels_, counts_.size(), options_.min_points);
}

void PagLiteral::fill_cells(const VirtualScan& scan) {
  const auto& points = scan.points;
  side_ = std::max(1, static_cast<std::int32_t>(std::sqrt(static_cast<double>(points.size()))));
  counts_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0);
  cell_of_.resize(points.size());
  if (points.empty()) return;
  double low_x = points[0].x_m, high_x = low_x, low_y = points[0].y_m, high_y = low_y;
  for (const PlanarPoint& p : points) {
    low_x = std::min<double>(low_x, p.x_m);
    high_x = std::max<double>(high_x, p.x_m);
    low_y = std::min<double>(low_y, p.y_m);
    high_y = std::max<double>(high_y, p.y_m);
  }
  const auto slot = [this](double value, double low, double high) {
    const double share = high > low ? (value - low) / (high - low) : 0;
    return static_cast<std::uint32_t>(std::clamp(share * side_, 0.0, side_ - 1.0));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    cell_of_[i] = slot(points[i].y_m, low_y, high_y) * static_cast<std::uint32_t>(side_) +
                  slot(points[i].x_m, low_x, high_x);
    ++counts_[cell_of_[i]];
  }
}

template <class Visit>
void PagLiteral::for_neighbours(std::int32_t cell, Visit visit) const {
  const std::int32_t row = cell / side_, column = cell % side_;
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, side_ - 1); ++r) {
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, side_ - 1); ++c) {
      const bool corner = r != row && c != column;
      if ((r == row && c == column) || (corner && !options_.eight_neighbours)) continue;
      visit(static_cast<std::uint32_t>(r * side_ + c));
    }
  }
}

void PagLiteral::mark_cells() {
  std::uint32_t fullest = 0, occupied = 0;
  for (const std::uint32_t count : counts_) {
    fullest = std::max(fullest, count);
    occupied += count > 0;
  }
  const double min_points = pag_min_points(static_cast<double>(cell_of_.size()), occupied, fullest);
  dense_.resize(counts_.size());
  kept_.resize(counts_.size());
  for (std::size_t i = 0; i < counts_.size(); ++i) dense_[i] = counts_[i] > min_points;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    kept_[i] = dense_[i];
    if (kept_[i] || counts_[i] == 0) continue;
    for_neighbours(static_cast<std::int32_t>(i),
                   [&](std::uint32_t other) { kept_[i] |= dense_[other]; });
  }
}

void PagLiteral::join_cells() {
  sets_.reset(counts_.size());
  for (std::uint32_t i = 0; i < counts_.size(); ++i) {
    if (!kept_[i]) continue;
    for_neighbours(static_cast<std::int32_t>(i), [&](std::uint32_t other) {
      if (other < i && kept_[other]) sets_.join(i, other);
    });
  }
}

}  // namespace scanfuse::segment
