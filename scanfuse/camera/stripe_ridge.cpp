#include "scanfuse/camera/stripe_ridge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scanfuse/camera/gaussian.hpp"

namespace scanfuse::camera {
namespace {

/// Samples of a signal along the curve, first and last included.
struct Range {
  int first = 0;
  int last = -1;
};

Range range_of(const Signal& signal, double from_px, double to_px) {
  return {std::max(0, static_cast<int>(std::ceil(signal.along_index(from_px)))),
          std::min(signal.along() - 1, static_cast<int>(std::floor(signal.along_index(to_px))))};
}

/// Means of a cross-section in bins of half a sample.
struct Bins {
  int reach;  ///< bins on either side
  std::vector<double> sum, count;

  explicit Bins(int r) : reach(r), sum(static_cast<std::size_t>(2 * r + 1)), count(sum.size()) {}

  void add(double bin, double value) {
    const auto i = static_cast<int>(std::lround(bin)) + reach;
    if (i < 0 || i > 2 * reach) return;
    sum[static_cast<std::size_t>(i)] += value;
    count[static_cast<std::size_t>(i)] += 1;
  }
  [[nodiscard]] std::optional<std::vector<double>> means() const {
    std::vector<double> out(sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (count[i] == 0) return {};
      out[i] = sum[i] / count[i];
    }
    return out;
  }
};

/// Takes away the straight line through the outer fifths.
void level_out(std::vector<double>& profile) {
  const std::size_t size = profile.size(), fifth = std::max<std::size_t>(1, size / 5);
  double left = 0, right = 0;
  for (std::size_t i = 0; i < fifth; ++i) {
    left += profile[i] / static_cast<double>(fifth);
    right += profile[size - 1 - i] / static_cast<double>(fifth);
  }
  const double gap = static_cast<double>(size - fifth);
  for (std::size_t i = 0; i < size; ++i) {
    const double place = static_cast<double>(i) - static_cast<double>(fifth - 1) / 2;
    profile[i] -= left + (right - left) * place / gap;
  }
}

/// Width at half of the height, in bins, from the highest bin of the middle third outwards.
double width_at_half(const std::vector<double>& profile, std::size_t peak) {
  const double half = profile[peak] / 2;
  double width = 0;
  for (const int way : {-1, 1}) {
    auto i = static_cast<std::ptrdiff_t>(peak);
    const auto size = static_cast<std::ptrdiff_t>(profile.size());
    const auto value = [&](std::ptrdiff_t k) { return profile[static_cast<std::size_t>(k)]; };
    while (i + way >= 0 && i + way < size && value(i + way) > half) i += way;
    double part = std::abs(static_cast<double>(i - static_cast<std::ptrdiff_t>(peak)));
    if (i + way >= 0 && i + way < size) part += (value(i) - half) / (value(i) - value(i + way));
    width += part;
  }
  return width;
}

/// One cross-section of the signal, smoothed along it in the three ways that derivatives need.
struct Section {
  int first = 0;  ///< sample across
  std::vector<float> value, slope, curvature;
};

Section section_of(const Signal& signal, int along, int first, int size,
                   const GaussianKernels& kernels) {
  Section section{first, {}, {}, {}};
  for (auto* part : {&section.value, &section.slope, &section.curvature}) {
    part->resize(static_cast<std::size_t>(size));
  }
  const int radius = kernels.radius, taps = 2 * radius + 1;
  std::vector<float> raw(static_cast<std::size_t>(size + 2 * radius));
  for (int i = 0; i < size + 2 * radius; ++i) {
    const int across = std::clamp(first + i - radius, 0, signal.across() - 1);
    raw[static_cast<std::size_t>(i)] = signal.at(along, across);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    float value = 0, slope = 0, curvature = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(taps); ++k) {
      value += kernels.value[k] * raw[i + k];
      slope += kernels.slope[k] * raw[i + k];
      curvature += kernels.curvature[k] * raw[i + k];
    }
    section.value[i] = value;
    section.slope[i] = slope;
    section.curvature[i] = curvature;
  }
  return section;
}

/// The neighbourhood of a curve, smoothed across; smoothing along is done where it is asked for.
class Band {
 public:
  Band(const Signal& signal, const StripeCurve& curve, Range range, int half,
       const GaussianKernels& kernels)
      : signal_(&signal), kernels_(&kernels), first_along_(range.first - kernels.radius) {
    const int last = range.last + kernels.radius;
    for (int a = first_along_; a <= last; ++a) {
      const int along = std::clamp(a, 0, signal.along() - 1);
      const double slope = std::abs(curve.slope(signal.along_px(a)));
      const int reach = half + static_cast<int>(std::ceil(slope * kernels.radius)) + 1;
      const int middle = nearest(curve, a);
      sections_.push_back(section_of(signal, along, middle - reach, 2 * reach + 1, kernels));
    }
  }

