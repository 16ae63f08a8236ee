#include "scanfuse/shape/outline.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "shape/flat_world.hpp"

namespace scanfuse::shape {
namespace {

using flat_world::look;
using flat_world::Scanner;

/// Error of the point that the covariance speaks of (nearest corner, or the line of the single face
/// and its middle), against the true box.
struct ReferenceError {
  Eigen::Vector3d error;
  bool usable = false;
};

ReferenceError error_against(const Outline& outline, const Box2& truth) {
  const Pose2 pose = outline.box.pose();
  const Eigen::Vector2d viewer = pose.inverse() * Eigen::Vector2d::Zero();
  const double sx = std::copysign(1, viewer.x()), sy = std::copysign(1, viewer.y());
  const bool corner = outline.faces_seen == 2;
  const Eigen::Vector2d found = pose * Eigen::Vector2d(corner ? sx * outline.box.length_m / 2 : 0.0,
                                                       sy * outline.box.width_m / 2);
  ReferenceError best;
  double least = 1e9;
  const auto corners = truth.corners();
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d p =
        corner ? corners[k] : Eigen::Vector2d((corners[k] + corners[(k + 1) % 4]) / 2);
    if ((p - found).norm() >= least) continue;
    least = (p - found).norm();
    const double turn = std::remainder(outline.box.heading_rad - truth.heading_rad, kPi / 2);
    best = {{found.x() - p.x(), found.y() - p.y(), turn}, true};
  }
  return best;
}

struct Case {
  double range_m, bearing_rad, heading_rad, sigma_m;
};

class OutlineNees : public testing::TestWithParam<Case> {};

TEST_P(OutlineNees, IsNearThreeOverManyScans) {
  const Case c = GetParam();
  RandomStream random(11);
  OutlineExtractor extract;
  double sum = 0;
  int count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int run = 0; run < 400; ++run) {
    const double bearing = c.bearing_rad + random.uniform(-0.01, 0.01);
    const Box2 truth{Eigen::Vector2d(std::cos(bearing), std::sin(bearing)) * c.range_m,
                     c.heading_rad + random.uniform(-0.02, 0.02), 4.4, 1.8};
    Scanner scanner;
    scanner.sigma_range_m = c.sigma_m;
    const auto shot = look({truth}, scanner, random);
    const Outline& outline = extract(shot.scan, shot.clusters)[0];
    const auto error = error_against(outline, truth);
    sum += error.error.dot(outline.covariance.ldlt().solve(error.error));
    mean += error.error;
    ++count;
  }
  EXPECT_LT(mean.head<2>().norm() / count, 0.02);
  EXPECT_GT(sum / count, 1.0);
  EXPECT_LT(sum / count, 5.0);
}

INSTANTIATE_TEST_SUITE_P(OfCars, OutlineNees,
                         testing::Values(Case{10, 0, 0.0, 0.03}, Case{10, 0.3, 0.3, 0.03},
                                         Case{10, 0, 0.8, 0.03}, Case{15, 0.3, 0.0, 0.03},
                                         Case{20, 0.1, 1.57, 0.03}, Case{20, -0.2, 0.5, 0.03},
                                         Case{20, 0.1, 0.9, 0.1}, Case{30, 0.0, 0.05, 0.03},
                                         Case{40, 0.1, 1.2, 0.03}, Case{40, 0.1, 0.4, 0.1},
                                         Case{50, 0, 0, 0.03}, Case{60, 0, 0.7, 0.05}));

TEST(Outline, DegenerateClustersGiveFiniteOutlines) {
  VirtualScan scan;
  scan.step_rad = 0.01;
  for (int i = 0; i < 6; ++i) {
    PlanarPoint p;
    p.x_m = 5;
    p.y_m = i < 3 ? 0.0f : 0.1f * static_cast<float>(i);
    p.range_m = 5;
    p.column = i;
    scan.points.push_back(p);
  }
  Clusters clusters;
  for (const auto& group : {std::vector<std::uint32_t>{0}, {}, {0, 1, 2}, {3, 4}, {3, 4, 5}}) {
    clusters.indices.insert(clusters.indices.end(), group.begin(), group.end());
    clusters.close();
  }
  ShapeOptions options;
  options.join.limb_m = 0;  // they would be legs
  OutlineExtractor extract(options);
  const auto outlines = extract(scan, clusters);
  ASSERT_EQ(outlines.size(), 5u);
  EXPECT_EQ(outlines[1].points, 0);
  for (const Outline& outline : outlines) {
    EXPECT_TRUE(outline.covariance.allFinite());
    EXPECT_TRUE(outline.box.centre_m.allFinite());
    EXPECT_GE(outline.covariance.determinant(), 0);
  }
}

}  // namespace
}  // namespace scanfuse::shape
