// Images by others, where they are at hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scanfuse/camera/boards.hpp"
#include "scanfuse/camera/stripe.hpp"
#include "scanfuse/io/image.hpp"

namespace scanfuse::camera {
namespace {

namespace fs = std::filesystem;
const fs::path kData = fs::path(SCANFUSE_SHARED_DATA) / "calibration";

std::vector<fs::path> images_in(const std::string& folder, const std::string& start = "") {
  std::vector<fs::path> files;
  if (!fs::exists(kData / folder)) return files;
  for (const auto& entry : fs::directory_iterator(kData / folder)) {
    const auto ending = entry.path().extension();
    const bool image = ending == ".png" || ending == ".jpg";
    if (image && entry.path().filename().string().starts_with(start)) files.push_back(entry);
  }
  std::sort(files.begin(), files.end());
  return files;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 1e9 : values[values.size() / 2];
}

#define SKIP_WITHOUT(files) \
  if ((files).empty()) GTEST_SKIP() << "no shared data: skipped"

TEST(RealImages, EveryBoardBesideALidarIsFound) {
  const auto files = images_in("acfr_2dlidar");
  SKIP_WITHOUT(files);
  for (const auto& file : files) {
    const auto board = find_board(*io::read_image(file), {8, 11, 0.03});
    EXPECT_TRUE(board) << file;
  }
}

TEST(RealImages, EveryBoardUnderAStripeIsFound) {
  const auto files = images_in("hjamal3");
  SKIP_WITHOUT(files);
  for (const auto& file : files) {
    const auto board = find_board(*io::read_image(file), {6, 8, 0.03});
    EXPECT_TRUE(board) << file;
  }
}

TEST(RealImages, StripesOnAChessboardAreStraight) {
  auto files = images_in("srv_turntable/laser");
  SKIP_WITHOUT(files);
  files.resize(std::min<std::size_t>(files.size(), 12));
  std::vector<double> scatter;
  StripeOptions options;
  options.margin_squares = 2.6;
  for (const auto& file : files) {
    const auto image = io::read_image(file);
    ASSERT_TRUE(image) << image.error().message;
    const auto board = find_board(*image, {6, 8, 0.04});
    if (!board) continue;
    const auto stripes = find_stripes(*image, nullptr, std::span(&*board, 1), options);
    ASSERT_TRUE(stripes);
    if (stripes->front().found()) scatter.push_back(stripes->front().scatter_px);
  }
  EXPECT_GE(scatter.size(), 5U);
  EXPECT_LE(median(scatter), 0.12);
}

TEST(RealImages, SaturatedStripesAreStraight) {
  const auto files = images_in("zhaocongyang_pairs", "light");
  SKIP_WITHOUT(files);
  const std::vector<Eigen::Vector2d> region{{200, 150}, {1100, 150}, {1100, 1000}, {200, 1000}};
  std::vector<double> scatter;
  for (const auto& file : files) {
    std::string twin = file.filename().string();
    twin.replace(0, 5, "calib");
    const auto on = io::read_image(file), off = io::read_image(file.parent_path() / twin);
    ASSERT_TRUE(on && off);
    const auto stripe = find_stripe(*on, &*off, region);
    ASSERT_TRUE(stripe);
    EXPECT_TRUE(stripe->found()) << file << stripe->reason;
    EXPECT_GT(stripe->saturated_share, 0.3);
    scatter.push_back(stripe->scatter_px);
  }
  EXPECT_LT(median(scatter), 0.5);
}

}  // namespace
}  // namespace scanfuse::camera
