#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "scanfuse/preprocess/virtual_scan_builder.hpp"

// The second half of VirtualScanBuilder: from points without ground to one point a bearing.
namespace scanfuse::preprocess {
namespace {

/// A return without support is ground below the first, and may be up to the second: m above flat
/// ground, and per metre of range.
constexpr float kGround = 0.05F, kGroundPerMetre = 0.003F;
constexpr float kLow = 0.3F, kLowPerMetre = 0.01F;
/// Low returns of one layer in a row that is no longer than this are an object: ground is wider.
constexpr float kLongestLow_m = 7;
constexpr int kFewestLow = 3;
constexpr std::int32_t kLowGap = 3;  ///< columns that a row may miss

float exact_bearing(float x, float y) {
  const float angle = std::atan2(y, x);
  return angle >= static_cast<float>(kPi) ? -static_cast<float>(kPi) : angle;
}

}  // namespace

std::uint32_t VirtualScanBuilder::column_by_bearing(const Scan& scan,
                                                    const LevelPoint& point) const {
  if (beams_.empty()) return layout_.at(point.bearing_rad);
  return layout_.at(beams_.bearing_of(point.x_m, point.y_m, scan.returns[point.source].beam));
}

/// By counting, so in one pass over the points; then each column by range.
void VirtualScanBuilder::sort_into_columns(const Scan& scan) {
  layout_ = beams_.empty() ? ColumnLayout(-kPi, virtual_scan_.step_rad) : beams_.layout();
  ends_.assign(layout_.last() + 1, 0);
  order_.resize(points_.size() + std::tuple_size_v<FewKeys>);  // sorted_few reads on
  const std::span ends(ends_);
  const std::span order(order_);
  for (LevelPoint& p : points_) {
    if (p.column == BeamBearings::kNoColumn) p.column = column_by_bearing(scan, p);
    ++ends[p.column];
  }
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), 0U);
  std::uint32_t index = 0;
  for (const LevelPoint& p : points_) order[ends[p.column]++] = RangeKey(p.range_m, index++);
}

VirtualScanBuilder::Support VirtualScanBuilder::support_of(std::span<const RangeKey> column) const {
  const float reach = column[0].range_m() + static_cast<float>(options_.support_m);
  std::uint64_t layers = 0;
  Support support = alone(points_[column[0].index()]);
  int count = 0, distinct = 0;
  for (const RangeKey key : column) {
    if (key.range_m() > reach) break;
    const LevelPoint& p = points_[key.index()];
    support.z_low_m = std::min(support.z_low_m, p.z_m);
    support.z_high_m = std::max(support.z_high_m, p.z_m);
    support.depth_m = key.range_m() - column[0].range_m();
    const int layer = p.layer & 63;
    distinct += (layers >> layer & 1) == 0 ? 1 : 0;
    layers |= 1ULL << layer;
    ++count;
  }
  support.layers = layered_ ? distinct : count;
  return support;
}

bool VirtualScanBuilder::is_lonely_ground(const LevelPoint& point, GroundMethod method) const {
  if (method != GroundMethod::kLayers) return false;
  if (point.layer == lowest_layer_) return true;
  return height_m(point.z_m) < kGround + kGroundPerMetre * point.range_m;
}

/// Above flat ground; where the mounting is not known, nothing is low.
float VirtualScanBuilder::height_m(float z_m) const {
  return sensor_height_m_ ? z_m + static_cast<float>(*sensor_height_m_)
                          : std::numeric_limits<float>::infinity();
}

bool VirtualScanBuilder::may_be_ground(const PlanarPoint& point) const {
  return point.support <= 1 && height_m(point.z_m) < kLow + kLowPerMetre * point.range_m;
}

/// Where one layer alone meets something low, its neighbours in bearing tell: the ground goes on
/// for longer than a vehicle is, and stray returns from it stand alone. At the edges of a view that
/// fewer layers reach, whole vehicles are seen by one.
void VirtualScanBuilder::drop_low_rows(GroundMethod method) {
  if (method != GroundMethod::kLayers || !sensor_height_m_) return;
  auto& points = virtual_scan_.points;
  std::size_t kept = 0;
  row_.clear();
  const auto close_row = [&] {
    if (row_.empty()) return;
    const PlanarPoint &a = points[row_.front()], &b = points[row_.back()];
    const bool is_object =
        std::ssize(row_) >= kFewestLow && std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) <= kLongestLow_m;
    for (const std::size_t i : row_) keep_[i] = is_object;
    row_.clear();
  };
  keep_.assign(points.size(), 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!may_be_ground(points[i])) continue;
    if (!row_.empty() && !goes_on(points[row_.back()], points[i])) close_row();
    row_.push_back(i);
  }
  close_row();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep_[i]) points[kept++] = points[i];
  }
  points.resize(kept);
}

bool VirtualScanBuilder::goes_on(const PlanarPoint& row, const PlanarPoint& next) const {
  const float reach = static_cast<float>(options_.lonely_m + options_.lonely_per_m * row.range_m);
  return next.column - row.column <= kLowGap &&
         std::hypot(next.x_m - row.x_m, next.y_m - row.y_m) <= reach;
}

