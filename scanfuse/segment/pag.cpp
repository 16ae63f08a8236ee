#include "scanfuse/segment/pag.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/segment/pag_literal.hpp"

namespace scanfuse::segment {

const Clusters& Pag::operator()(const VirtualScan& scan) {
  const auto& points = scan.points;
  weights_.clear();
  cell_of_.assign(points.size(), CellTable::kNone);
  if (options_.cells == PagCells::kGrowing) {
    fill_rings(scan);
  } else {
    fill_squares(scan);
  }
  mark_dense();
  join_dense();
  absorb_low();
  labels_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    labels_[i] = cell_of_[i] == CellTable::kNone ? Gatherer::kNoise : owners_[cell_of_[i]];
  }
  const Clusters& whole = gather_(labels_, weights_.size(), options_.min_points);
  return cut_(scan, whole, options_.notch_m, options_.min_points);
}

void Pag::place(std::size_t point, std::uint32_t cell, float weight) {
  if (cell == weights_.size()) weights_.push_back(0);
  weights_[cell] += weight;
  cell_of_[point] = cell;
}

void Pag::fill_rings(const VirtualScan& scan) {
  const double growth = std::clamp(2 * scan.step_rad, options_.growth, 0.5);
  rings_.lay_out({options_.cell_m, growth, options_.depth, options_.range_max_m});
  ring_cells_.reset(static_cast<std::size_t>(rings_.rings()));
  const auto limit = static_cast<float>(options_.range_max_m);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const PlanarPoint& p = scan.points[i];
    if (p.range_m < limit) {
      place(i, ring_cells_.insert(rings_.cell(p.range_m, p.bearing_rad)), 1);
    }
  }
}

void Pag::fill_squares(const VirtualScan& scan) {
  const auto limit = static_cast<float>(options_.range_max_m);
  const double size = square_size(scan);
  table_.reset(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const PlanarPoint& p = scan.points[i];
    if (p.range_m < limit) {
      place(i, table_.insert({cell_index(p.y_m, size), cell_index(p.x_m, size)}),
            std::clamp(p.range_m / 15.0F, 0.3F, 5.0F));
    }
  }
}

double Pag::square_size(const VirtualScan& scan) {
  const auto limit = static_cast<float>(options_.range_max_m);
  double area = 1;
  std::size_t count = 0;
  for (float PlanarPoint::* axis : {&PlanarPoint::x_m, &PlanarPoint::y_m}) {
    sorted_.clear();
    for (const PlanarPoint& p : scan.points) {
      if (p.range_m < limit) sorted_.push_back(p.*axis);
    }
    count = sorted_.size();
    if (count == 0) return options_.square_cap_m;
    const auto low = sorted_.begin() + static_cast<std::ptrdiff_t>(count / 100);
    const auto high = sorted_.begin() + static_cast<std::ptrdiff_t>(count - 1 - count / 100);
    std::nth_element(sorted_.begin(), low, sorted_.end());
    const double least = *low;
    std::nth_element(sorted_.begin(), high, sorted_.end());
    area *= *high - least;
  }
  const double k = std::max(1.0, std::floor(std::sqrt(static_cast<double>(count))));
  const double size = std::sqrt(std::max(area, 0.0)) / k;
  return std::clamp(size, std::min(0.1, options_.square_cap_m), options_.square_cap_m);
}

void Pag::mark_dense() {
  float fullest = 0;
  double sum = 0;
  for (const float weight : weights_) {
    fullest = std::max(fullest, weight);
    sum += weight;
  }
  const double threshold =
      options_.density * pag_min_points(sum, static_cast<double>(weights_.size()), fullest);
  const bool none_exceeds = !(fullest > threshold);
  dense_.resize(weights_.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    // Sums of equal weights may differ in the last bit: "reaches" is meant with that slack.
    dense_[i] = none_exceeds ? weights_[i] >= 0.9999 * threshold : weights_[i] > threshold;
  }
}

template <class Visit>
void Pag::for_square_neighbours(Visit visit) const {
  for (std::uint32_t i = 0; i < table_.size(); ++i) {
    const auto [row, column] = table_[i];
    for (const CellTable::Cell other : {CellTable::Cell{row, column + 1},
                                        {row + 1, column - 1},
                                        {row + 1, column},
                                        {row + 1, column + 1}}) {
      if (const auto j = table_.find(other); j != CellTable::kNone) visit(i, j);
    }
  }
}

void Pag::join_dense() {
  sets_.reset(weights_.size());
  owners_.assign(weights_.size(), CellTable::kNone);
  const auto visit = [this](std::uint32_t a, std::uint32_t b) { relate(a, b); };
  if (options_.cells == PagCells::kGrowing) {
    ring_cells_.for_neighbours(rings_, visit);
  } else {
    for_square_neighbours(visit);
  }
}

/// Dense neighbours join; a low cell is offered each of its dense neighbours.
void Pag::relate(std::uint32_t a, std::uint32_t b) {
  if (dense_[a] && dense_[b]) {
    sets_.join(a, b);
  } else if (dense_[a]) {
    offer(b, a);
  } else if (dense_[b]) {
    offer(a, b);
  }
}

void Pag::offer(std::uint32_t low, std::uint32_t dense) {
  std::uint32_t& owner = owners_[low];
  const bool better = owner == CellTable::kNone || weights_[dense] > weights_[owner] ||
                      (weights_[dense] == weights_[owner] && dense < owner);
  if (better) owner = dense;
}

void Pag::absorb_low() {
  for (std::uint32_t i = 0; i < weights_.size(); ++i) {
    const std::uint32_t owner = dense_[i] ? i : owners_[i];
    owners_[i] = owner == CellTable::kNone ? Gatherer::kNoise : sets_.find(owner);
  }
}

}  // namespace scanfuse::segment
