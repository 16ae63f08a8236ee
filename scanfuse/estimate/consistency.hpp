#pragma once

#include <cstdint>

/// Whether errors are as large as a filter says. NEES and NIS of a consistent filter follow the
/// chi-square distribution; their means over independent samples must lie in a narrow band around
/// the number of degrees of freedom [BarShalom2001, section 5.4].
namespace scanfuse::estimate {

/// P(chi-square with `dof` degrees of freedom <= x): the regularised gamma function
/// P(dof / 2, x / 2), by its series or continued fraction. dof >= 1.
[[nodiscard]] double chi_square_cdf(double x, std::int64_t dof);

/// The x that chi-square with `dof` degrees of freedom stays below with `probability` in (0, 1).
[[nodiscard]] double chi_square_quantile(double probability, std::int64_t dof);

struct Band {
  double low = 0;
  double high = 0;
  [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
};

/// Where the mean of `samples` independent NEES (of `dof` states) or NIS (of `dof` measured
/// numbers) lies with `probability`: the quantiles of chi-square with samples * dof degrees of
/// freedom, divided by `samples`. NEES of one run at different times are not independent; NIS are.
[[nodiscard]] Band mean_chi_square_band(std::int64_t samples, int dof, double probability = 0.95);

}  // namespace scanfuse::estimate
