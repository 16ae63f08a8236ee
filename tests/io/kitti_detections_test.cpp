#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/kitti/detections.hpp"

namespace scanfuse::io {
namespace {

using io_testing::TemporaryFolder;
using ::testing::HasSubstr;

// 10 m ahead of the camera, 2 m to the left, 1.6 m under it, facing right in the picture.
constexpr const char* kBox = "Car -1 -1 -1.5 0 0 10 10 1.5 1.8 4.2 -2 1.6 10 0";
constexpr const char* kCalibration =
    "R_rect 1 0 0 0 1 0 0 0 1\nTr_velo_cam 0 -1 0 0 0 0 -1 0 1 0 0 -0.5\n";

std::string tracking_line(int frame, const std::string& score) {
  return std::to_string(frame) + " -1 " + kBox + " " + score + "\n";
}

Result<std::vector<DetectionFrame>> read(const std::filesystem::path& path,
                                         Diagnostics& diagnostics, KittiOptions options = {}) {
  return read_detections(path, &diagnostics, options);
}

TEST(KittiDetections, StandInTheFrameOfTheLaserAtTenFramesASecond) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto path = folder.write("0000.txt", tracking_line(7, "0.9"));
  ASSERT_TRUE(holds_detections(path));
  const auto frames = read(path, diagnostics);
  ASSERT_TRUE(frames.has_value()) << frames.error().message;
  ASSERT_EQ(frames->size(), 1u);
  EXPECT_EQ(frames->front().frame, 7);
  EXPECT_EQ(frames->front().stamp, time_from_seconds(0.7));
  const Detection& car = frames->front().detections.at(0);
  EXPECT_EQ(car.object_class, ObjectClass::kVehicle);
  EXPECT_NEAR(car.box.centre_m.x(), 10.27, 1e-9);
  EXPECT_NEAR(car.box.centre_m.y(), 2, 1e-9);
  EXPECT_NEAR(car.z_m, -1.6 + 0.75 - 0.08, 1e-9);
  EXPECT_NEAR(car.box.heading_rad, -kPi / 2, 1e-9);
  EXPECT_EQ(car.box.length_m, 4.2);
  EXPECT_EQ(car.score, 0.9);
  EXPECT_EQ(diagnostics.count("no calibration beside the labels: KITTI's usual camera assumed"), 1);
}

TEST(KittiDetections, TheCalibrationNamedPlacesTheCameraAndTheRateTheTime) {
  const TemporaryFolder folder;
  const auto calibration = folder.write("elsewhere.txt", kCalibration);
  Diagnostics diagnostics;
  const auto frames =
      read(folder.write("d.txt", tracking_line(7, "0.9")), diagnostics, {calibration, 20});
  ASSERT_TRUE(frames.has_value()) << frames.error().message;
  EXPECT_EQ(frames->front().stamp, time_from_seconds(0.35));
  EXPECT_NEAR(frames->front().detections.at(0).box.centre_m.x(), 10.5, 1e-9);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(KittiDetections, ACalibrationThatIsNoneIsAnError) {
  const TemporaryFolder folder;
  const auto path = folder.write("d.txt", tracking_line(0, "0.9"));
  Diagnostics diagnostics;
  const auto none = read(path, diagnostics, {folder.write("c.txt", "P0: 1 2 3\n"), 10});
  ASSERT_FALSE(none.has_value());
  EXPECT_THAT(none.error().message, HasSubstr("c.txt: no KITTI calibration"));
  EXPECT_FALSE(read(path, diagnostics, {folder.path() / "missing.txt", 10}).has_value());
}

TEST(KittiDetections, TheCommaTableOfTrackersIsTheSameBox) {
  const TemporaryFolder folder;
  folder.write("calib.txt", kCalibration);
  Diagnostics diagnostics;
  const auto path = folder.write("d.txt",
                                 "7,2,0,0,10,10,0.9,1.5,1.8,4.2,-2,1.6,10,0,-1.5\n"
                                 "7,1,0,0,10,10,0.4,1.7,0.5,0.6,0,1.6,5,-1.5707963,0\n");
  const auto frames = read(path, diagnostics);
  ASSERT_TRUE(frames.has_value()) << frames.error().message;
  ASSERT_EQ(frames->front().detections.size(), 2u);
  const Detection& car = frames->front().detections[0];
  EXPECT_NEAR(car.box.centre_m.x(), 10.5, 1e-9);
  EXPECT_NEAR(car.box.heading_rad, -kPi / 2, 1e-9);
  EXPECT_EQ(car.box.length_m, 4.2);
  EXPECT_EQ(car.score, 0.9);
  EXPECT_EQ(frames->front().detections[1].object_class, ObjectClass::kPedestrian);
}

TEST(KittiDetections, AFolderHasAFrameAFileAlsoWhereNothingWasSeen) {
  const TemporaryFolder folder;
  const std::string line = std::string(kBox) + " 0.9\n";
  folder.write("data/000004.txt", line);
  folder.write("data/000006.txt", "");
  folder.write("data/000007.txt", line + line);
  Diagnostics diagnostics;
  ASSERT_TRUE(holds_detections(folder.path() / "data"));
  const auto frames = read(folder.path() / "data", diagnostics);
  ASSERT_TRUE(frames.has_value()) << frames.error().message;
  std::vector<std::size_t> counts;
  for (const auto& frame : *frames) counts.push_back(frame.detections.size());
  EXPECT_THAT(counts, ::testing::ElementsAre(1, 0, 0, 2));
  EXPECT_EQ(frames->back().frame, 7);
}

TEST(KittiDetections, ScoresBeyondOneAreLogOdds) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto frames =
      read(folder.write("d.txt", tracking_line(0, "0") + tracking_line(0, "12.5")), diagnostics);
  ASSERT_TRUE(frames.has_value());
  EXPECT_EQ(frames->front().detections[0].score, 0.5);
  EXPECT_GT(frames->front().detections[1].score, 0.9999);
  EXPECT_EQ(diagnostics.count("scores outside 0 .. 1: taken as log odds"), 1);
}

TEST(KittiDetections, BrokenLinesAreCountedAndNoGoodOneIsAnErrorWithItsLine) {
  const TemporaryFolder folder;
  Diagnostics some;
  const auto path = folder.write("d.txt", tracking_line(0, "0.9") + "1 -1 Car 0\n" +
                                              tracking_line(2, "nan") + "-3 -1 " + kBox + " 1\n");
  ASSERT_TRUE(read(path, some).has_value());
  EXPECT_EQ(some.count("bad detection line skipped"), 3);
  EXPECT_THAT(some.entries().at("bad detection line skipped").first, HasSubstr("d.txt:2"));
  const auto none = read(folder.write("bad.txt", tracking_line(0, "x")), some);
  ASSERT_FALSE(none.has_value());
  EXPECT_THAT(none.error().message, HasSubstr("bad.txt:1"));
}

TEST(KittiDetections, HugeFrameNumbersAreNotFilledUp) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto frames = read(
      folder.write("d.txt", tracking_line(0, "1") + tracking_line(90'000'000, "1")), diagnostics);
  ASSERT_TRUE(frames.has_value());
  EXPECT_EQ(frames->size(), 2u);
}

TEST(KittiDetections, FlippedTextNeverCrashes) {
  const TemporaryFolder folder;
  RandomStream random(3);
  for (int round = 0; round < 300; ++round) {
    std::string text = round % 2 == 0 ? tracking_line(3, "0.5") + tracking_line(4, "0.5")
                                      : "7,2,0,0,10,10,0.9,1.5,1.8,4.2,-2,1.6,10,0,-1.5\n";
    text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
    Diagnostics diagnostics;
    const auto path = folder.write("d.txt", text);
    if (holds_detections(path)) (void)read(path, diagnostics);
  }
}

}  // namespace
}  // namespace scanfuse::io