void VirtualScanBuilder::pick_points(const Scan& scan, GroundMethod method) {
  const bool one_layer = !layered_ && method != GroundMethod::kGrid;
  const bool seen_over = !scan.beams || method == GroundMethod::kGrid;
  most_per_bearing_ = options_.points_per_bearing > 0 ? options_.points_per_bearing
                                                      : (seen_over && !one_layer ? 3 : 1);
  virtual_scan_.points.clear();
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends_) {
    const auto rest = std::span(order_).subspan(begin);
    const auto column = rest.first(end - begin);
    begin = end;
    if (column.empty()) continue;
    if (one_layer && most_per_bearing_ == 1) {
      const LevelPoint& nearest = points_[std::ranges::min(column).index()];
      emit(scan, nearest, alone(nearest));
    } else if (FewKeys few; column.size() <= few.size()) {
      few = sorted_few(rest, column.size());
      pick_column(scan, std::span(few).first(column.size()), method);
    } else {
      std::ranges::sort(column);
      pick_column(scan, column, method);
    }
  }
}

/// `column`: the returns of one bearing by range. What lies behind a gap of separation_m may be
/// another object; of each such group the nearest supported return is kept. Where layers are few,
/// one of them alone may look over what stands in front: there a group without support gives its
/// nearest return that is not ground, for its neighbours in bearing to support.
void VirtualScanBuilder::pick_column(const Scan& scan, std::span<const RangeKey> column,
                                     GroundMethod method) {
  const auto separation = static_cast<float>(options_.separation_m);
  const bool each_group = method == GroundMethod::kLayers && most_per_bearing_ > 1;
  const LevelPoint* lonely = nullptr;
  int kept = 0;
  bool group_done = false;
  const auto keep = [&](const LevelPoint& p, const Support& support) {
    if (kept >= most_per_bearing_) return;
    emit(scan, p, support);
    ++kept;
  };
  for (std::size_t i = 0; i < column.size() && kept < most_per_bearing_; ++i) {
    if (i > 0 && column[i].range_m() - column[i - 1].range_m() > separation) {
      if (each_group && lonely != nullptr) {
        const LevelPoint& last = *std::exchange(lonely, nullptr);
        keep(last, alone(last));
      }
      group_done = false;
    }
    if (group_done) continue;
    const LevelPoint& p = points_[column[i].index()];
    const Support support = support_of(column.subspan(i));
    if (support.layers > 1) {
      keep(p, support);
      group_done = true;
      if (each_group) lonely = nullptr;
    } else if (lonely == nullptr && !is_lonely_ground(p, method)) {
      lonely = &p;
    }
  }
  if (lonely != nullptr && (each_group || kept == 0)) keep(*lonely, alone(*lonely));
}

void VirtualScanBuilder::emit(const Scan& scan, const LevelPoint& point, const Support& support) {
  const Return& r = scan.returns[point.source];
  constexpr float kLongestSweep_s = 60;  // what claims more, or is no number, is not known
  const float offset = std::abs(r.time_offset_s) < kLongestSweep_s ? r.time_offset_s : 0;
  const float angle = beams_.empty() ? exact_bearing(point.x_m, point.y_m)
                                     : beams_.bearing_of(point.x_m, point.y_m, r.beam);
  virtual_scan_.points.push_back({point.x_m, point.y_m, point.z_m, point.range_m, angle, offset,
                                  static_cast<std::int32_t>(point.column), point.source,
                                  static_cast<std::uint8_t>(std::min(support.layers, 255)),
                                  support.z_low_m, support.z_high_m, support.depth_m});
}

void VirtualScanBuilder::order_by_bearing() {
  const auto before = [](const PlanarPoint& a, const PlanarPoint& b) {
    return a.bearing_rad < b.bearing_rad || (a.bearing_rad == b.bearing_rad && a.source < b.source);
  };
  // Columns are in order already; only bearings at a column's edge may differ in the last digits.
  auto& points = virtual_scan_.points;
  if (!std::ranges::is_sorted(points, before)) std::ranges::sort(points, before);
}

void VirtualScanBuilder::drop_lonely() {
  if (options_.lonely_m <= 0) return;
  constexpr std::size_t kBeside = 3;
  auto& points = virtual_scan_.points;
  const std::size_t n = points.size();
  const auto base = static_cast<float>(options_.lonely_m);
  const auto slope = static_cast<float>(options_.lonely_per_m);
  keep_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const PlanarPoint& p = points[i];
    keep_[i] |= p.support > 1;
    const float reach = base + slope * p.range_m, reach2 = reach * reach;
    for (std::size_t k = 1; k <= kBeside && k < n; ++k) {
      const std::size_t j = i + k < n ? i + k : i + k - n;
      const float dx = p.x_m - points[j].x_m, dy = p.y_m - points[j].y_m;
      if (dx * dx + dy * dy > reach2) continue;
      keep_[i] = keep_[j] = 1;
      break;
    }
  }
  std::size_t kept = static_cast<std::size_t>(std::ranges::find(keep_, 0) - keep_.begin());
  for (std::size_t i = kept; i < n; ++i) {
    if (keep_[i]) points[kept++] = points[i];
  }
  points.resize(kept);
}

}  // namespace scanfuse::preprocess
