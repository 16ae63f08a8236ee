#include "scanfuse/estimate/turn_moments.hpp"

#include <array>
#include <cmath>

namespace scanfuse::estimate {
namespace {

constexpr int kTerms = 9;
using Series = std::array<double, kTerms>;

/// (-1)^n / ((2n+odd)! (2n+odd+k+1))
constexpr Series series(int k, int odd) {
  Series terms{};
  double factorial = 1, sign = 1;
  for (int n = 0; n < kTerms; ++n, sign = -sign) {
    if (n > 0) factorial *= (2.0 * n + odd) * (2.0 * n + odd - 1);
    terms[n] = sign / (factorial * (2 * n + odd + k + 1));
  }
  return terms;
}

constexpr Series kA0 = series(0, 0), kA1 = series(1, 0), kA2 = series(2, 0);
constexpr Series kB0 = series(0, 1), kB1 = series(1, 1), kB2 = series(2, 1);

double horner(const Series& terms, double x) {
  double sum = terms[kTerms - 1];
  for (int n = kTerms - 2; n >= 0; --n) sum = sum * x + terms[n];
  return sum;
}

}  // namespace

TurnMoments turn_moments(double th) {
  const double th2 = th * th;
  if (th2 < 1) {
    return {horner(kA0, th2),      horner(kA1, th2),      horner(kA2, th2),
            th * horner(kB0, th2), th * horner(kB1, th2), th * horner(kB2, th2)};
  }
  const double s = std::sin(th), c = std::cos(th), th3 = th2 * th;
  return {s / th,       (th * s + c - 1) / th2, (th2 * s + 2 * th * c - 2 * s) / th3,
          (1 - c) / th, (s - th * c) / th2,     (2 * th * s + (2 - th2) * c - 2) / th3};
}

}  // namespace scanfuse::estimate
