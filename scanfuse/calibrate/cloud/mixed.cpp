#include "scanfuse/calibrate/cloud/mixed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace scanfuse::calibrate {
namespace {

constexpr int kFarthestSide = 3;

/// A way to go through the image, one cell a step.
struct Step {
  std::ptrdiff_t profile = 0;
  std::ptrdiff_t beam = 0;
};

/// How far a return lies behind the surface of one side, in standard deviations; nothing where that
/// side has no surface.
std::optional<double> off_side(const RangeImage& image, std::ptrdiff_t profile, std::ptrdiff_t beam,
                               Step step, double noise_m, double tolerance) {
  for (int o = 1; o <= kFarthestSide; ++o) {
    double r[3];
    for (int k = 0; k < 3; ++k) {
      r[k] = image.near(profile + (o + k) * step.profile, beam + (o + k) * step.beam);
    }
    const double bend = r[0] - 2 * r[1] + r[2];
    if (!(std::abs(bend) <= tolerance * noise_m * std::sqrt(6.0))) continue;
    const double mean = (r[0] + r[1] + r[2]) / 3, slope = (r[2] - r[0]) / 2, reach = o + 1;
    const double sigma = noise_m * std::sqrt(1 + 1.0 / 3 + reach * reach / 2);
    return (image.near(profile, beam) - (mean - slope * reach)) / sigma;
  }
  return std::nullopt;
}

bool is_between(const RangeImage& image, std::ptrdiff_t profile, std::ptrdiff_t beam, Step step,
                double noise_m, double tolerance) {
  const auto one = off_side(image, profile, beam, step, noise_m, tolerance);
  if (!one || std::abs(*one) <= tolerance) return false;
  const auto other =
      off_side(image, profile, beam, {-step.profile, -step.beam}, noise_m, tolerance);
  return other && std::abs(*other) > tolerance && (*one > 0) != (*other > 0);
}

}  // namespace

std::vector<bool> find_mixed(const RangeImage& image, const MixedOptions& options) {
  std::vector<bool> mixed(image.range_m.size(), false);
  const double noise_m = std::max(range_noise(image), options.least_noise_m);
  const double tolerance = options.tolerance_sigmas;
  for (std::size_t k = 0; k < mixed.size(); ++k) {
    if (!std::isfinite(image.range_m[k])) continue;
    const auto p = static_cast<std::ptrdiff_t>(k / image.beams);
    const auto b = static_cast<std::ptrdiff_t>(k % image.beams);
    mixed[k] = is_between(image, p, b, {0, 1}, noise_m, tolerance) ||
               is_between(image, p, b, {1, 0}, noise_m, tolerance);
  }
  return mixed;
}

}  // namespace scanfuse::calibrate
