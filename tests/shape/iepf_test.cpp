#include "scanfuse/shape/iepf.hpp"

#include <gtest/gtest.h>

#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/shape/line_fit.hpp"

namespace scanfuse::shape {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Points corner_points() {
  Points points;
  for (int i = 0; i <= 8; ++i) points.emplace_back(10.0, -1.0 + 0.25 * i);  // vertical in x, y
  for (int i = 1; i <= 16; ++i) points.emplace_back(10.0 + 0.25 * i, 1.0);
  return points;
}

TEST(Iepf, ACornerGivesTwoLinesThatMeetThere) {
  for (const auto& lines : {iepf_literal(corner_points(), 0.3), [] {
                              Iepf iepf;
                              const auto found = iepf(corner_points(), 0.02);
                              return std::vector<LineSegment>(found.begin(), found.end());
                            }()}) {
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NEAR(lines[0].length_m(), 2.0, 0.3);
    EXPECT_NEAR(lines[1].length_m(), 4.0, 0.3);
    EXPECT_NEAR(std::abs(wrap_half_pi(lines[0].direction_rad() - lines[1].direction_rad())),
                kPi / 2, 0.15);
  }
}

TEST(Iepf, AVerticalLineIsOneLine) {
  Points points;
  for (int i = 0; i < 20; ++i) points.emplace_back(5.0, 0.1 * i);
  const auto lines = iepf_literal(points, 0.3);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].length_m(), 1.9, 1e-12);
  EXPECT_NEAR(lines[0].rms_m, 0, 1e-12);
}

TEST(Iepf, TheSameAnswerTurnedForATurnedScene) {
  const auto straight = iepf_literal(corner_points(), 0.3);
  const Pose2 turn{0, 0, 0.7};
  Points turned;
  for (const auto& p : corner_points()) turned.push_back(turn * p);
  const auto lines = iepf_literal(turned, 0.3);
  ASSERT_EQ(lines.size(), straight.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR((turn * straight[i].last_m - lines[i].last_m).norm(), 0, 1e-9);
  }
}

TEST(Iepf, ARoundedCornerStillGivesTwoLines) {
  Points points;
  for (int i = 0; i <= 10; ++i) points.emplace_back(10.0, -1.0 + 0.15 * i);
  for (int i = 1; i <= 4; ++i) {
    const double a = kPi / 2 * i / 5;
    points.emplace_back(10.5 - 0.5 * std::cos(a), 0.5 + 0.5 * std::sin(a));
  }
  for (int i = 0; i <= 12; ++i) points.emplace_back(10.5 + 0.25 * i, 1.0);
  Iepf iepf;
  EXPECT_EQ(iepf(points, 0.02).size(), 2u);
}

TEST(Iepf, FewAndEqualPointsGiveOneLine) {
  Iepf iepf;
  EXPECT_TRUE(iepf({}, 0.02).empty());
  EXPECT_TRUE(iepf_literal({}, 0.3).empty());
  const Points one{{3, 4}}, equal{{3, 4}, {3, 4}, {3, 4}}, two{{3, 4}, {3, 5}};
  EXPECT_EQ(iepf(one, 0.02).size(), 1u);
  EXPECT_EQ(iepf(equal, 0.02).size(), 1u);
  EXPECT_NEAR(iepf(two, 0.02)[0].length_m(), 1, 1e-12);
}

TEST(Iepf, EqualEndsAreSplitAtTheFarthestPoint) {
  const Points loop{{5, 0}, {6, 0}, {6, 1}, {5, 0}};
  const auto lines = iepf_literal(loop, 0.3);
  EXPECT_GE(lines.size(), 2u);
}

TEST(LineFit, LeavesTheSmallestPerpendicularDistance) {
  const Points points{{1, 1.1}, {2, 1.9}, {3, 3.1}, {4, 3.9}};
  const LineSegment best = fit_segment(points);
  EXPECT_LE(best.rms_m, chord(points).rms_m);
  EXPECT_NEAR(best.direction_rad(), kPi / 4, 0.05);
}

}  // namespace
}  // namespace scanfuse::shape
