#include "scanfuse/estimate/consistency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::estimate {
namespace {

/// ln Gamma(x), x > 0: Stirling's series from 15 on. Not std::lgamma, which writes to a global.
double log_gamma(double x) {
  double shift = 0;
  for (; x < 15; ++x) shift += std::log(x);
  const double r = 1 / x, r2 = r * r;
  const double tail =
      r * (1.0 / 12 - r2 * (1.0 / 360 - r2 * (1.0 / 1260 - r2 * (1.0 / 1680 - r2 / 1188))));
  return (x - 0.5) * std::log(x) - x + 0.5 * std::log(2 * kPi) + tail - shift;
}

/// x^a e^-x / Gamma(a)
double front(double a, double x) { return std::exp(a * std::log(x) - x - log_gamma(a)); }

double lower_gamma_series(double a, double x) {
  double term = 1 / a, sum = term;
  for (double n = a + 1; term > sum * 1e-17; ++n) sum += term *= x / n;
  return sum * front(a, x);
}

/// Lentz's method.
double upper_gamma_fraction(double a, double x) {
  constexpr double kTiny = 1e-300;
  double b = x + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
  for (int i = 1; i < 100000; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = an * d + b;
    d = 1 / (std::abs(d) < kTiny ? kTiny : d);
    c = b + an / c;
    if (std::abs(c) < kTiny) c = kTiny;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-16) break;
  }
  return h * front(a, x);
}

}  // namespace

double chi_square_cdf(double x, std::int64_t dof) {
  if (!(x > 0)) return 0;
  const double a = 0.5 * static_cast<double>(dof), half = 0.5 * x;
  return half < a + 1 ? lower_gamma_series(a, half) : 1 - upper_gamma_fraction(a, half);
}

double chi_square_quantile(double probability, std::int64_t dof) {
  double low = 0, high = static_cast<double>(dof) + 10;
  while (chi_square_cdf(high, dof) < probability) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_square_cdf(middle, dof) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Band mean_chi_square_band(std::int64_t samples, int dof, double probability) {
  const double tail = 0.5 * (1 - probability), n = static_cast<double>(samples);
  return {chi_square_quantile(tail, samples * dof) / n,
          chi_square_quantile(1 - tail, samples * dof) / n};
}

}  // namespace scanfuse::estimate
