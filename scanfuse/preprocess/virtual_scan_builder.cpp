#include "scanfuse/preprocess/virtual_scan_builder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace scanfuse::preprocess {
namespace {

constexpr float kTurn = static_cast<float>(2 * kPi);
constexpr std::size_t kCloud = 5000;  // more returns than this with a spread of heights are a cloud
constexpr float kLowLonely = 0.3F;  // m above ground: a return without support is ground below this
constexpr float kLowLonelyPerMetre = 0.01F;

/// atan2 to 1e-5 rad, by a polynomial on the first octant.
float quick_bearing(float x, float y) {
  const float ax = std::abs(x), ay = std::abs(y);
  const float larger = std::max(ax, ay), smaller = std::min(ax, ay);
  const float a = larger > 0 ? smaller / larger : 0;
  const float s = a * a;
  float angle =
      a * (0.99997726F +
           s * (-0.33262347F +
                s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F - s * 0.01172120F)))));
  if (ay > ax) angle = kTurn / 4 - angle;
  if (x < 0) angle = kTurn / 2 - angle;
  return y < 0 ? -angle : angle;
}

/// The beam's direction and a small correction where the beam is known: any mounting, no atan2.
template <class Beams>
inline float bearing_by_beam(const Beams& beams, float x, float y, std::int32_t beam) {
  // A negative beam is a huge unsigned one.
  if (static_cast<std::uint32_t>(beam) >= beams.size()) return quick_bearing(x, y);
  const auto& b = beams[static_cast<std::uint32_t>(beam)];
  const float along = b.cosine * x + b.sine * y, across = b.cosine * y - b.sine * x;
  if (!(std::abs(across) < 0.1F * along)) return quick_bearing(x, y);
  const float d = across / along;
  const float angle = b.bearing_rad + d - d * d * d * (1.0F / 3);
  if (angle >= kTurn / 2) return angle - kTurn;
  return angle < -kTurn / 2 ? angle + kTurn : angle;
}

/// Rounds down; the library's function is a call.
inline std::int32_t floor_of(float value) {
  const auto truncated = static_cast<std::int32_t>(value);
  return truncated - (value < static_cast<float>(truncated) ? 1 : 0);
}

/// Ranges are positive, and the bits of positive floats are in order: by range, then by index.
inline std::uint64_t key_of(float range_m, std::uint32_t index) {
  return std::uint64_t{std::bit_cast<std::uint32_t>(range_m)} << 32 | index;
}
inline float range_of(std::uint64_t key) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
}
inline std::uint32_t index_of(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

/// Few-layer scanners have up to four returns of a bearing, in any order: exchanges without jumps,
/// for a processor cannot guess their outcome.
inline void sort_keys(std::span<std::uint64_t> keys) {
  const auto order = [&](std::size_t i, std::size_t j) {
    const std::uint64_t low = std::min(keys[i], keys[j]), high = std::max(keys[i], keys[j]);
    keys[i] = low;
    keys[j] = high;
  };
  switch (keys.size()) {
    case 0:
    case 1:
      return;
    case 2:
      return order(0, 1);
    case 3:
      return order(0, 1), order(1, 2), order(0, 1);
    case 4:
      return order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    default:
      std::ranges::sort(keys);
  }
}

float exact_bearing(float x, float y) {
  const float angle = std::atan2(y, x);
  return angle >= static_cast<float>(kPi) ? -static_cast<float>(kPi) : angle;
}

}  // namespace

const VirtualScan& VirtualScanBuilder::operator()(const Scan& scan, const Pose3& ego_from_sensor) {
  const double height = ego_from_sensor.translation_m.z();
  sensor_height_m_ = height > 0 ? std::optional(height) : std::nullopt;
  const Eigen::Matrix3f rotation = ego_from_sensor.rotation.toRotationMatrix().cast<float>();
  prepare_columns(scan, rotation);
  project(scan, rotation);
  const GroundMethod method = ground_method(scan);
  remove_ground(method, sensor_height_m_);

  virtual_scan_.points.clear();
  virtual_scan_.stamp = scan.stamp;
  virtual_scan_.frame = scan.frame;
  virtual_scan_.sigma_range_m = options_.sigma_range_m;
  virtual_scan_.step_rad = choose_step(scan);
  set_view();
  virtual_scan_.full_circle =
      !scan.beams || (scan.beams->columns + 0.5) * virtual_scan_.step_rad >= 2 * kPi;
  sort_into_columns(scan);
  pick_points(scan, method);
  order_by_bearing();
  drop_lonely();
  return virtual_scan_;
}

