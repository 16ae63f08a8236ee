#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

/// Sums of numbers that are known by their logarithms, of any size.
namespace scanfuse::associate {

/// ln 0
inline constexpr double kNever = -std::numeric_limits<double>::infinity();

/// ln(exp(a) + exp(b))
[[nodiscard]] inline double log_add(double a, double b) {
  if (a < b) std::swap(a, b);
  return b == kNever ? a : a + std::log1p(std::exp(b - a));
}

/// others[i] = ln(1 + sum over j != i of exp(terms[j])): by sums from both ends, since taking one
/// term away from the whole sum would leave no digits where it is the largest.
inline void one_plus_others(std::span<const double> terms, std::span<double> others) {
  double after = kNever;
  for (std::size_t i = terms.size(); i-- > 0;) {
    others[i] = after;
    after = log_add(after, terms[i]);
  }
  double before = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    others[i] = log_add(others[i], before);
    before = log_add(before, terms[i]);
  }
}

}  // namespace scanfuse::associate
