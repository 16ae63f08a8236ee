#include <gtest/gtest.h>

#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/kitti/labels.hpp"
#include "scanfuse/io/tables.hpp"

namespace scanfuse::io {
namespace {

using io_testing::TemporaryFolder;

// 10 m ahead of the camera, 2 m to the left, 1.6 m under it, facing right in the picture.
constexpr const char* kCar = "7 3 Car 0 1 -1.5 0 0 10 10 1.5 1.8 4.2 -2 1.6 10 0\n";

TEST(KittiLabels, AreTruthInTheFrameOfTheLaser) {
  const TemporaryFolder folder;
  const auto path = folder.write("0000.txt", std::string(kCar) +
                                                 "7 -1 DontCare -1 -1 -10 0 0 1 1 -1 -1 -1 -1000 "
                                                 "-1000 -1000 -10\n"
                                                 "8 4 Pedestrian 0 0 0 0 0 1 1 1.7 0.5 0.6 0 1.6 5 "
                                                 "-1.5707963 0.9\n");
  Diagnostics diagnostics;
  ASSERT_EQ(table_kind(path), TableKind::kTruth);
  const auto truth = read_truth(path, &diagnostics);
  ASSERT_TRUE(truth.has_value()) << truth.error().message;
  ASSERT_EQ(truth->size(), 2u);
  const TruthFrame& frame = truth->front();
  EXPECT_EQ(frame.frame, 7);
  EXPECT_EQ(frame.stamp, time_from_seconds(0.7));
  EXPECT_EQ(frame.coordinate_frame, "ego");
  ASSERT_EQ(frame.objects.size(), 1u);
  const TruthObject& car = frame.objects[0];
  EXPECT_EQ(car.id, 3);
  EXPECT_EQ(car.object_class, ObjectClass::kVehicle);
  EXPECT_NEAR(car.position_m.x(), 10.27, 1e-9);
  EXPECT_NEAR(car.position_m.y(), 2, 1e-9);
  EXPECT_NEAR(car.z_m, -1.6 + 0.75 - 0.08, 1e-9);
  EXPECT_NEAR(*car.heading_rad, -kPi / 2, 1e-9);
  EXPECT_EQ(*car.length_m, 4.2);
  EXPECT_EQ(*car.occluded, 1);
  EXPECT_EQ(truth->back().objects[0].object_class, ObjectClass::kPedestrian);
  EXPECT_NEAR(*truth->back().objects[0].heading_rad, 0, 1e-6);
  EXPECT_EQ(diagnostics.count("no calibration beside the labels: KITTI's usual camera assumed"), 1);
}

TEST(KittiLabels, TheCalibrationBesideThemPlacesTheCamera) {
  const TemporaryFolder folder;
  folder.write("calib.txt", "R_rect 1 0 0 0 1 0 0 0 1\nTr_velo_cam 0 -1 0 0 0 0 -1 0 1 0 0 -0.5\n");
  const auto path = folder.write("labels.txt", kCar);
  Diagnostics diagnostics;
  const auto truth = read_truth(path, &diagnostics);
  ASSERT_TRUE(truth.has_value());
  EXPECT_NEAR(truth->front().objects[0].position_m.x(), 10.5, 1e-9);
  EXPECT_NEAR(truth->front().objects[0].position_m.y(), 2, 1e-9);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(KittiLabels, BrokenLinesAreSkippedAndCounted) {
  const TemporaryFolder folder;
  const auto path = folder.write("labels.txt", std::string(kCar) + "8 3 Car 0 1\n" +
                                                   "9 3 Car 0 1 0 0 0 1 1 nan 1 1 1 1 1 0\n");
  Diagnostics diagnostics;
  const auto truth = read_truth(path, &diagnostics);
  ASSERT_TRUE(truth.has_value());
  EXPECT_EQ(diagnostics.count("bad label line skipped"), 2);
  EXPECT_TRUE(diagnostics.any_damage());
}

TEST(KittiLabels, FlippedTextNeverCrashes) {
  const TemporaryFolder folder;
  RandomStream random(3);
  for (int round = 0; round < 300; ++round) {
    std::string text = std::string(kCar) + kCar;
    text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
    Diagnostics diagnostics;
    (void)read_truth(folder.write("labels.txt", text), &diagnostics);
  }
}

}  // namespace
}  // namespace scanfuse::io
