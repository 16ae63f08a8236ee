#include "scanfuse/camera/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scanfuse/core/random.hpp"

namespace scanfuse::camera {
namespace {

using Eigen::Vector2d;
using Corners = std::vector<Vector2d>;

Eigen::Matrix3d some_view(double turn_rad) {
  Eigen::Matrix3d h;
  const double c = 30 * std::cos(turn_rad), s = 30 * std::sin(turn_rad);
  h << c, -s, 400, s, c, 300, 1e-4, -2e-4, 1;
  return h;
}

Corners seen(const BoardSpec& spec, const Eigen::Matrix3d& h) {
  Corners corners;
  for (int r = 0; r < spec.rows; ++r) {
    for (int c = 0; c < spec.columns; ++c) corners.push_back(mapped(h, Vector2d(c, r)));
  }
  return corners;
}

Corners mirrored(const Corners& corners, const BoardSpec& spec) {
  Corners out;
  for (int r = 0; r < spec.rows; ++r) {
    for (int c = spec.columns - 1; c >= 0; --c) {
      out.push_back(corners[static_cast<std::size_t>(r * spec.columns + c)]);
    }
  }
  return out;
}

TEST(InOrder, TurnedAndMirroredListsOfOneBoardBecomeTheSame) {
  for (const BoardSpec spec :
       {BoardSpec{5, 8, 0.02}, BoardSpec{8, 5, 0.02}, BoardSpec{6, 6, 0.02}}) {
    for (double turn = -3; turn < 3; turn += 0.37) {
      const Corners corners = seen(spec, some_view(turn));
      Corners turned = corners;
      std::reverse(turned.begin(), turned.end());
      const Corners expected = in_order(corners, spec);
      EXPECT_EQ(in_order(turned, spec), expected);
      EXPECT_EQ(in_order(mirrored(corners, spec), spec), expected);
      if (spec.rows == spec.columns) {
        EXPECT_EQ(in_order(transposed(corners, spec), spec), expected);
      }
    }
  }
}

TEST(InOrder, XTurnsClockwiseIntoYAndPointsRightOrDown) {
  const BoardSpec spec{5, 8, 0.02};
  for (double turn = -3; turn < 3; turn += 0.37) {
    const Corners corners = in_order(seen(spec, some_view(turn)), spec);
    const Vector2d x = corners[7] - corners[0], y = corners[32] - corners[0];
    EXPECT_GT(x.x() * y.y() - x.y() * y.x(), 0);
    EXPECT_GT(std::abs(x.x()) >= std::abs(x.y()) ? x.x() : x.y(), 0) << turn;
  }
}

TEST(CornerSigma, TellsTheNoiseWhateverTheView) {
  const BoardSpec spec{14, 20, 0.02};
  RandomStream random(11);
  Corners corners = seen(spec, some_view(0.2));
  for (auto& corner : corners) corner += Vector2d(random.normal(0, 0.07), random.normal(0, 0.07));
  EXPECT_NEAR(corner_sigma(corners, spec), 0.07, 0.007);
  EXPECT_TRUE(std::isnan(corner_sigma(seen({3, 4, 0.02}, some_view(0)), {3, 4, 0.02})));
}

TEST(GridHomography, GivesBackTheViewThatMadeTheCorners) {
  const BoardSpec spec{6, 9, 0.02};
  const Eigen::Matrix3d h = grid_homography(seen(spec, some_view(0.5)), spec);
  EXPECT_LT((h - some_view(0.5)).norm(), 1e-8);
}

TEST(IsFlatGrid, RefusesACornerThatIsAstrayOrNoNumber) {
  const BoardSpec spec{6, 9, 0.02};
  Corners corners = seen(spec, some_view(0.5));
  EXPECT_TRUE(is_flat_grid(corners, spec));
  corners[20] += Vector2d(20, 0);
  EXPECT_FALSE(is_flat_grid(corners, spec));
  corners[20] = Vector2d(std::nan(""), 0);
  EXPECT_FALSE(is_flat_grid(corners, spec));
}

}  // namespace
}  // namespace scanfuse::camera
