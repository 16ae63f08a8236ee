#include "scanfuse/calibrate/cloud/edge_light.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scanfuse/calibrate/middle.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::calibrate {
namespace {

/// Beams further in or out than these shares of the radius show surfaces without an edge.
constexpr double kInnerShare = 0.25;
constexpr double kOuterShare = 0.15;
constexpr double kNear_spacings = 5;
constexpr std::size_t kFewestNear = 30;
constexpr double kLeastNoise = 0.02;  ///< of an intensity, as a share
constexpr int kMostFitSteps = 40;
/// Squares without an edge over those with it, for the edge to be believed.
constexpr double kBetterBy = 2;

/// A beam near the edge: its intensity as a share of what it is away from the edge.
struct LitBeam {
  double out_m = 0;  ///< beyond the edge as it seems
  double share = 0;
  double weight = 1;
  bool on = true;
};

/// Median and robust deviation of an intensity away from the edge.
struct Plateau {
  double level = 0;
  double noise = 0;  ///< as a share of the level
};

std::optional<Plateau> plateau_of(std::vector<double> values) {
  if (values.size() < kFewestNear) return std::nullopt;
  const double level = middle_of(values);
  if (!(level > 0)) return std::nullopt;
  for (double& value : values) value = std::abs(value - level);
  return Plateau{level, std::hypot(1.4826 * middle_of(std::move(values)) / level, kLeastNoise)};
}

double out_of(const EdgeBeam& beam, const DiscEdge& edge) {
  return (beam.place_m - edge.centre_m).norm() - edge.radius_m;
}

struct Plateaus {
  std::optional<Plateau> on, beyond;
};

Plateaus plateaus_of(std::span<const EdgeBeam> beams, const DiscEdge& edge) {
  std::vector<double> on, beyond;
  for (const EdgeBeam& beam : beams) {
    if (!std::isfinite(beam.intensity)) continue;
    const double out = out_of(beam, edge);
    if (beam.state == BeamState::kOn && out < -kInnerShare * edge.radius_m) {
      on.push_back(beam.intensity);
    } else if (beam.state == BeamState::kBeyond && out > kOuterShare * edge.radius_m) {
      beyond.push_back(beam.intensity);
    }
  }
  return {plateau_of(std::move(on)), plateau_of(std::move(beyond))};
}

std::vector<LitBeam> near_edge(std::span<const EdgeBeam> beams, const DiscEdge& edge,
                               const Plateaus& plateaus, bool backed, double reach_m) {
  std::vector<LitBeam> lit;
  for (const EdgeBeam& beam : beams) {
    const bool on = beam.state == BeamState::kOn;
    const auto& plateau = on ? plateaus.on : plateaus.beyond;
    const bool told = on || (backed && beam.state == BeamState::kBeyond);
    if (!told || beam.backed != backed || !plateau || !std::isfinite(beam.intensity)) continue;
    const double out = out_of(beam, edge);
    if (std::abs(out) > reach_m) continue;
    lit.push_back(
        {out, beam.intensity / plateau->level, 1 / (plateau->noise * plateau->noise), on});
  }
  return lit;
}

/// Where the edge is and how large the spot, and how well that fits.
struct LightFit {
  double out_m = 0;
  double spot_radius_m = 0;
  double squares = 0;
  double sigma_m = 0;
};

/// Squares of what the shares differ by from the model's, with the normal equations for (out,
/// radius).
struct Normals {
  double squares = 0;
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
};

Normals normals_of(const std::vector<LitBeam>& lit, double out_m, double radius_m) {
  Normals sum;
  for (const LitBeam& beam : lit) {
    const double u = (beam.out_m - out_m) / radius_m;
    const double way = beam.on ? 1 : -1;
    const double off = beam.share - spot_share(way * u);
    // d share / d u = -2/pi sqrt(1 - u^2)
    const double slope = std::abs(u) < 1 ? way * 2 / kPi * std::sqrt(1 - u * u) / radius_m : 0.0;
    const Eigen::Vector2d g(slope, slope * u);
    sum.squares += beam.weight * off * off;
    sum.information += beam.weight * g * g.transpose();
    sum.right += beam.weight * off * g;
  }
  return sum;
}

LightFit best_of_grid(const std::vector<LitBeam>& lit, double spacing_m) {
  LightFit best;
  best.squares = std::numeric_limits<double>::infinity();
  for (const double radius : {0.4, 0.7, 1.0, 1.5, 2.2, 3.0}) {
    for (int k = -8; k <= 8; ++k) {
      const double out = k / 8.0 * radius * spacing_m;
      const double squares = normals_of(lit, out, radius * spacing_m).squares;
      if (squares < best.squares) best = {out, radius * spacing_m, squares, 0};
    }
  }
  return best;
}

LightFit fit_light(const std::vector<LitBeam>& lit, double spacing_m) {
  LightFit fit = best_of_grid(lit, spacing_m);
  double damping = 1e-3;
  Normals at = normals_of(lit, fit.out_m, fit.spot_radius_m);
  for (int k = 0; k < kMostFitSteps && damping < 1e8; ++k) {
    Eigen::Matrix2d damped = at.information;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += 1e-9 / (spacing_m * spacing_m);
    const Eigen::Vector2d step = damped.ldlt().solve(at.right);
    const double out = fit.out_m + step[0];
    const double radius = std::max(fit.spot_radius_m + step[1], 0.05 * spacing_m);
    const Normals there = normals_of(lit, out, radius);
    if (there.squares <= at.squares) {
      fit = {out, radius, there.squares, 0};
      at = there;
      damping = std::max(damping / 4, 1e-9);
      if (step.norm() < 1e-6 * spacing_m) break;
    } else {
      damping *= 8;
    }
  }
  const double variance = at.squares / std::max(1.0, static_cast<double>(lit.size()) - 2);
  fit.sigma_m = std::sqrt(variance * at.information.inverse()(0, 0));
  return fit;
}

/// The edge by intensities of echoes apart; nothing where they do not fall towards it.
std::optional<LightFit> by_light(const std::vector<LitBeam>& lit, double spacing_m) {
  if (lit.size() < kFewestNear) return std::nullopt;
  double without = 0;
  for (const LitBeam& beam : lit) without += beam.weight * (beam.share - 1) * (beam.share - 1);
  const LightFit fit = fit_light(lit, spacing_m);
  if (!(without > kBetterBy * fit.squares) || !std::isfinite(fit.sigma_m)) return std::nullopt;
  return fit;
}

double typical_gap(std::span<const EdgeBeam> beams) {
  std::vector<double> gaps;
  for (const EdgeBeam& beam : beams) {
    if (beam.state == BeamState::kBeyond && std::isfinite(beam.behind_m)) {
      gaps.push_back(std::abs(beam.behind_m));
    }
  }
  return gaps.empty() ? 0 : middle_of(std::move(gaps));
}

/// Middle and half width of the band of mixed beams in radii of the spot, for the log of the ratio
/// of intensities and of the distances.
struct Band {
  double middle = 0;
  double half_width = 0;
};

Band band_of(double log_ratio, double log_odds) {
  const auto share = [&](double x) { return 1 / (1 + std::exp(-x)); };
  const double first = spot_place(share(log_odds - log_ratio));
  const double last = spot_place(share(-log_odds - log_ratio));
  return {(first + last) / 2, (last - first) / 2};
}

/// How far out the band's middle lies, echoes being one.
double by_band(std::span<const EdgeBeam> beams, const DiscEdge& edge, const Plateaus& plateaus,
               const EdgeLightOptions& options) {
  if (!plateaus.on || !plateaus.beyond) return 0;
  const double log_ratio = std::log(plateaus.on->level / plateaus.beyond->level);
  const double gap = typical_gap(beams);
  if (edge.spot_m > 0.1 * options.spacing_m && gap > 2.5 * options.tolerance_m) {
    const Band band = band_of(log_ratio, std::log(gap / options.tolerance_m - 1));
    return edge.spot_m * band.middle / std::max(band.half_width, 0.1);
  }
  return options.spot_m / 2 * band_of(log_ratio, 0).middle;
}

}  // namespace

