#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/triangulate/closest_points.hpp"
#include "scanfuse/triangulate/costs.hpp"

/// What growing a hypothesis line by line looks at, whichever way it is grown.
namespace scanfuse::triangulate {

inline constexpr double kSlack = 1.2;  ///< first gates are linear: what passes is judged again
inline const double kLogTwoPi = std::log(2 * kPi);

/// chi-square quantiles by degrees of freedom, 0 for none.
class Gate {
 public:
  Gate(double probability, std::size_t sensors);
  [[nodiscard]] double of(int dof) const { return limits_[static_cast<std::size_t>(dof)]; }

 private:
  std::vector<double> limits_;
};

/// Whether two lines are so nearly parallel that their noise leaves the range open.
[[nodiscard]] bool nearly_parallel(const LineOfSight& a, const LineOfSight& b);

/// Where two lines pass each other within `sigmas` (with slack). Nothing for lines that miss each
/// other or are nearly parallel.
[[nodiscard]] std::optional<ClosestPoints> meeting(const LineOfSight& a, const LineOfSight& b,
                                                   double sigmas);

/// A line against the place that others give: d' (R + J P J')^-1 d and |R + J P J'|.
struct Agreement {
  double distance = 0;
  double determinant = 0;  ///< of the first row alone for azimuth only
};
[[nodiscard]] std::optional<Agreement> agreement_of(const LineOfSight& line, const Location& at);

/// Of the chi-square of those lines at their most likely place, 1 at least.
[[nodiscard]] int degrees_of_freedom(std::span<const LineOfSight> lines, const ScenePrior& prior);

[[nodiscard]] double weight_of(const Cost& cost, const Hypothesis& h, const PassiveScene& scene,
                               const ScenePrior& prior);

}  // namespace scanfuse::triangulate
