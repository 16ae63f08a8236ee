#include "scanfuse/segment/euclidean.hpp"

#include <cmath>
#include <numbers>

namespace scanfuse::segment {

const Clusters& Euclidean::operator()(const VirtualScan& scan) {
  sort_into_cells(scan);
  sets_.reset(table_.size());
  for (std::uint32_t i = 0; i < table_.size(); ++i) {
    const CellTable::Cell cell = table_[i];
    for (std::int32_t row = cell.row - 2; row <= cell.row; ++row) {
      const std::int32_t last = row == cell.row ? cell.column - 1 : cell.column + 2;
      for (std::int32_t column = cell.column - 2; column <= last; ++column) {
        const std::uint32_t other = table_.find({row, column});
        if (other == CellTable::kNone || sets_.find(i) == sets_.find(other)) continue;
        if (near(scan, i, other)) sets_.join(i, other);
      }
    }
  }
  labels_.resize(scan.points.size());
  for (std::size_t i = 0; i < labels_.size(); ++i) labels_[i] = sets_.find(cell_of_[i]);
  return gather_(labels_, table_.size(), options_.min_points);
}

void Euclidean::sort_into_cells(const VirtualScan& scan) {
  const double size = options_.radius_m / std::numbers::sqrt2;
  table_.reset(scan.points.size());
  cell_of_.clear();
  ends_.clear();
  for (const PlanarPoint& p : scan.points) {
    const std::uint32_t cell = table_.insert({cell_index(p.y_m, size), cell_index(p.x_m, size)});
    if (cell == ends_.size()) ends_.push_back(0);
    ++ends_[cell];
    cell_of_.push_back(cell);
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& end : ends_) {
    const std::uint32_t count = end;
    end = sum;
    sum += count;
  }
  order_.resize(scan.points.size());
  for (std::uint32_t i = 0; i < cell_of_.size(); ++i) order_[ends_[cell_of_[i]]++] = i;
}

bool Euclidean::near(const VirtualScan& scan, std::uint32_t a, std::uint32_t b) const {
  const double squared = options_.radius_m * options_.radius_m;
  const std::uint32_t begin_a = a == 0 ? 0 : ends_[a - 1], begin_b = b == 0 ? 0 : ends_[b - 1];
  for (std::uint32_t i = begin_a; i < ends_[a]; ++i) {
    const PlanarPoint& p = scan.points[order_[i]];
    for (std::uint32_t j = begin_b; j < ends_[b]; ++j) {
      const PlanarPoint& q = scan.points[order_[j]];
      const double dx = static_cast<double>(p.x_m) - q.x_m, dy = static_cast<double>(p.y_m) - q.y_m;
      if (dx * dx + dy * dy <= squared) return true;
    }
  }
  return false;
}

}  // namespace scanfuse::segment