void VirtualScanBuilder::prepare_columns(const Scan& scan, const Eigen::Matrix3f& rotation) {
  constexpr int kMostColumns = 1 << 20;
  const bool known = scan.beams && scan.beams->columns > 0 && scan.beams->columns < kMostColumns &&
                     std::isfinite(scan.beams->first_azimuth_rad) && scan.beams->step_rad > 0 &&
                     scan.beams->step_rad < 1;
  if (!known) {
    beams_.clear();
    return;
  }
  const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
  const double first = wrap_pi(scan.beams->first_azimuth_rad + yaw);
  const double step = scan.beams->step_rad;
  const auto columns = static_cast<std::size_t>(scan.beams->columns);
  if (beams_.size() == columns && beams_first_rad_ == first && beams_step_rad_ == step) return;
  beams_first_rad_ = first;
  beams_step_rad_ = step;
  beams_.resize(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const double angle = wrap_pi(first + static_cast<double>(i) * step);
    beams_[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                 static_cast<float>(angle)};
  }
}

void VirtualScanBuilder::project(const Scan& scan, const Eigen::Matrix3f& rotation) {
  const bool turned = !rotation.isIdentity(0);
  const auto near2 = static_cast<float>(options_.range_min_m * options_.range_min_m);
  const auto far2 = static_cast<float>(options_.range_max_m * options_.range_max_m);
  const auto x_min = static_cast<float>(options_.x_min_m),
             x_max = static_cast<float>(options_.x_max_m);
  const auto y_min = static_cast<float>(options_.y_min_m),
             y_max = static_cast<float>(options_.y_max_m);
  const std::span<const BeamDirection> beams(beams_);
  std::int16_t lowest = 32767, highest = -32768;
  points_.resize(scan.returns.size());
  LevelPoint* const out = points_.data();
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < scan.returns.size(); ++i) {
    const Return& r = scan.returns[i];
    float x = r.x_m, y = r.y_m, z = r.z_m;
    if (turned) {
      const Eigen::Vector3f p = rotation * Eigen::Vector3f(x, y, z);
      x = p.x(), y = p.y(), z = p.z();
    }
    const float range2 = x * x + y * y;
    const bool in_reach = (range2 >= near2) & (range2 <= far2) & (range2 > 0);
    const bool in_region = (x >= x_min) & (x <= x_max) & (y >= y_min) & (y <= y_max);
    if (!(in_reach & in_region) || !std::isfinite(z)) continue;
    const float angle = bearing_by_beam(beams, x, y, r.beam);
    out[kept++] = {x, y, z, std::sqrt(range2), angle, i, 0, r.layer};
    lowest = std::min(lowest, r.layer);
    highest = std::max(highest, r.layer);
  }
  points_.resize(kept);
  lowest_layer_ = lowest;
  if (scan.beams && scan.beams->layers > 1) {
    lowest_layer_ = 0;
    highest = std::max(highest, static_cast<std::int16_t>(std::min(scan.beams->layers - 1, 32767)));
  }
  layered_ = !points_.empty() && highest > lowest_layer_;
}

GroundMethod VirtualScanBuilder::ground_method(const Scan& scan) const {
  if (options_.ground != GroundMethod::kAuto) return options_.ground;
  if (points_.empty()) return GroundMethod::kNone;
  if (scan.beams) {
    if (scan.beams->layers <= 1) return GroundMethod::kNone;
    return scan.beams->layers <= 8 ? GroundMethod::kLayers : GroundMethod::kGrid;
  }
  std::int16_t highest = 0;
  float low = points_[0].z_m, high = low;
  for (const LevelPoint& p : points_) {
    highest = std::max(highest, p.layer);
    low = std::min(low, p.z_m);
    high = std::max(high, p.z_m);
  }
  if (layered_ && highest < 8) return GroundMethod::kLayers;
  return layered_ || (points_.size() > kCloud && high - low > 0.5F) ? GroundMethod::kGrid
                                                                    : GroundMethod::kNone;
}

