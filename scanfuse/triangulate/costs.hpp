#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "scanfuse/triangulate/locate.hpp"
#include "scanfuse/triangulate/prior.hpp"

/// What it is worth to believe that bearings of different sensors are of one target: a weight,
/// larger for better, 0 for calling all of them false alarms. A cost of the paper is its negative.
/// All policies agree on what they are given and differ in what they make of it.
namespace scanfuse::triangulate {

/// A hypothesis: one line of sight each of two or more sensors, ascending by sensor, and where they
/// say that the target is.
struct Hypothesis {
  std::span<const LineOfSight> lines;
  const Location& location;
};

/// Bayesian evidence by Laplace's method, the default:
///   w = ln rho + sum ln PD + sum_missed ln(1 - PD) - chi2 / 2 - sum ln |2 pi R| / 2
///       + ln |2 pi P| / 2 + ln Pr(x in volume) - sum ln lambda
/// rho: targets per m^3, lambda: false alarms per sr; a sensor that does not look there missed
/// nothing.
struct EvidenceCost {
  [[nodiscard]] double operator()(const Hypothesis& h, const PassiveScene& scene,
                                  const ScenePrior& prior) const;
};

/// Statistical distance between measurements and pseudo-measurements [Lu2015, eq. 7], with
/// |2 pi R|^(1/2) for the print's sqrt(2 pi) |R| and each detection divided by the clutter density.
struct ClassicCost {
  [[nodiscard]] double operator()(const Hypothesis& h, const PassiveScene& scene,
                                  const ScenePrior& prior) const;
};

/// Symmetric Renyi divergence of order alpha between a measurement and its pseudo-measurement
/// [Lu2015, eqs. 19-21] in place of the distance; at 1 it is the symmetric Kullback-Leibler
/// divergence. Position by least squares, its covariance corrected.
struct RenyiCost {
  double alpha = 0.5;
  [[nodiscard]] double operator()(const Hypothesis& h, const PassiveScene& scene,
                                  const ScenePrior& prior) const;
};

/// The same as printed: eq. 13's covariance, eq. 20's ratio upside down, sqrt(2 pi) |R|, no clutter
/// density, and misses that cost nothing; only a sensor with PD = 1 must take part.
struct RenyiLiteralCost {
  double alpha = 0.5;
  [[nodiscard]] double operator()(const Hypothesis& h, const PassiveScene& scene,
                                  const ScenePrior& prior) const;
};

/// Each measurement against the position of the others, d' (R + J P J')^-1 d: what eq. 18 would be
/// right for. Two sensors leave one each: they are weighed as in ClassicCost.
struct LeaveOneOutCost {
  [[nodiscard]] double operator()(const Hypothesis& h, const PassiveScene& scene,
                                  const ScenePrior& prior) const;
};

enum class CostMethod {
  kEvidence,
  kClassic,
  kRenyiLiteral,
  kRenyi,
  kKullbackLeibler,
  kLeaveOneOut
};

constexpr auto choices(CostMethod) {
  using enum CostMethod;
  return std::array{
      std::pair{"evidence", kEvidence},          std::pair{"classic", kClassic},
      std::pair{"renyi_literal", kRenyiLiteral}, std::pair{"renyi", kRenyi},
      std::pair{"kl", kKullbackLeibler},         std::pair{"leave_one_out", kLeaveOneOut}};
}

using Cost = std::variant<EvidenceCost, ClassicCost, RenyiCost, RenyiLiteralCost, LeaveOneOutCost>;

/// `alpha` in (0, 1] for the two of Renyi's; the literal one takes at most 0.999.
[[nodiscard]] Cost make_cost(CostMethod method, double alpha = 0.5);

}  // namespace scanfuse::triangulate