double spot_share(double u) {
  if (u <= -1) return 1;
  if (u >= 1) return 0;
  return (std::acos(u) - u * std::sqrt(1 - u * u)) / kPi;
}

double spot_place(double share) {
  double low = -1, high = 1;
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2;
    (spot_share(middle) > share ? low : high) = middle;
  }
  return (low + high) / 2;
}

EdgeShift edge_shift(std::span<const EdgeBeam> beams, const DiscEdge& edge,
                     const EdgeLightOptions& options) {
  const Plateaus plateaus = plateaus_of(beams, edge);
  const double reach = kNear_spacings * options.spacing_m;
  EdgeShift shift;
  for (const bool backed : {true, false}) {
    const auto fit = by_light(near_edge(beams, edge, plateaus, backed, reach), options.spacing_m);
    double& out = backed ? shift.backed_m : shift.unbacked_m;
    if (fit) {
      out = -fit->out_m;
      (backed ? shift.backed_known : shift.unbacked_known) = true;
      shift.sigma_m = std::max(shift.sigma_m, fit->sigma_m);
      shift.spot_m = 2 * fit->spot_radius_m;
    } else if (backed) {
      out = by_band(beams, edge, plateaus, options);
    }
  }
  return shift;
}

}  // namespace scanfuse::calibrate
