#include "scanfuse/preprocess/virtual_scan_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse::preprocess {
namespace {

constexpr std::size_t kCloud = 5000;  // more returns than this with a spread of heights are a cloud

/// Where returns are kept. Most regions hold all that is in reach; the box then need not be asked.
class Region {
 public:
  explicit Region(const PreprocessOptions& o)
      : near2_(std::max(static_cast<float>(o.range_min_m * o.range_min_m),
                        std::numeric_limits<float>::denorm_min())),
        far2_(static_cast<float>(o.range_max_m * o.range_max_m)),
        x_min_(static_cast<float>(o.x_min_m)),
        x_max_(static_cast<float>(o.x_max_m)),
        y_min_(static_cast<float>(o.y_min_m)),
        y_max_(static_cast<float>(o.y_max_m)),
        is_box_(std::min({-o.x_min_m, o.x_max_m, -o.y_min_m, o.y_max_m}) < 1.01 * o.range_max_m) {}

  [[nodiscard]] bool holds(float x, float y, float range2) const {
    if (!(range2 >= near2_ && range2 <= far2_)) return false;
    return !is_box_ || (x >= x_min_ && x <= x_max_ && y >= y_min_ && y <= y_max_);
  }

 private:
  float near2_, far2_;
  float x_min_, x_max_, y_min_, y_max_;
  bool is_box_;
};

}  // namespace

const VirtualScan& VirtualScanBuilder::operator()(const Scan& scan, const Pose3& ego_from_sensor) {
  const double height = ego_from_sensor.translation_m.z();
  sensor_height_m_ = height > 0 ? std::optional(height) : std::nullopt;
  const Eigen::Matrix3f rotation = ego_from_sensor.rotation.toRotationMatrix().cast<float>();
  beams_.prepare(scan, std::atan2(rotation(1, 0), rotation(0, 0)), options_.step_rad);
  project(scan, rotation);
  find_layers(scan);
  const GroundMethod method = ground_method(scan);
  if (beams_.empty() || method == GroundMethod::kGrid) find_bearings(scan);
  remove_ground(method, sensor_height_m_);

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
  drop_low_rows(method);
  drop_lonely();
  return virtual_scan_;
}

/// The bearings stay 0: where beams tell the columns, few points need theirs.
void VirtualScanBuilder::project(const Scan& scan, const Eigen::Matrix3f& rotation) {
  const bool turned = !rotation.isIdentity(0);
  const Region region(options_);
  points_.resize(scan.returns.size());
  LevelPoint* out = points_.data();
  std::uint32_t source = 0;
  for (const Return& r : scan.returns) {
    const std::uint32_t i = source++;
    float x = r.x_m, y = r.y_m, z = r.z_m;
    if (turned) {
      const Eigen::Vector3f p = rotation * Eigen::Vector3f(x, y, z);
      x = p.x(), y = p.y(), z = p.z();
    }
    const float range2 = x * x + y * y;
    if (!region.holds(x, y, range2) || !std::isfinite(z)) continue;
    *out++ = {x, y, z, std::sqrt(range2), 0, i, beams_.column_of(x, y, r.beam), r.layer};
  }
  points_.resize(static_cast<std::size_t>(out - points_.data()));
}

void VirtualScanBuilder::find_layers(const Scan& scan) {
  lowest_layer_ = 0;
  layered_ = scan.beams && scan.beams->layers > 1 && !points_.empty();
  if (layered_ || points_.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax(points_, {}, &LevelPoint::layer);
  lowest_layer_ = lowest.layer;
  layered_ = highest.layer > lowest.layer;
}

void VirtualScanBuilder::find_bearings(const Scan& scan) {
  for (LevelPoint& p : points_) {
    p.bearing_rad = beams_.bearing_of(p.x_m, p.y_m, scan.returns[p.source].beam);
  }
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
  const bool ends = !beams_.empty() && beams_.last_rad() < kPi;
  virtual_scan_.view_from_rad = ends ? beams_.first_rad() : -kOpen;
  virtual_scan_.view_to_rad = ends ? beams_.last_rad() : kOpen;
}

double VirtualScanBuilder::choose_step(const Scan& scan) {
  if (options_.step_rad > 0) return std::max(options_.step_rad, 1e-4);
  if (!beams_.empty()) return std::max(beams_.step_rad(), 1e-4);
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

}  // namespace scanfuse::preprocess
