#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scanfuse/evaluate/clear.hpp"

namespace scanfuse::evaluate {

/// Root mean squares of estimate minus truth over the matched pairs, each over those pairs whose
/// truth has the value; none where no pair has it.
struct RmseMetrics {
  std::optional<double> position_m;
  std::optional<double> velocity_m_per_s;
  std::optional<double> heading_rad;         ///< full turn
  std::optional<double> heading_mod_pi_rad;  ///< front and rear alike
  std::optional<double> length_m;
  std::optional<double> width_m;
  std::optional<double> heading_reversed_share;  ///< off by more than 90 degrees
  std::int64_t pairs = 0;
};

/// How far the covariances can be believed [BarShalom2001, ch. 5].
struct ConsistencyMetrics {
  /// Mean of e' P^-1 e, e the error of x, vx, y, vy: 4 for a consistent filter (not divided by 4).
  std::optional<double> anees;
  std::optional<double> nees_median;  ///< 3.36 for a consistent filter
  /// Mean of Track::nis over the tracks that took in a detection: 2 for a consistent filter.
  std::optional<double> anis;
  /// Share of the NEES between the 2.5 and 97.5 % points of chi-square with 4 degrees of freedom.
  std::optional<double> nees_inside_95;
  std::int64_t nees_samples = 0;
  std::int64_t nis_samples = 0;
};

/// Squared error of the four states in units of the covariance; none when truth has no velocity or
/// the covariance is not positive definite (files that do not carry all of it leave zeros).
[[nodiscard]] std::optional<double> nees(const Track& track, const TruthObject& truth);

[[nodiscard]] RmseMetrics rmse_metrics(const Sequence& sequence,
                                       const std::vector<std::vector<MatchedPair>>& matches);
[[nodiscard]] ConsistencyMetrics consistency_metrics(
    const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches);

}  // namespace scanfuse::evaluate
