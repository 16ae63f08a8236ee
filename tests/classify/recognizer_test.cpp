#include "scanfuse/classify/recognizer.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "scanfuse/shape/outline.hpp"
#include "shape/flat_world.hpp"

namespace scanfuse::classify {
namespace {

using flat_world::look;
using flat_world::Scanner;

std::vector<Detection> detect(const std::vector<Box2>& boxes, RandomStream& random,
                              const RecognizerOptions& options = {}) {
  const auto shot = look(boxes, Scanner{}, random);
  shape::OutlineExtractor extract;
  Recognizer recognize(options);
  const auto found = recognize(extract(shot.scan, shot.clusters));
  return {found.begin(), found.end()};
}

TEST(Recognizer, CarsAtEveryAspectAreFoundWithTheirCentre) {
  RandomStream random(5);
  for (int k = 0; k < 36; ++k) {
    const Box2 car{{20, 3}, radians(10.0 * k), 4.4, 1.8};
    const auto found = detect({car}, random);
    ASSERT_EQ(found.size(), 1u) << k;
    EXPECT_LT((found[0].box.centre_m - car.centre_m).norm(), 0.5) << k;
    EXPECT_LT(std::abs(wrap_half_pi(found[0].box.heading_rad - car.heading_rad)), 0.1) << k;
    EXPECT_TRUE(found[0].covariance.allFinite());
    EXPECT_GT(found[0].covariance.determinant(), 0);
  }
}

TEST(Recognizer, WallsAndPolesAreNoVehicles) {
  RandomStream random(6);
  EXPECT_TRUE(detect({{{20, 5}, 0.1, 25, 0.3}}, random).empty());
  EXPECT_TRUE(detect({{{15, 5}, 0.1, 0.2, 0.2}}, random).empty());
}

}  // namespace
}  // namespace scanfuse::classify