void VirtualScanBuilder::remove_ground(GroundMethod method, std::optional<double> sensor_height_m) {
  if (method != GroundMethod::kBand && method != GroundMethod::kGrid) return;
  const auto low = static_cast<float>(options_.z_low_m),
             high = static_cast<float>(options_.z_high_m);
  const auto flat = static_cast<float>(-sensor_height_m.value_or(0));
  const bool grid = method == GroundMethod::kGrid;
  if (grid) ground_.estimate(points_, sensor_height_m);
  std::erase_if(points_, [&](const LevelPoint& p) {
    const float height = p.z_m - (grid ? ground_.height_m(p.range_m, p.bearing_rad) : flat);
    return !(height >= low && height <= high);
  });
}

void VirtualScanBuilder::set_view() {
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  const double last = beams_first_rad_ + (static_cast<double>(beams_.size()) - 1) * beams_step_rad_;
  const bool ends = !beams_.empty() && last < kPi;
  virtual_scan_.view_from_rad = ends ? beams_first_rad_ : -kOpen;
  virtual_scan_.view_to_rad = ends ? last : kOpen;
}

double VirtualScanBuilder::choose_step(const Scan& scan) {
  if (options_.step_rad > 0) return std::max(options_.step_rad, 1e-4);
  if (!beams_.empty()) return std::max(beams_step_rad_, 1e-4);
  steps_.clear();
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const float step = std::abs(points_[i].bearing_rad - points_[i - 1].bearing_rad);
    if (step > 3e-4F && step < 0.035F) steps_.push_back(step);
  }
  constexpr double kUsual = radians(0.25);
  const bool cloud = scan.returns.size() > kCloud;
  if (steps_.empty()) return kUsual;
  const auto middle = steps_.begin() + static_cast<std::ptrdiff_t>(steps_.size() / 2);
  std::nth_element(steps_.begin(), middle, steps_.end());
  return std::clamp<double>(*middle, radians(cloud ? 0.2 : 0.1), radians(1));
}

void VirtualScanBuilder::sort_into_columns(const Scan& scan) {
  const double step = virtual_scan_.step_rad;
  const double origin = beams_.empty() || scan.returns.empty() ? -kPi : beams_first_rad_;
  const auto columns = static_cast<std::uint32_t>(std::ceil(2 * kPi / step - 1e-6));
  const auto per_step = static_cast<float>(1 / step);
  // Column 0 is the one that -pi falls in, so that columns grow with bearing.
  const double before = (origin + kPi) / step + 0.5;
  const auto shift = static_cast<float>((before - std::floor(before)) * step);
  ends_.assign(columns + 1, 0);
  for (LevelPoint& p : points_) {
    const std::int32_t column =
        floor_of((p.bearing_rad + static_cast<float>(kPi) - shift) * per_step) + 1;
    p.column =
        static_cast<std::uint32_t>(std::clamp(column, 0, static_cast<std::int32_t>(columns)));
    ++ends_[p.column];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& end : ends_) {
    const std::uint32_t count = end;
    end = sum;
    sum += count;
  }
  order_.resize(points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    order_[ends_[points_[i].column]++] = key_of(points_[i].range_m, i);
  }
}

int VirtualScanBuilder::support_of(std::span<const std::uint64_t> column) const {
  const float reach = range_of(column[0]) + static_cast<float>(options_.support_m);
  std::uint64_t layers = 0;
  int count = 0, distinct = 0;
  for (const std::uint64_t key : column) {
    if (range_of(key) > reach) break;
    const std::uint64_t bit = 1ULL << (points_[index_of(key)].layer & 63);
    distinct += (layers & bit) == 0 ? 1 : 0;
    layers |= bit;
    ++count;
  }
  return layered_ ? distinct : count;
}

