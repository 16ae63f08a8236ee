#include "camera/rendered.hpp"

#include <gtest/gtest.h>

namespace scanfuse::camera {
namespace {

using camera_testing::StripeErrors;
using camera_testing::StripeTruth;
using simulate::TurntableImageOptions;

struct Case {
  std::string name;
  TurntableImageOptions options;
  bool twins = false;  ///< with images of the laser off
  double rms_px = 0.15;
};

TurntableImageOptions with(std::initializer_list<std::pair<const char*, const char*>> settings) {
  TurntableImageOptions options;
  for (const auto& [name, value] : settings) {
    EXPECT_TRUE(set_option(options, name, value)) << name;
  }
  return options;
}

std::vector<Case> cases() {
  return {{"Plain", with({})},
          {"Saturated", with({{"laser_counts", "1500"}})},
          {"Faint", with({{"laser_counts", "30"}})},
          {"Mosaic", with({{"sensor", "rggb"}})},
          {"Blurred", with({{"blur_px", "1.5"}})},
          {"LitUnevenly", with({{"ambient_counts", "15"}, {"gradient", "0.8"}})},
          {"BrightWithTwins", with({{"ambient_counts", "60"}, {"gradient", "0.8"}}), true}};
}

class Rendered : public testing::TestWithParam<Case> {};

TEST_P(Rendered, CornersAndStripesLieWhereTheyAre) {
  const Case& c = GetParam();
  const auto world = simulate::turntable_world();
  const simulate::TurntableRenderer renderer(world, c.options, 20);
  const auto boards = find_two_boards(renderer.bright(), world.boards);
  ASSERT_TRUE(boards) << boards.error().message;
  for (std::size_t b = 0; b < 2; ++b) {
    const double error = camera_testing::corner_error(world, b, (*boards)[b]);
    EXPECT_LE(error, 0.07) << "board " << b;
    EXPECT_GT((*boards)[b].sigma_px, error / 2);
    EXPECT_LT((*boards)[b].sigma_px, error * 2);
  }
  StripeErrors errors;
  for (const std::size_t position : {5U, 60U}) {
    const double turned = world.turntable_rad[position];
    const Image on = renderer.stripe(position, turned);
    const Image off = renderer.laser_off(position);
    const auto stripes = find_stripes(on, c.twins ? &off : nullptr, *boards);
    ASSERT_TRUE(stripes) << stripes.error().message;
    for (std::size_t b = 0; b < 2; ++b) {
      errors.add(StripeTruth(world, b, turned), (*stripes)[b]);
      // A wide stripe along a border of squares has no point off it.
      if (!(*stripes)[b].found()) {
        EXPECT_NE((*stripes)[b].reason.find("borders of squares"), std::string::npos)
            << (*stripes)[b].reason;
        continue;
      }
      const bool raw = c.options.sensor == simulate::Sensor::kRggb;
      EXPECT_EQ((*stripes)[b].mosaic, raw ? Mosaic::kRggb : Mosaic::kNone);
    }
  }
  EXPECT_LE(errors.missing, 1);
  EXPECT_GT(errors.count, 60);
  EXPECT_LE(errors.rms(), c.rms_px);
  EXPECT_LE(std::abs(errors.mean()), 0.05);
  if (c.name == "Saturated") {
    EXPECT_GT(errors.saturated, 0.3);
  }
  std::printf("%s: stripe rms %.3f px, mean %.3f, on white %.3f, on black %.3f, %d points\n",
              c.name.c_str(), errors.rms(), errors.mean(), errors.mean_on(0), errors.mean_on(1),
              errors.count);
}

INSTANTIATE_TEST_SUITE_P(Session, Rendered, testing::ValuesIn(cases()),
                         [](const auto& param) { return param.param.name; });

TEST(Stripe, IsNotSeenWhereTheLaserIsOff) {
  const auto world = simulate::turntable_world();
  const simulate::TurntableRenderer renderer(world, {}, 3);
  const auto boards = find_two_boards(renderer.bright(), world.boards);
  ASSERT_TRUE(boards);
  const auto stripes = find_stripes(renderer.laser_off(0), nullptr, *boards);
  ASSERT_TRUE(stripes);
  for (const auto& stripe : *stripes) {
    EXPECT_FALSE(stripe.found());
    EXPECT_FALSE(stripe.reason.empty());
  }
}

TEST(Stripe, ImagesOfDifferentSizeAreRefused) {
  const Image on{20, 20, 1, std::vector<std::uint8_t>(400)};
  const Image off{20, 10, 1, std::vector<std::uint8_t>(200)};
  EXPECT_FALSE(find_stripes(on, &off, {}));
}

TEST(Stripe, ABoardOfAnotherImageIsRefused) {
  const Image on{20, 20, 1, std::vector<std::uint8_t>(400)};
  DetectedBoard board;
  board.spec = {2, 2, 0.02};
  board.corners_px = {{1, 1}, {500, 1}, {1, 500}, {500, 500}};
  const auto stripes = find_stripes(on, nullptr, std::span(&board, 1));
  ASSERT_FALSE(stripes);
  EXPECT_NE(stripes.error().message.find("another camera"), std::string::npos);
}

TEST(FindTwoBoards, AWrongSizeIsAnErrorThatCountsWhatIsThere) {
  const auto world = simulate::turntable_world();
  const simulate::TurntableRenderer renderer(world, {}, 3);
  const auto boards =
      find_two_boards(renderer.bright(), {BoardSpec{15, 21, 0.02}, BoardSpec{15, 21, 0.02}});
  ASSERT_FALSE(boards);
  EXPECT_NE(boards.error().message.find("15 x 21"), std::string::npos) << boards.error().message;
}

TEST(FindBoard, AnEmptyImageHasNone) {
  EXPECT_FALSE(find_board(Image{64, 64, 1, std::vector<std::uint8_t>(4096, 90)}, {6, 8, 0.03}));
  EXPECT_FALSE(find_board(Image{}, {6, 8, 0.03}));
  EXPECT_FALSE(find_board(Image{64, 64, 1, std::vector<std::uint8_t>(4096, 90)}, {0, 8, 0.03}));
}

}  // namespace
}  // namespace scanfuse::camera
