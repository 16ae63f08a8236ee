#include "scanfuse/camera/stripe_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "scanfuse/camera/stripe_ridge.hpp"

namespace scanfuse::camera {
namespace {

using Eigen::Vector2d;

constexpr double kReach_px = 24;         ///< of a cross-section, either side
constexpr double kLeastSmoothing = 0.9;  ///< in samples: below, kernels are no longer Gaussian

/// Where along the curve the region begins and ends.
struct Span {
  double from_px = 0;
  double to_px = -1;
};

Span span_within(const StripeRegion& region, const StripeCurve& curve) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& p : region.outline_px) {
    low = std::min(low, curve.along_of(p));
    high = std::max(high, curve.along_of(p));
  }
  Span span{high, low};
  for (double along = std::floor(low); along <= high; along += 1) {
    bool inside = true;
    const Vector2d p = curve.point(along, curve.across(along));
    bool left = false, right = false;
    for (std::size_t i = 0; i < region.outline_px.size(); ++i) {
      const Vector2d& a = region.outline_px[i];
      const Vector2d edge = region.outline_px[(i + 1) % region.outline_px.size()] - a, to = p - a;
      (edge.x() * to.y() - edge.y() * to.x() >= 0 ? left : right) = true;
    }
    inside = !(left && right);
    if (!inside) continue;
    span.from_px = std::min(span.from_px, along);
    span.to_px = std::max(span.to_px, along);
  }
  return span;
}

/// A lattice and how high the stripe stands on it.
struct LitLattice {
  Lattice lattice;
  StripeProfile profile;
};

/// The lattices of a mosaic that show the laser: those pixels which it lights much more than the
/// rest.
std::vector<LitLattice> lit_lattices(const Image& on, const Image* off, const StripeCurve& curve,
                                     const Span& span) {
  std::vector<LitLattice> all;
  for (int k = 0; k < 4; ++k) {
    const Lattice lattice{0, 2, k % 2, k / 2};
    const Signal signal(on, off, lattice, curve.upright);
    all.push_back({lattice, profile_of(signal, curve, span.from_px, span.to_px, kReach_px)});
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.profile.height > b.profile.height;
  });
  const auto height = [&](std::size_t k) { return std::max(all[k].profile.height, 1e-9); };
  const bool diagonal = all[0].lattice.first_row != all[1].lattice.first_row &&
                        all[0].lattice.first_column != all[1].lattice.first_column;
  if (height(0) > 2 * height(1)) {
    all.resize(1);
  } else if (diagonal && height(1) > 2 * height(2)) {
    all.resize(2);
  } else {
    all.clear();
  }
  return all;
}

/// Places of a colour in a mosaic, as columns and rows of the 2 x 2 pixels.
std::vector<Lattice> lattices_of(Mosaic mosaic, LaserChannel channel) {
  constexpr std::array<std::string_view, 4> kOrders{"rggb", "grbg", "gbrg", "bggr"};
  const auto& order = kOrders[static_cast<std::size_t>(mosaic) - 2];
  const char wanted = channel == LaserChannel::kGreen  ? 'g'
                      : channel == LaserChannel::kBlue ? 'b'
                                                       : 'r';
  std::vector<Lattice> lattices;
  for (int k = 0; k < 4; ++k) {
    if (order[static_cast<std::size_t>(k)] == wanted) lattices.push_back({0, 2, k % 2, k / 2});
  }
  return lattices;
}

Mosaic mosaic_named(const Lattice& lattice) {
  // The colour is not known, only its place: named as if it were red.
  constexpr std::array kNames{Mosaic::kRggb, Mosaic::kGrbg, Mosaic::kGbrg, Mosaic::kBggr};
  return kNames[static_cast<std::size_t>(2 * lattice.first_row + lattice.first_column)];
}

/// What a stripe is measured on.
struct Source {
  std::vector<LitLattice> lattices;
  Mosaic mosaic = Mosaic::kNone;
};

Source source_of(const Image& on, const Image* off, const StripeCurve& curve, const Span& span,
                 int channel, const StripeOptions& options) {
  Source source;
  std::vector<Lattice> lattices{{channel, 1, 0, 0}};
  if (on.channels == 1 && options.mosaic != Mosaic::kNone) {
    if (options.mosaic == Mosaic::kDetect) {
      source.lattices = lit_lattices(on, off, curve, span);
      if (!source.lattices.empty()) {
        source.mosaic = mosaic_named(source.lattices.front().lattice);
        return source;
      }
    } else {
      source.mosaic = options.mosaic;
      lattices = lattices_of(options.mosaic, options.channel);
    }
  }
  for (const Lattice& lattice : lattices) {
    const Signal signal(on, off, lattice, curve.upright);
    source.lattices.push_back(
        {lattice, profile_of(signal, curve, span.from_px, span.to_px, kReach_px)});
  }
  return source;
}

