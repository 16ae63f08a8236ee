#include "scanfuse/preprocess/spatio_temporal.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::preprocess {
namespace {

constexpr int kMostLayers = 128, kMostColumns = 1 << 16, kBeams = 2;
constexpr std::size_t kMostSensors = 16;
constexpr double kUsualStep = radians(0.25);
constexpr Duration kLongestGap = std::chrono::milliseconds(500);
constexpr float kFullTurn = static_cast<float>(2 * kPi);

float range_of(const Return& r) { return std::sqrt(r.squared_range()); }

bool is_usable(const BeamPattern& pattern) {
  return pattern.columns > 0 && pattern.columns <= kMostColumns &&
         std::isfinite(pattern.first_azimuth_rad) && pattern.step_rad > 1e-5 &&
         pattern.step_rad < 1;
}

}  // namespace

void BeamGrid::fill(const Scan& scan) {
  has_pattern_ = scan.beams && is_usable(*scan.beams);
  const double step = has_pattern_ ? scan.beams->step_rad : kUsualStep;
  columns_ = has_pattern_ ? scan.beams->columns : static_cast<int>(std::ceil(2 * kPi / step));
  full_circle_ = (columns_ + 0.5) * step >= 2 * kPi;
  first_rad_ = static_cast<float>(has_pattern_ ? scan.beams->first_azimuth_rad : -kPi);
  per_step_ = static_cast<float>(1 / step);
  int highest = 0;
  for (const Return& r : scan.returns) highest = std::max<int>(highest, r.layer);
  layers_ = std::min(highest + 1, kMostLayers);
  heads_.assign(static_cast<std::size_t>(layers_) * static_cast<std::size_t>(columns_), -1);
  entries_.resize(scan.returns.size());
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    const auto [column, layer] = cell_of(scan.returns[i]);
    auto& head = heads_[place_of(layer, column)];
    entries_[i] = {range_of(scan.returns[i]), head};
    head = static_cast<std::int32_t>(i);
  }
}

BeamGrid::Cell BeamGrid::cell_of(const Return& r) const {
  if (!has_pattern_ || r.beam < 0 || r.beam >= columns_) return cell_at(r.x_m, r.y_m, r.layer);
  return {r.beam, std::clamp<int>(r.layer, 0, layers_ - 1)};
}

BeamGrid::Cell BeamGrid::cell_at(float x_m, float y_m, int layer) const {
  float along = std::atan2(y_m, x_m) - first_rad_;
  along -= kFullTurn * std::floor(along / kFullTurn);
  if (!(along >= 0)) along = 0;
  // A little before the first beam is the first beam's, not the last one's.
  if (!full_circle_ && along > kFullTurn - 2.5F / per_step_) along = 0;
  const int column = static_cast<int>(along * per_step_ + 0.5F);
  return {column < columns_ ? column : (full_circle_ ? column % columns_ : columns_ - 1),
          std::clamp(layer, 0, layers_ - 1)};
}

template <class Visit>
bool BeamGrid::visit_cell(int layer, int column, Visit& visit) const {
  if (column < 0 || column >= columns_) {
    if (!full_circle_ || columns_ <= 2 * kBeams) return true;
    column += column < 0 ? columns_ : -columns_;
  }
  std::int32_t i = heads_[place_of(layer, column)];
  for (; i >= 0; i = entries_[static_cast<std::size_t>(i)].next) {
    if (!visit(entries_[static_cast<std::size_t>(i)].range_m, static_cast<std::size_t>(i))) {
      return false;
    }
  }
  return true;
}

template <class Visit>
void BeamGrid::for_neighbours(Cell cell, bool own_cell, Visit&& visit) const {
  constexpr int kNearestFirst[] = {-1, 1, -2, 2};
  if (own_cell && !visit_cell(cell.layer, cell.column, visit)) return;
  for (const int d : kNearestFirst) {
    if (!visit_cell(cell.layer, cell.column + d, visit)) return;
  }
  for (const int layer : {cell.layer - 1, cell.layer + 1}) {
    if (layer < 0 || layer >= layers_) continue;
    if (!visit_cell(layer, cell.column, visit)) return;
    for (const int d : kNearestFirst) {
      if (!visit_cell(layer, cell.column + d, visit)) return;
    }
  }
}

const Scan& SpatioTemporalFilter::operator()(const Scan& scan, const Pose3& world_from_sensor) {
  if (options_.outliers == OutlierMethod::kNone) {
    return scan;  // NOLINT(bugprone-return-const-ref-from-parameter): as the header says
  }
  Before& last = before(scan);
  const Duration gap = scan.stamp - last.stamp;
  if (gap <= Duration::zero() || gap > kLongestGap) last.grid.clear();
  grid_.fill(scan);
  clean_.stamp = scan.stamp;
  clean_.frame = scan.frame;
  clean_.sensor = scan.sensor;
  clean_.frame_id = scan.frame_id;
  clean_.beams = scan.beams;
  clean_.returns.clear();
  if (options_.outliers == OutlierMethod::kSupported) {
    keep_supported(scan, last, world_from_sensor);
  } else {
    replace_by_median(scan, last, world_from_sensor);
  }
  remember(last, scan, world_from_sensor);
  return clean_;
}

