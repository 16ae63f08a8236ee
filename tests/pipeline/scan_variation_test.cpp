#include "scanfuse/pipeline/scan_variation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace scanfuse::pipeline {
namespace {

constexpr int kColumns = 101, kLayers = 16;

Scan full_scan() {
  Scan scan;
  scan.beams = BeamPattern{-0.5, 0.01, kColumns, kLayers, 0.1, 100};
  for (int column = 0; column < kColumns; ++column) {
    for (int layer = 0; layer < kLayers; ++layer) {
      const double azimuth = scan.beams->first_azimuth_rad + column * scan.beams->step_rad;
      Return r;
      r.x_m = static_cast<float>(20 * std::cos(azimuth));
      r.y_m = static_cast<float>(20 * std::sin(azimuth));
      r.beam = column;
      r.layer = static_cast<std::int16_t>(layer);
      scan.returns.push_back(r);
    }
  }
  return scan;
}

// Whatever is left out, the pattern tells the azimuth of every return and the number of layers.
TEST(ScanVariationTest, KeepsPatternAndReturnsInAgreement) {
  int changed = 0;
  std::set<int> layers;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    ScanVariation vary(seed);
    Scan scan = full_scan();
    vary(scan);
    const BeamPattern& beams = *scan.beams;
    ASSERT_FALSE(scan.returns.empty());
    for (const Return& r : scan.returns) {
      ASSERT_LT(r.beam, beams.columns);
      ASSERT_LT(r.layer, beams.layers);
      ASSERT_NEAR(std::atan2(r.y_m, r.x_m), beams.first_azimuth_rad + r.beam * beams.step_rad,
                  1e-5);
      ASSERT_NEAR(std::hypot(r.x_m, r.y_m), 20, 0.2);
    }
    layers.insert(beams.layers);
    if (scan.returns.size() != full_scan().returns.size()) ++changed;
  }
  EXPECT_EQ(layers, (std::set<int>{4, 6, 8, 16}));
  EXPECT_GT(changed, 20);
  EXPECT_LT(changed, 55);
}

TEST(ScanVariationTest, IsTheSameForTheSameSeedAndOneSensorsFromEndToEnd) {
  ScanVariation one(5), other(5);
  std::set<int> columns;
  for (int i = 0; i < 5; ++i) {
    Scan a = full_scan(), b = full_scan();
    one(a);
    other(b);
    ASSERT_EQ(a.returns.size(), b.returns.size());
    for (std::size_t k = 0; k < a.returns.size(); ++k) {
      ASSERT_EQ(a.returns[k].x_m, b.returns[k].x_m);
    }
    columns.insert(a.beams->columns);
  }
  EXPECT_EQ(columns.size(), 1U);
}

TEST(ScanVariationTest, LeavesScansOfOneLayerTheirLayer) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    ScanVariation vary(seed);
    Scan scan;
    for (int i = 0; i < 100; ++i) scan.returns.push_back({5, 0, 0, 0, 0, i, 0, 0});
    vary(scan);
    EXPECT_FALSE(scan.beams);
    EXPECT_GT(scan.returns.size(), 60U);
    for (const Return& r : scan.returns) EXPECT_EQ(r.layer, 0);
  }
}

}  // namespace
}  // namespace scanfuse::pipeline
