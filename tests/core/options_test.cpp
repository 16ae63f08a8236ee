#include "scanfuse/core/options.hpp"

#include <gtest/gtest.h>

namespace scanfuse {
namespace {

enum class Colour { kRed, kGreen };
constexpr auto choices(Colour) {
  return std::array{std::pair{"red", Colour::kRed}, std::pair{"green", Colour::kGreen}};
}

struct SampleOptions {
  double radius_m = 0.5;
  int min_points = 8;
  bool enabled = true;
  Colour colour = Colour::kRed;
  std::string topic = "/scan";

  static constexpr auto fields() {
    using O = SampleOptions;
    return std::tuple{
        Field{"radius_m", &O::radius_m, 0.01, 10.0, "neighbour distance"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
        Field{"enabled", &O::enabled, "whether it runs"},
        Field{"colour", &O::colour, "of the paint"},
        Field{"topic", &O::topic, "where scans come from"},
    };
  }
};

TEST(Options, EveryKindOfValueIsSetFromText) {
  SampleOptions options;
  EXPECT_TRUE(set_option(options, "radius_m", "1.25"));
  EXPECT_TRUE(set_option(options, "min_points", "3"));
  EXPECT_TRUE(set_option(options, "enabled", "false"));
  EXPECT_TRUE(set_option(options, "colour", "green"));
  EXPECT_TRUE(set_option(options, "topic", "/front"));
  EXPECT_EQ(options.radius_m, 1.25);
  EXPECT_EQ(options.min_points, 3);
  EXPECT_FALSE(options.enabled);
  EXPECT_EQ(options.colour, Colour::kGreen);
  EXPECT_EQ(options.topic, "/front");
}

TEST(Options, AnUnknownNameIsAnsweredWithTheNearestKnownOne) {
  SampleOptions options;
  const auto outcome = set_option(options, "radius", "1");
  ASSERT_FALSE(outcome);
  EXPECT_NE(outcome.error().message.find("'radius_m'"), std::string::npos);
}

TEST(Options, ValuesOutOfRangeAreRefusedAndLeaveTheOptionAlone) {
  SampleOptions options;
  for (const auto* text : {"0", "11", "nan", "inf", "-inf", "1e400", "", "1 m"}) {
    EXPECT_FALSE(set_option(options, "radius_m", text)) << text;
  }
  EXPECT_EQ(options.radius_m, 0.5);
}

TEST(Options, ViewsCarryDefaultsRangesAndDocs) {
  SampleOptions options;
  options.min_points = 4;
  const auto views = view_options("sample", options);
  ASSERT_EQ(views.size(), 5u);
  EXPECT_EQ(views[1].value, "4");
  EXPECT_EQ(views[1].fallback, "8");
  EXPECT_EQ(views[1].range, "1 .. 1000");
  EXPECT_EQ(views[3].range, "red | green");
  EXPECT_TRUE(views[3].quoted);
  EXPECT_FALSE(views[2].quoted);
}

}  // namespace
}  // namespace scanfuse