bool VirtualScanBuilder::is_lonely_ground(const LevelPoint& point, GroundMethod method) const {
  if (method != GroundMethod::kLayers) return false;
  if (point.layer == lowest_layer_) return true;
  return sensor_height_m_ && point.z_m + static_cast<float>(*sensor_height_m_) <
                                 kLowLonely + kLowLonelyPerMetre * point.range_m;
}

void VirtualScanBuilder::pick_points(const Scan& scan, GroundMethod method) {
  const bool one_layer = !layered_ && method != GroundMethod::kGrid;
  const bool seen_over = !scan.beams || method == GroundMethod::kGrid;
  most_per_bearing_ = options_.points_per_bearing > 0 ? options_.points_per_bearing
                                                      : (seen_over && !one_layer ? 3 : 1);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends_) {
    const auto column = std::span(order_).subspan(begin, end - begin);
    begin = end;
    if (column.empty()) continue;
    sort_keys(column);
    if (one_layer && most_per_bearing_ == 1) {
      emit(scan, points_[index_of(column.front())], 1);
    } else {
      pick_column(scan, column, method);
    }
  }
}

/// `column`: the returns of one bearing by range. What lies behind a gap of separation_m may be
/// another object; of each such group the nearest supported return is kept. Where layers are few,
/// one of them alone may look over what stands in front: there a group without support gives its
/// nearest return that is not ground, for its neighbours in bearing to support.
void VirtualScanBuilder::pick_column(const Scan& scan, std::span<const std::uint64_t> column,
                                     GroundMethod method) {
  const auto separation = static_cast<float>(options_.separation_m);
  const bool each_group = method == GroundMethod::kLayers && most_per_bearing_ > 1;
  const LevelPoint* lonely = nullptr;
  int kept = 0;
  bool group_done = false;
  const auto keep = [&](const LevelPoint& p, int support) {
    if (kept >= most_per_bearing_) return;
    emit(scan, p, support);
    ++kept;
  };
  for (std::size_t i = 0; i < column.size() && kept < most_per_bearing_; ++i) {
    if (i > 0 && range_of(column[i]) - range_of(column[i - 1]) > separation) {
      if (each_group && lonely != nullptr) keep(*std::exchange(lonely, nullptr), 1);
      group_done = false;
    }
    if (group_done) continue;
    const LevelPoint& p = points_[index_of(column[i])];
    const int support = support_of(column.subspan(i));
    if (support > 1) {
      keep(p, support);
      group_done = true;
      if (each_group) lonely = nullptr;
    } else if (lonely == nullptr && !is_lonely_ground(p, method)) {
      lonely = &p;
    }
  }
  if (lonely != nullptr && (each_group || kept == 0)) keep(*lonely, 1);
}

void VirtualScanBuilder::emit(const Scan& scan, const LevelPoint& point, int support) {
  const Return& r = scan.returns[point.source];
  constexpr float kLongestSweep_s = 60;  // what claims more, or is no number, is not known
  const float offset = std::abs(r.time_offset_s) < kLongestSweep_s ? r.time_offset_s : 0;
  const float angle = beams_.empty() ? exact_bearing(point.x_m, point.y_m) : point.bearing_rad;
  virtual_scan_.points.push_back({point.x_m, point.y_m, point.z_m, point.range_m, angle, offset,
                                  static_cast<std::int32_t>(point.column), point.source,
                                  static_cast<std::uint8_t>(std::min(support, 255))});
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
    for (std::size_t k = 1; k <= kBeside && k < n; ++k) {
      const std::size_t j = i + k < n ? i + k : i + k - n;
      const PlanarPoint& q = points[j];
      const float reach = base + slope * p.range_m;
      const float dx = p.x_m - q.x_m, dy = p.y_m - q.y_m;
      if (dx * dx + dy * dy > reach * reach) continue;
      keep_[i] = keep_[j] = 1;
      break;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (keep_[i]) points[kept++] = points[i];
  }
  points.resize(kept);
}

}  // namespace scanfuse::preprocess
