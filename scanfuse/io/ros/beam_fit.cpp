#include "scanfuse/io/ros/beam_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::io::ros {
namespace {

constexpr int kMostColumns = 1'000'000;
constexpr std::size_t kFewest = 8;  ///< returns that make a pattern
constexpr double kOffBeam = 0.25;   ///< steps that a return may lie off its beam
constexpr float kNearest_m = 0.01F;

struct BeamBearing {
  std::int32_t beam;
  double bearing_rad;
};

std::vector<BeamBearing> bearings_by_beam(std::span<const Return> returns, int columns) {
  std::vector<BeamBearing> all;
  all.reserve(returns.size());
  for (const Return& r : returns) {
    if (r.beam < 0 || r.beam >= columns || r.squared_range() < kNearest_m * kNearest_m) continue;
    all.push_back({r.beam, std::atan2(double{r.y_m}, double{r.x_m})});
  }
  std::ranges::stable_sort(all, {}, &BeamBearing::beam);
  return all;
}

/// The median of what neighbours say, or 0.
double rough_step(const std::vector<BeamBearing>& all) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const int apart = all[i].beam - all[i - 1].beam;
    if (apart < 1 || apart > 4) continue;
    steps.push_back(wrap_pi(all[i].bearing_rad - all[i - 1].bearing_rad) / apart);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace

std::optional<BeamPattern> fit_beams(std::span<const Return> returns, int columns, int layers) {
  if (columns < 2 || columns > kMostColumns) return std::nullopt;
  const auto all = bearings_by_beam(returns, columns);
  const double rough = rough_step(all);
  if (all.size() < kFewest || !(rough > 1e-6)) return std::nullopt;
  // Least squares on what is left over the rough line through the first return.
  const auto left_over = [&](const BeamBearing& b) {
    return wrap_pi(b.bearing_rad - all[0].bearing_rad - (b.beam - all[0].beam) * rough);
  };
  double sum_u = 0, sum_uu = 0, sum_r = 0, sum_ur = 0;
  for (const BeamBearing& b : all) {
    const double u = b.beam - all[0].beam, r = left_over(b);
    sum_u += u;
    sum_uu += u * u;
    sum_r += r;
    sum_ur += u * r;
  }
  const auto n = static_cast<double>(all.size());
  const double spread = n * sum_uu - sum_u * sum_u;
  if (!(spread > 0)) return std::nullopt;
  const double slope = (n * sum_ur - sum_u * sum_r) / spread;
  const double offset = (sum_r - slope * sum_u) / n;
  const double step = rough + slope;
  if (!(step > 1e-6) || (columns - 1) * step > 2 * kPi + step) return std::nullopt;
  for (const BeamBearing& b : all) {
    const double off = left_over(b) - offset - slope * (b.beam - all[0].beam);
    if (std::abs(off) > kOffBeam * step) return std::nullopt;
  }
  const double first = all[0].bearing_rad + offset - all[0].beam * step;
  return BeamPattern{wrap_pi(first), step, columns, std::max(layers, 1), 0, 0};
}

}  // namespace scanfuse::io::ros