SpatioTemporalFilter::Before& SpatioTemporalFilter::before(const Scan& scan) {
  for (Before& known : before_) {
    if (known.sensor == scan.sensor) return known;
  }
  if (before_.size() < kMostSensors) {
    before_.emplace_back().sensor = scan.sensor;
    return before_.back();
  }
  Before& oldest = before_[next_++ % kMostSensors];
  oldest.sensor = scan.sensor;
  oldest.grid.clear();
  return oldest;
}

void SpatioTemporalFilter::remember(Before& before, const Scan& scan,
                                    const Pose3& world_from_sensor) {
  before.stamp = scan.stamp;
  before.world_from_sensor = world_from_sensor;
  if (options_.outliers == OutlierMethod::kMedianReplace) {
    before.scan.returns = scan.returns;
    before.scan.beams = scan.beams;
  }
  std::swap(before.grid, grid_);
}

/// Whether two beams of the return's layer, to either side or both, are on one line with it. The
/// line's noise in range, several times the sensor's, may not pass the support asked elsewhere.
bool SpatioTemporalFilter::lies_on_line(const Scan& scan, std::size_t i) const {
  constexpr double kNoise = 3;
  const BeamGrid::Cell cell = grid_.cell_of(scan.returns[i]);
  double inverse[2 * kBeams + 1] = {};
  grid_.for_neighbours(cell, false, [&](float range, std::size_t j) {
    const BeamGrid::Cell other = grid_.cell_of(scan.returns[j]);
    const int d = other.column - cell.column;
    if (other.layer == cell.layer && std::abs(d) <= kBeams && range > 0) {
      inverse[d + kBeams] = 1 / static_cast<double>(range);
    }
    return true;
  });
  const double u = 1 / static_cast<double>(range_of(scan.returns[i]));
  const auto fits = [&](double a, double b, double c) {  // a, b, c one beam apart
    if (a <= 0 || b <= 0 || c <= 0) return false;
    const double off = a - 2 * b + c, sigma = kNoise * options_.sigma_range_m;
    return off * off <= sigma * sigma * (a * a * a * a + 4 * b * b * b * b + c * c * c * c);
  };
  return fits(inverse[1], u, inverse[3]) || fits(inverse[0], inverse[1], u) ||
         fits(u, inverse[3], inverse[4]);
}

void SpatioTemporalFilter::keep_supported(const Scan& scan, const Before& before,
                                          const Pose3& world_from_sensor) {
  const Pose3 before_from_now = before.world_from_sensor.inverse() * world_from_sensor;
  const Eigen::Matrix3f turn = before_from_now.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f shift = before_from_now.translation_m.cast<float>();
  const auto base = static_cast<float>(options_.outlier_support_m),
             slope = static_cast<float>(options_.outlier_support_per_m),
             relaxed = static_cast<float>(options_.outlier_relaxed_m);
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    const Return& r = scan.returns[i];
    const float range = range_of(r), reach = base + slope * range;
    const int wanted = range > relaxed ? 1 : 2;
    int found = 0;
    grid_.for_neighbours(grid_.cell_of(r), false, [&](float other, std::size_t) {
      found += std::abs(other - range) <= reach;
      return found < wanted;
    });
    if (found < wanted && (found > 0 || range > relaxed) && !before.grid.empty()) {
      const Eigen::Vector3f p = turn * Eigen::Vector3f(r.x_m, r.y_m, r.z_m) + shift;
      const float then = std::hypot(p.x(), p.y());
      bool seen = false;
      before.grid.for_neighbours(before.grid.cell_at(p.x(), p.y(), r.layer), true,
                                 [&](float other, std::size_t) {
                                   seen = std::abs(other - then) <= reach;
                                   return !seen;
                                 });
      found += seen;
    }
    if (found >= wanted || lies_on_line(scan, i)) clean_.returns.push_back(r);
  }
}

void SpatioTemporalFilter::replace_by_median(const Scan& scan, Before& before,
                                             const Pose3& world_from_sensor) {
  const BeamGrid* then = &before.grid;
  if (options_.median_compensated && !before.grid.empty()) {
    const Pose3 now_from_before = world_from_sensor.inverse() * before.world_from_sensor;
    moved_.beams = scan.beams;
    moved_.returns = before.scan.returns;
    for (Return& r : moved_.returns) {
      const Eigen::Vector3f p =
          (now_from_before * Eigen::Vector3d(r.x_m, r.y_m, r.z_m)).cast<float>();
      r.x_m = p.x(), r.y_m = p.y(), r.z_m = p.z(), r.beam = -1;
    }
    moved_grid_.fill(moved_);
    then = &moved_grid_;
  }
  for (const Return& r : scan.returns) {
    window_.clear();
    const auto take = [&](float range, std::size_t) {
      window_.push_back(range);
      return true;
    };
    grid_.for_neighbours(grid_.cell_of(r), true, take);
    if (!then->empty()) {
      auto cell = grid_.cell_of(r);
      if (options_.median_compensated) cell = then->cell_at(r.x_m, r.y_m, r.layer);
      then->for_neighbours(cell, true, take);
    }
    const auto middle = window_.begin() + static_cast<std::ptrdiff_t>(window_.size() / 2);
    std::nth_element(window_.begin(), middle, window_.end());
    const float range = range_of(r), factor = range > 0 ? *middle / range : 1;
    Return& out = clean_.returns.emplace_back(r);
    out.x_m *= factor, out.y_m *= factor, out.z_m *= factor;
  }
}

}  // namespace scanfuse::preprocess
