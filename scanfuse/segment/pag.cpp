#include "scanfuse/segment/pag.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/segment/pag_literal.hpp"

namespace scanfuse::segment {

const Clusters& Pag::operator()(const VirtualScan& scan) {
  const auto& points = scan.points;
  table_.reset(points.size());
  weights_.clear();
  cell_of_.clear();
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
  return gather_(labels_, table_.size(), options_.min_points);
}

void Pag::place(CellTable::Cell cell, float weight) {
  const std::uint32_t number = table_.insert(cell);
  if (number == weights_.size()) weights_.push_back(0);
  weights_[number] += weight;
  cell_of_.push_back(number);
}

void Pag::fill_rings(const VirtualScan& scan) {
  const double growth = std::clamp(2 * scan.step_rad, options_.growth, 0.5);
  rings_.lay_out({options_.cell_m, growth, options_.depth, options_.range_max_m});
  const auto limit = static_cast<float>(options_.range_max_m);
  for (const PlanarPoint& p : scan.points) {
    if (p.range_m < limit) {
      place(rings_.cell(p.range_m, p.bearing_rad), 1);
    } else {
      cell_of_.push_back(CellTable::kNone);
    }
  }
}

void Pag::fill_squares(const VirtualScan& scan) {
  const auto limit = static_cast<float>(options_.range_max_m);
  const double size = square_size(scan);
  for (const PlanarPoint& p : scan.points) {
    if (p.range_m < limit) {
      place({cell_index(p.y_m, size), cell_index(p.x_m, size)},
            std::clamp(p.range_m / 15.0F, 0.3F, 5.0F));
    } else {
      cell_of_.push_back(CellTable::kNone);
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
void Pag::for_later_neighbours(std::uint32_t cell, Visit visit) const {
  const CellTable::Cell here = table_[cell];
  const auto look = [&](CellTable::Cell other) {
    const std::uint32_t number = table_.find(other);
    if (number != CellTable::kNone && number != cell) visit(number);
  };
  if (options_.cells == PagCells::kGrowing) {
    rings_.for_later_neighbours(here, look);
    return;
  }
  look({here.row, here.column + 1});
  for (std::int32_t column = here.column - 1; column <= here.column + 1; ++column) {
    look({here.row + 1, column});
  }
}

/// Dense neighbours join; a low cell is offered each of its dense neighbours.
void Pag::join_dense() {
  sets_.reset(table_.size());
  owners_.assign(table_.size(), CellTable::kNone);
  for (std::uint32_t i = 0; i < table_.size(); ++i) {
    for_later_neighbours(i, [&](std::uint32_t other) {
      if (dense_[i] && dense_[other]) {
        sets_.join(i, other);
      } else if (dense_[i]) {
        offer(other, i);
      } else if (dense_[other]) {
        offer(i, other);
      }
    });
  }
}

void Pag::offer(std::uint32_t low, std::uint32_t dense) {
  std::uint32_t& owner = owners_[low];
  const bool better = owner == CellTable::kNone || weights_[dense] > weights_[owner] ||
                      (weights_[dense] == weights_[owner] && dense < owner);
  if (better) owner = dense;
}

void Pag::absorb_low() {
  for (std::uint32_t i = 0; i < table_.size(); ++i) {
    const std::uint32_t owner = dense_[i] ? i : owners_[i];
    owners_[i] = owner == CellTable::kNone ? Gatherer::kNoise : sets_.find(owner);
  }
}

}  // namespace scanfuse::segment
