#include "scanfuse/pipeline/scaled.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scanfuse/pipeline/perception.hpp"

namespace scanfuse::pipeline {
namespace {

/// The rear of a car 1.8 m wide, ten metres ahead and moving off, `size` times as large.
PosedScan rear_of_car(int frame, double size) {
  PosedScan posed;
  posed.scan.stamp = time_from_seconds(1000 + 0.08 * frame);
  posed.scan.frame = frame;
  posed.scan.beams = BeamPattern{radians(-30), radians(0.25), 241, 1, 0, 200};
  const double x = 10 + 0.4 * frame;
  for (int beam = 0; beam < 241; ++beam) {
    const double azimuth = radians(-30 + 0.25 * beam);
    const double y = x * std::tan(azimuth);
    if (std::abs(y) > 0.9) continue;
    Return r;
    r.x_m = static_cast<float>(size * x);
    r.y_m = static_cast<float>(size * y);
    r.beam = beam;
    posed.scan.returns.push_back(r);
  }
  posed.world_from_ego = Pose3::from_planar({3 * size, 2 * size, 0.3});
  posed.ego_from_sensor = Pose3::from_planar({0.5 * size, 0, 0});
  return posed;
}

TEST(Scaled, AModelIsTrackedAsTheRealCarIs) {
  PerceptionOptions options;
  Perception real(options);
  options.pipeline.scale = 0.1;
  Perception model(options);
  for (int frame = 0; frame < 10; ++frame) {
    const auto& large = real.step(rear_of_car(frame, 1)).tracks;
    const auto& small = model.step(rear_of_car(frame, 0.1)).tracks;
    ASSERT_EQ(large.size(), 1u);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_EQ(small[0].status, large[0].status);
    EXPECT_NEAR(10 * small[0].box.centre_m.x(), large[0].box.centre_m.x(), 1e-3);
    EXPECT_NEAR(10 * small[0].box.centre_m.y(), large[0].box.centre_m.y(), 1e-3);
    EXPECT_NEAR(10 * small[0].box.length_m, large[0].box.length_m, 1e-3);
    EXPECT_NEAR(10 * small[0].speed_m_per_s, large[0].speed_m_per_s, 1e-2);
    EXPECT_NEAR(100 * small[0].state.covariance(0, 0), large[0].state.covariance(0, 0), 1e-3);
    EXPECT_NEAR(small[0].box.heading_rad, large[0].box.heading_rad, 1e-3);
  }
}

TEST(Scaled, ResultsTellThePosesAsTheyWereGiven) {
  PerceptionOptions options;
  options.pipeline.scale = 0.1;
  Perception model(options);
  const PosedScan posed = rear_of_car(0, 0.1);
  const StepResult& step = model.step(posed);
  EXPECT_EQ(step.world_from_ego.translation_m, posed.world_from_ego.translation_m);
  EXPECT_EQ(step.ego_from_sensor.translation_m, posed.ego_from_sensor.translation_m);
  ASSERT_FALSE(model.virtual_scan().points.empty());
  EXPECT_NEAR(model.virtual_scan().points[0].x_m, 1, 1e-5);
}

}  // namespace
}  // namespace scanfuse::pipeline
