#include "scanfuse/preprocess/beam_bearings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

Scan pattern(double first_deg, double step_deg, int columns) {
  Scan scan;
  scan.beams = BeamPattern{radians(first_deg), radians(step_deg), columns, 1, 0.1, 100};
  return scan;
}

/// Points at each beam and beside it: how many columns were told, and how many of them wrongly.
struct Told {
  int all = 0, columns = 0, wrong = 0;
};

Told told(const Scan& scan, double yaw_rad, double step_rad) {
  BeamBearings beams;
  beams.prepare(scan, yaw_rad, step_rad);
  RandomStream random(3);
  Told told;
  for (int beam = 0; beam < scan.beams->columns; ++beam) {
    for (int i = 0; i < 50; ++i) {
      const double off = random.uniform(-1, 1) * scan.beams->step_rad;
      const double bearing =
          scan.beams->first_azimuth_rad + yaw_rad + beam * scan.beams->step_rad + off;
      const double range = random.uniform(0.5, 200);
      const auto x = static_cast<float>(range * std::cos(bearing));
      const auto y = static_cast<float>(range * std::sin(bearing));
      const std::uint32_t column = beams.column_of(x, y, beam);
      ++told.all;
      if (column == BeamBearings::kNoColumn) continue;
      ++told.columns;
      told.wrong += column != beams.layout().at(beams.bearing_of(x, y, beam)) ? 1 : 0;
    }
  }
  return told;
}

TEST(BeamBearings, AColumnToldByTheBeamIsThatOfTheBearing) {
  for (const auto& scan :
       {pattern(-59.875, 0.25, 440), pattern(-180, 1, 360), pattern(-135, 0.5, 541),
        pattern(-90, 0.0573, 3000), pattern(-180, 20, 18), pattern(-1, 0.001, 2000)}) {
    for (const double yaw : {0.0, 0.3, 3.1}) {
      for (const double step : {0.0, 0.004, 0.02}) {
        EXPECT_EQ(told(scan, yaw, step).wrong, 0)
            << scan.beams->columns << ' ' << yaw << ' ' << step;
      }
    }
  }
}

TEST(BeamBearings, PointsNearTheirBeamNeedNoBearing) {
  const Told t = told(pattern(-59.875, 0.25, 440), 0.1, 0);
  EXPECT_NEAR(static_cast<double>(t.columns) / t.all, 0.4, 0.02);
}

TEST(BeamBearings, ABearingIsThatOfTheArcTangent) {
  BeamBearings beams;
  beams.prepare(pattern(-180, 0.5, 720), 0, 0);
  RandomStream random(4);
  for (int i = 0; i < 10'000; ++i) {
    const auto x = static_cast<float>(random.uniform(-50, 50));
    const auto y = static_cast<float>(random.uniform(-50, 50));
    const int beam = static_cast<int>(random.uniform(-5, 725));
    EXPECT_NEAR(wrap_pi(beams.bearing_of(x, y, beam) - std::atan2(y, x)), 0, 1.2e-5);
  }
}

TEST(BeamBearings, APatternThatMakesNoSenseCountsAsNone) {
  BeamBearings beams;
  beams.prepare(pattern(0, 0.25, 440), 0, 0);
  EXPECT_FALSE(beams.empty());
  for (const auto& scan :
       {pattern(0, 0, 10), pattern(0, 0.25, 0), pattern(std::nan(""), 0.25, 10), Scan{}}) {
    beams.prepare(scan, 0, 0);
    EXPECT_TRUE(beams.empty());
  }
}

}  // namespace
}  // namespace scanfuse::preprocess
