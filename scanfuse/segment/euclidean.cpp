#include "scanfuse/segment/euclidean.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scanfuse::segment {
namespace {

constexpr std::uint32_t kFew = 16;  ///< points whose pairs are all looked at

/// Least and greatest distance between two intervals.
std::pair<double, double> apart(float a_low, float a_high, float b_low, float b_high) {
  const double gap =
      std::max({static_cast<double>(b_low) - a_high, static_cast<double>(a_low) - b_high, 0.0});
  const double span =
      std::max(static_cast<double>(b_high) - a_low, static_cast<double>(a_high) - b_low);
  return {gap, span};
}

}  // namespace

const Clusters& Euclidean::operator()(const VirtualScan& scan) {
  sort_into_cells(scan);
  sets_.reset(table_.size());
  nodes_.clear();
  roots_.assign(table_.size(), CellTable::kNone);
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

bool Euclidean::near(const VirtualScan& scan, std::uint32_t a, std::uint32_t b) {
  const Node node_a = cell_node(a), node_b = cell_node(b);
  if (node_a.size() <= kFew && node_b.size() <= kFew) return any_near(scan, node_a, node_b);
  return near_by_boxes(scan, a, b);
}

/// Boxes wholly out of reach of each other, or wholly within it, need no look at their points.
bool Euclidean::near_by_boxes(const VirtualScan& scan, std::uint32_t a, std::uint32_t b) {
  const double squared = options_.radius_m * options_.radius_m;
  open_.assign(1, {root_of(scan, a), root_of(scan, b)});
  while (!open_.empty()) {
    auto [i, j] = open_.back();
    open_.pop_back();
    const Node p = nodes_[i], q = nodes_[j];
    const auto [gap_x, span_x] = apart(p.x_low, p.x_high, q.x_low, q.x_high);
    const auto [gap_y, span_y] = apart(p.y_low, p.y_high, q.y_low, q.y_high);
    if (gap_x * gap_x + gap_y * gap_y > squared) continue;
    if (span_x * span_x + span_y * span_y <= squared) return true;
    if (p.size() <= kFew && q.size() <= kFew) {
      if (any_near(scan, p, q)) return true;
      continue;
    }
    const bool split_first = q.size() <= kFew || (p.size() > kFew && p.reach() >= q.reach());
    if (!split_first) std::swap(i, j);
    const std::uint32_t half = halves_of(scan, i);
    open_.emplace_back(half, j);
    open_.emplace_back(half + 1, j);
  }
  return false;
}

bool Euclidean::any_near(const VirtualScan& scan, const Node& a, const Node& b) const {
  const double squared = options_.radius_m * options_.radius_m;
  for (std::uint32_t i = a.begin; i < a.end; ++i) {
    const PlanarPoint& p = scan.points[order_[i]];
    for (std::uint32_t j = b.begin; j < b.end; ++j) {
      const PlanarPoint& q = scan.points[order_[j]];
      const double dx = static_cast<double>(p.x_m) - q.x_m, dy = static_cast<double>(p.y_m) - q.y_m;
      if (dx * dx + dy * dy <= squared) return true;
    }
  }
  return false;
}

Euclidean::Node Euclidean::cell_node(std::uint32_t cell) const {
  return {0, 0, 0, 0, cell == 0 ? 0 : ends_[cell - 1], ends_[cell], CellTable::kNone};
}

std::uint32_t Euclidean::root_of(const VirtualScan& scan, std::uint32_t cell) {
  if (roots_[cell] == CellTable::kNone) {
    const Node whole = cell_node(cell);
    roots_[cell] = add_node(scan, whole.begin, whole.end);
  }
  return roots_[cell];
}

std::uint32_t Euclidean::add_node(const VirtualScan& scan, std::uint32_t begin, std::uint32_t end) {
  const PlanarPoint& first = scan.points[order_[begin]];
  Node node{first.x_m, first.x_m, first.y_m, first.y_m, begin, end, CellTable::kNone};
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    const PlanarPoint& p = scan.points[order_[i]];
    node.x_low = std::min(node.x_low, p.x_m);
    node.x_high = std::max(node.x_high, p.x_m);
    node.y_low = std::min(node.y_low, p.y_m);
    node.y_high = std::max(node.y_high, p.y_m);
  }
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// Halves of as many points each, cut across the longer side.
std::uint32_t Euclidean::halves_of(const VirtualScan& scan, std::uint32_t index) {
  if (nodes_[index].left != CellTable::kNone) return nodes_[index].left;
  const Node node = nodes_[index];
  const auto axis =
      node.x_high - node.x_low >= node.y_high - node.y_low ? &PlanarPoint::x_m : &PlanarPoint::y_m;
  const std::uint32_t middle = node.begin + node.size() / 2;
  const auto place = [&](std::uint32_t i) {
    return order_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::nth_element(place(node.begin), place(middle), place(node.end),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return scan.points[a].*axis < scan.points[b].*axis;
                   });
  const std::uint32_t left = add_node(scan, node.begin, middle);
  add_node(scan, middle, node.end);
  nodes_[index].left = left;
  return left;
}

}  // namespace scanfuse::segment