  /// The sample across that lies nearest to the curve.
  [[nodiscard]] int nearest(const StripeCurve& curve, int along) const {
    return static_cast<int>(
        std::lround(signal_->across_index(curve.across(signal_->along_px(along)))));
  }

  /// Smoothed signal and its derivatives, u across and v along, in units of samples.
  struct Local {
    double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  };
  [[nodiscard]] Local at(int along, int across) const {
    float value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    for (int k = 0; k < 2 * kernels_->radius + 1; ++k) {
      const Section& s =
          sections_[static_cast<std::size_t>(along - kernels_->radius + k - first_along_)];
      const auto size = static_cast<int>(s.value.size());
      const auto i = static_cast<std::size_t>(std::clamp(across - s.first, 0, size - 1));
      const auto tap = static_cast<std::size_t>(k);
      value += kernels_->value[tap] * s.value[i];
      u += kernels_->value[tap] * s.slope[i];
      uu += kernels_->value[tap] * s.curvature[i];
      v += kernels_->slope[tap] * s.value[i];
      uv += kernels_->slope[tap] * s.slope[i];
      vv += kernels_->curvature[tap] * s.value[i];
    }
    return {value, u, v, uu, uv, vv};
  }

 private:
  const Signal* signal_;
  const GaussianKernels* kernels_;
  int first_along_;
  std::vector<Section> sections_;
};

/// First and second derivative along a direction.
struct Directional {
  double slope = 0, bend = 0;
};
Directional along_normal(const Band::Local& d, double nu, double nv) {
  return {nu * d.u + nv * d.v, nu * nu * d.uu + 2 * nu * nv * d.uv + nv * nv * d.vv};
}

}  // namespace

StripeProfile profile_of(const Signal& signal, const StripeCurve& curve, double from_px,
                         double to_px, double reach_px) {
  const Range range = range_of(signal, from_px, to_px);
  Bins bins(std::max(6, static_cast<int>(2 * reach_px / signal.pitch())));
  for (int a = range.first; a <= range.last; ++a) {
    const double along = signal.along_px(a), shrink = 1 / std::hypot(1.0, curve.slope(along));
    const double centre = signal.across_index(curve.across(along));
    const auto reach = static_cast<int>(bins.reach / (2 * shrink)) + 1;
    const auto middle = static_cast<int>(std::lround(centre));
    for (int c = std::max(0, middle - reach); c <= std::min(signal.across() - 1, middle + reach);
         ++c) {
      bins.add(2 * (c - centre) * shrink, signal.at(a, c));
    }
  }
  auto profile = bins.means();
  if (!profile) return {};
  level_out(*profile);
  const auto third = static_cast<std::ptrdiff_t>(profile->size() / 3);
  const auto peak = std::max_element(profile->begin() + third, profile->end() - third);
  if (!(*peak > 0)) return {};
  const double bins_wide =
      width_at_half(*profile, static_cast<std::size_t>(peak - profile->begin()));
  return {*peak, bins_wide * signal.pitch() / 2 / 2.3548};
}

std::vector<RidgeSample> ridge_along(const Signal& signal, const StripeCurve& curve, double from_px,
                                     double to_px, const StripeProfile& profile,
                                     double smoothing_px, bool level) {
  const Range range = range_of(signal, from_px, to_px);
  std::vector<RidgeSample> samples;
  if (range.last < range.first) return samples;
  const double smoothing = smoothing_px / signal.pitch(), width = profile.sigma_px / signal.pitch();
  const double total = std::hypot(smoothing, width);
  const GaussianKernels kernels(smoothing);
  const int flank = static_cast<int>(std::ceil(kFlank_widths * total));
  const int search = static_cast<int>(std::ceil(std::max(2.0, 1.5 * total)));
  const Band band(signal, curve, range, std::max(search, flank) + 1, kernels);
  for (int a = range.first; a <= range.last; ++a) {
    const double slope = curve.slope(signal.along_px(a));
    const double nu = 1 / std::hypot(1.0, slope), nv = -slope * nu;
    const int middle = band.nearest(curve, a);
    if (middle - search < 1 || middle + search > signal.across() - 2) continue;
    double best = 0, offset = 0;
    int place = 0;
    for (int c = middle - search; c <= middle + search; ++c) {
      const Directional d = along_normal(band.at(a, c), nu, nv);
      if (!(d.bend < -best) || std::abs(d.slope) > -0.75 * d.bend) continue;
      best = -d.bend;
      offset = -d.slope / d.bend;
      place = c;
    }
    if (!(best > 0)) continue;
    const double right = band.at(a, place + flank).value, left = band.at(a, place - flank).value;
    // The slope of the surroundings adds to that of the stripe; across is nu of the way along n.
    if (level) offset -= (right - left) / (2 * flank) * nu / best;
    const double along = a + offset * nv, across = place + offset * nu;
    const double height = best * total * total * total / width;
    samples.push_back({curve.point(signal.along_px(along), signal.across_px(across)), height,
                       (left + right) / 2, signal.is_clipped(a, place)});
  }
  return samples;
}

}  // namespace scanfuse::camera