double smoothing_for(const LitLattice& lit) {
  return std::max(lit.profile.sigma_px, kLeastSmoothing * lit.lattice.pitch);
}

std::vector<RidgeSample> ridge_of(const Image& on, const Image* off, const Source& source,
                                  const StripeCurve& curve, const Span& span) {
  std::vector<RidgeSample> samples;
  for (const LitLattice& lit : source.lattices) {
    const Signal signal(on, off, lit.lattice, curve.upright);
    const auto some = ridge_along(signal, curve, span.from_px, span.to_px, lit.profile,
                                  smoothing_for(lit), off == nullptr);
    samples.insert(samples.end(), some.begin(), some.end());
  }
  std::stable_sort(samples.begin(), samples.end(), [&](const auto& a, const auto& b) {
    return curve.along_of(a.position_px) < curve.along_of(b.position_px);
  });
  return samples;
}

std::vector<Vector2d> places(const std::vector<RidgeSample>& samples) {
  std::vector<Vector2d> out;
  for (const auto& sample : samples) out.push_back(sample.position_px);
  return out;
}

template <class Keep>
void keep_if(std::vector<RidgeSample>& samples, const Keep& keep) {
  std::erase_if(samples, [&](const RidgeSample& sample) { return !keep(sample); });
}

/// Means over pieces of the stripe as long as its blur, so that they are nearly independent.
std::vector<StripePoint> means_over(const std::vector<RidgeSample>& samples,
                                    const StripeCurve& curve, double piece_px) {
  std::vector<StripePoint> points;
  std::size_t begin = 0;
  const auto piece = [&](std::size_t i) {
    return std::floor(curve.along_of(samples[i].position_px) / piece_px);
  };
  for (std::size_t i = 1; i <= samples.size(); ++i) {
    if (i < samples.size() && piece(i) == piece(begin)) continue;
    StripePoint point{Vector2d::Zero(), 0, 0};
    for (std::size_t k = begin; k < i; ++k) {
      point.position_px += samples[k].position_px;
      point.contrast += samples[k].contrast;
    }
    const auto count = static_cast<double>(i - begin);
    point.position_px /= count;
    point.contrast /= count;
    // A mean over a scrap weighs little and would be noisier than the rest.
    if (count >= 0.4 * piece_px / 2) points.push_back(point);
    begin = i;
  }
  return points;
}

/// Scatter of the fainter and the brighter half of the points, each its own.
void set_sigmas(std::vector<StripePoint>& points, const StripeCurve& curve) {
  std::vector<double> contrasts;
  for (const auto& point : points) contrasts.push_back(point.contrast);
  const auto middle = contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() / 2);
  std::nth_element(contrasts.begin(), middle, contrasts.end());
  std::array<double, 2> sum{}, count{};
  for (const auto& point : points) {
    const std::size_t half = point.contrast > *middle ? 1 : 0;
    sum[half] += std::pow(curve.distance(point.position_px), 2);
    count[half] += 1;
  }
  const double all = std::sqrt((sum[0] + sum[1]) / std::max(1.0, count[0] + count[1] - 3));
  for (auto& point : points) {
    const std::size_t half = point.contrast > *middle ? 1 : 0;
    point.sigma_px = count[half] >= 10 ? std::sqrt(sum[half] / count[half]) : all;
  }
}

/// How much the light beside the stripe varies along it: squares that other light shows.
double ambient_spread(const std::vector<RidgeSample>& samples) {
  std::vector<double> values;
  for (const auto& sample : samples) values.push_back(sample.ambient);
  std::sort(values.begin(), values.end());
  return values[values.size() * 9 / 10] - values[values.size() / 10];
}

Stripe refused(Stripe stripe, std::string reason) {
  stripe.points.clear();
  stripe.reason = std::move(reason);
  return stripe;
}

}  // namespace

