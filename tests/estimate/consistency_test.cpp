#include "scanfuse/estimate/consistency.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanfuse::estimate {
namespace {

// Quantiles printed in tables, and closed forms for one and two degrees of freedom.
TEST(ChiSquare, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(chi_square_quantile(0.025, 4), 0.4844185570879299, 1e-13);
  EXPECT_NEAR(chi_square_quantile(0.975, 4), 11.143286781877796, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.999, 2), -2 * std::log(0.001), 1e-11);
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841458820694124, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.95, 100), 124.34211340400407, 1e-9);
}

TEST(ChiSquare, QuantileUndoesTheDistribution) {
  for (const std::int64_t dof : {1, 2, 3, 6, 50, 2000, 100000}) {
    for (const double p : {1e-6, 0.025, 0.5, 0.975, 1 - 1e-6}) {
      EXPECT_NEAR(chi_square_cdf(chi_square_quantile(p, dof), dof), p, 1e-10) << dof << " " << p;
    }
  }
  EXPECT_NEAR(chi_square_cdf(2 * 0.7, 1), std::erf(std::sqrt(0.7)), 1e-14);
  EXPECT_EQ(chi_square_cdf(0, 3), 0);
}

TEST(ChiSquare, BandOfAMeanNarrowsWithTheRootOfTheSamples) {
  const Band band = mean_chi_square_band(500, 4);
  EXPECT_NEAR(band.low, 4 - 1.96 * std::sqrt(8.0 / 500), 0.005);
  EXPECT_NEAR(band.high, 4 + 1.96 * std::sqrt(8.0 / 500), 0.005);
  EXPECT_TRUE(band.contains(4));
  EXPECT_FALSE(band.contains(band.high + 1e-9));
}

}  // namespace
}  // namespace scanfuse::estimate
