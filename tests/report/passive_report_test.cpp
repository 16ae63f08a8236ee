#include "scanfuse/report/passive_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace scanfuse::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<PassiveSensor> two_sensors() {
  std::vector<PassiveSensor> sensors(2);
  sensors[0].name = "west";
  sensors[1].name = "east";
  sensors[1].world_from_sensor.translation_m.x() = 1000;
  return sensors;
}

PassiveView one_target() {
  PassiveView view;
  Fix fix;
  fix.position_m = {500, 500, 100};
  fix.covariance_m2 = Eigen::Vector3d(100, 400, 25).asDiagonal();
  view.fixes = {fix};
  view.lines = {{{0, 0, 0}, Eigen::Vector3d(1, 1, 0.2).normalized(), 0},
                {{1000, 0, 0}, Eigen::Vector3d(-1, 1, 0.2).normalized(), 0},
                {{0, 0, 0}, Eigen::Vector3d(0, 1, 0), -1}};
  view.truth_m = {{502, 497, 101}};
  return view;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(PassiveMap, DrawsEachFixWithItsEllipseAndEachTruth) {
  const auto map = passive_map(one_target(), two_sensors(), ViewFrom::kAbove);
  EXPECT_EQ(count_of(map, "<ellipse"), 1U);
  EXPECT_EQ(count_of(map, "r=\"5.5\""), 1U);
  EXPECT_THAT(map, HasSubstr(">west</text>"));
}

// 95 % of a plane's Gaussian lie within sqrt(5.991) sigma.
TEST(PassiveMap, ScalesTheEllipseAsItsAxes) {
  const auto map = passive_map(one_target(), two_sensors(), ViewFrom::kAbove);
  const auto number = [&](const char* name) {
    const auto at = map.find(name, map.find("<ellipse"));
    return std::stod(map.substr(at + std::string(name).size()));
  };
  EXPECT_NEAR(number("rx=\"") / number("ry=\""), 2, 0.01);
  const double metres_a_pixel = 20 * std::sqrt(5.991) / number("rx=\"");
  EXPECT_NEAR(metres_a_pixel, 1160.0 / 1090, 0.02);  // the view's 1160 m on 1090 pixels
}

TEST(PassiveMap, CrossesGhostsOut) {
  PassiveView view = one_target();
  const auto real = passive_map(view, two_sensors(), ViewFrom::kSide);
  view.ghosts = {true};
  const auto ghost = passive_map(view, two_sensors(), ViewFrom::kSide);
  EXPECT_EQ(count_of(real, "m-6 -6"), 0U);
  EXPECT_EQ(count_of(ghost, "m-6 -6"), 1U);
}

TEST(PassiveMap, StandsWithoutAnythingSeenAndWithSensorsAtOnePlace) {
  const std::vector<PassiveSensor> together(2);
  for (const auto from : {ViewFrom::kAbove, ViewFrom::kSide}) {
    const auto map = passive_map({}, together, from);
    EXPECT_THAT(map, HasSubstr("</svg>"));
    EXPECT_THAT(map, Not(HasSubstr("nan")));
    EXPECT_THAT(map, Not(HasSubstr("inf")));
  }
}

TEST(PassivePage, EscapesWhatItIsGivenAndNeedsNoOtherFile) {
  auto sensors = two_sensors();
  sensors[0].name = "<script>";
  const auto page = passive_page("a<b", "c&d", sensors, {{"t<", {"x"}, {{"<i>"}}}},
                                 {{"scan <1>", one_target(), {}, {}}});
  EXPECT_THAT(page, HasSubstr("a&lt;b"));
  EXPECT_THAT(page, Not(HasSubstr("<script>")));
  EXPECT_THAT(page, Not(HasSubstr("<i>")));
  EXPECT_THAT(page, Not(HasSubstr("http")));
}

}  // namespace
}  // namespace scanfuse::report