double SquareGrid::distance_to_border(const Vector2d& p) const {
  const Eigen::Vector3d q = squares_from_px * p.homogeneous();
  const Vector2d at = q.hnormalized();
  if (at.x() < -1.5 || at.y() < -1.5 || at.x() > spec.columns + 0.5 || at.y() > spec.rows + 0.5) {
    return std::numeric_limits<double>::infinity();
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k) {
    // Off the squares, the nearest border is that of the outermost ones.
    const double most = k == 0 ? spec.columns : spec.rows;
    const double border = std::clamp(std::round(at[k]), -1.0, most);
    const Vector2d gradient =
        (squares_from_px.block<1, 2>(k, 0) - at[k] * squares_from_px.block<1, 2>(2, 0))
            .transpose() /
        q.z();
    nearest = std::min(nearest, std::abs(at[k] - border) / gradient.norm());
  }
  return nearest;
}

Stripe measure_stripe(const Image& on, const Image* off, const StripeRegion& region,
                      const StripeCurve& rough, int channel, const StripeOptions& options) {
  Stripe stripe;
  StripeCurve curve = rough;
  const Span span = span_within(region, curve);
  Source source = source_of(on, off, curve, span, channel, options);
  stripe.mosaic = source.mosaic;
  stripe.channel = on.channels == 1
                       ? LaserChannel::kGrey
                       : std::array{LaserChannel::kRed, LaserChannel::kGreen,
                                    LaserChannel::kBlue}[static_cast<std::size_t>(channel)];
  std::vector<RidgeSample> samples;
  double smoothing = 0;
  for (int round = 0; round < 2; ++round) {
    if (round > 0) source = source_of(on, off, curve, span, channel, options);
    const StripeProfile& profile = source.lattices.front().profile;
    if (!(profile.height >= options.min_contrast) || !(profile.sigma_px > 0)) {
      return refused(std::move(stripe),
                     fmt::format("no stripe: {:.1f} counts of contrast, {:.0f} asked for",
                                 profile.height, options.min_contrast));
    }
    stripe.width_px = profile.sigma_px;
    smoothing = std::hypot(smoothing_for(source.lattices.front()), profile.sigma_px);
    samples = ridge_of(on, off, source, curve, span);
    keep_if(samples, [&](const auto& s) { return s.contrast >= options.min_contrast / 2; });
    const auto fit = fit_curve(places(samples), curve, 0.3);
    if (!fit) return refused(std::move(stripe), "no stripe: its points do not make a line");
    curve = fit->curve;
  }
  double border = options.border_widths * smoothing;
  if (ambient_spread(samples) > 0.1 * source.lattices.front().profile.height) {
    border = std::max(border, kFlank_widths * smoothing);
  }
  if (region.squares) {
    const double least = std::min(border, 0.25 * region.squares->square_px);
    keep_if(samples, [&](const auto& s) {
      return region.squares->distance_to_border(s.position_px) >= least;
    });
  }
  const auto fit = fit_curve(places(samples), curve, 0.3);
  if (!fit) return refused(std::move(stripe), "no stripe is left off the borders of squares");
  std::vector<RidgeSample> kept;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (fit->inliers[i]) kept.push_back(samples[i]);
  }
  curve = fit->curve;
  const double clipped = static_cast<double>(
      std::count_if(kept.begin(), kept.end(), [](const auto& s) { return s.clipped; }));
  stripe.saturated_share = clipped / static_cast<double>(kept.size());
  stripe.points = means_over(kept, curve, options.piece_widths * smoothing);
  double sum = 0;
  for (const auto& p : stripe.points) sum += std::pow(curve.distance(p.position_px), 2);
  stripe.scatter_px =
      std::sqrt(sum / std::max<double>(1.0, static_cast<double>(stripe.points.size()) - 3));
  set_sigmas(stripe.points, curve);
  const double length =
      stripe.points.empty()
          ? 0
          : (stripe.points.back().position_px - stripe.points.front().position_px).norm();
  const double least = region.squares ? options.min_squares * region.squares->square_px : 10;
  if (stripe.points.size() < 5 || length < least) {
    auto why =
        fmt::format("a stripe of {:.0f} pixels, {} points{}: too short", length,
                    stripe.points.size(), region.squares ? " off the borders of squares" : "");
    return refused(std::move(stripe), std::move(why));
  }
  if (stripe.scatter_px > options.max_scatter_px) {
    auto why = fmt::format("its points scatter by {:.2f} px about a line; {:.2f} are allowed",
                           stripe.scatter_px, options.max_scatter_px);
    return refused(std::move(stripe), std::move(why));
  }
  return stripe;
}

}  // namespace scanfuse::camera
