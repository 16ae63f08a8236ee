#pragma once

#include <cmath>

namespace scanfuse::associate {

/// The squared Mahalanobis distance that a measurement of two dimensions stays below with the given
/// probability in [0, 1): chi-square with two degrees of freedom, -2 ln(1 - p). 0.999 gives 13.8.
[[nodiscard]] inline double gate_in_the_plane(double probability) {
  return -2.0 * std::log1p(-probability);
}

}  // namespace scanfuse::associate
