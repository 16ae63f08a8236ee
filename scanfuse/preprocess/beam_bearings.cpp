#include "scanfuse/preprocess/beam_bearings.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

constexpr float kTurn = static_cast<float>(2 * kPi);
constexpr double kNearMiddle = 0.4;  // of a step to either side of a beam
constexpr double kRounding = 1e-5;   // rad: more than bearings and edges of columns are rounded by

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

/// Rounds down; the library's function is a call.
std::int32_t floor_of(float value) {
  const auto truncated = static_cast<std::int32_t>(value);
  return truncated - (value < static_cast<float>(truncated) ? 1 : 0);
}

bool makes_sense(const BeamPattern& pattern) {
  constexpr int kMostColumns = 1 << 20;
  return pattern.columns > 0 && pattern.columns < kMostColumns &&
         std::isfinite(pattern.first_azimuth_rad) && pattern.step_rad > 0 && pattern.step_rad < 1;
}

}  // namespace

ColumnLayout::ColumnLayout(double origin_rad, double step_rad)
    : last_(static_cast<std::uint32_t>(std::ceil(2 * kPi / step_rad - 1e-6))),
      per_step_(static_cast<float>(1 / step_rad)) {
  const double before = (origin_rad + kPi) / step_rad + 0.5;
  before_first_rad_ = static_cast<float>((before - std::floor(before)) * step_rad);
}

std::uint32_t ColumnLayout::at(float bearing_rad) const {
  const std::int32_t column =
      floor_of((bearing_rad + static_cast<float>(kPi) - before_first_rad_) * per_step_) + 1;
  return static_cast<std::uint32_t>(std::clamp(column, 0, static_cast<std::int32_t>(last_)));
}

void BeamBearings::prepare(const Scan& scan, double yaw_rad, double step_rad) {
  if (!scan.beams || !makes_sense(*scan.beams)) {
    beams_.clear();
    return;
  }
  const double first = wrap_pi(scan.beams->first_azimuth_rad + yaw_rad);
  const double step = scan.beams->step_rad;
  const auto columns = static_cast<std::size_t>(scan.beams->columns);
  const ColumnLayout layout(first, std::max(step_rad > 0 ? step_rad : step, 1e-4));
  if (beams_.size() == columns && first_rad_ == first && step_rad_ == step && layout_ == layout) {
    return;
  }
  first_rad_ = first;
  step_rad_ = step;
  layout_ = layout;
  near_middle_ = static_cast<float>(kNearMiddle * step);
  beams_.resize(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const double angle = wrap_pi(first + static_cast<double>(i) * step);
    beams_[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)),
                 static_cast<float>(angle), column_around(angle)};
  }
}

/// The column that a beam is in with all that counts as near its middle, if that is one.
std::uint32_t BeamBearings::column_around(double bearing_rad) const {
  const double reach = kNearMiddle * step_rad_ + kRounding;
  const double low = bearing_rad - reach, high = bearing_rad + reach;
  const std::uint32_t column = layout_.at(static_cast<float>(low));
  return low > -kPi && high < kPi && layout_.at(static_cast<float>(high)) == column ? column
                                                                                    : kNoColumn;
}

float BeamBearings::bearing_of(float x_m, float y_m, std::int32_t beam) const {
  if (static_cast<std::uint32_t>(beam) >= beams_.size()) return quick_bearing(x_m, y_m);
  const Beam& b = beams_[static_cast<std::uint32_t>(beam)];
  const float along = b.cosine * x_m + b.sine * y_m, across = b.cosine * y_m - b.sine * x_m;
  if (!(std::abs(across) < 0.1F * along)) return quick_bearing(x_m, y_m);
  const float d = across / along;
  const float angle = b.bearing_rad + d - d * d * d * (1.0F / 3);
  if (angle >= kTurn / 2) return angle - kTurn;
  return angle < -kTurn / 2 ? angle + kTurn : angle;
}

}  // namespace scanfuse::preprocess
