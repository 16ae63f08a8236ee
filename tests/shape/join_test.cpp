#include "scanfuse/shape/join.hpp"

#include <gtest/gtest.h>

#include "shape/flat_world.hpp"

namespace scanfuse::shape {
namespace {

using flat_world::look;
using flat_world::Snapshot;

const Box2 kCar{{20, 0}, kPi / 2, 4.4, 1.8};     // across the line of sight
const Box2 kPole{{10, 0.1}, 0, 0.4, 0.4};        // hides the middle of it
const Box2 kCarBesides{{20, 2.6}, 0, 4.4, 1.8};  // two cars side by side, rears seen
const Box2 kCarBesides2{{20.9, -0.1}, 0, 4.4, 1.8};

/// Cuts every cluster where two of its neighbouring points lie farther apart than half a metre.
Clusters cut_apart(const Snapshot& shot) {
  Clusters pieces;
  for (std::size_t k = 0; k < shot.clusters.size(); ++k) {
    const auto points = shot.clusters[k];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool far =
          i > 0 && (shot.scan.position(points[i]) - shot.scan.position(points[i - 1])).norm() > 0.5;
      if (far) pieces.close();
      pieces.indices.push_back(points[i]);
    }
    pieces.close();
  }
  return pieces;
}

ClusterJoiner joiner(JoinMethod method = JoinMethod::kOccluder) {
  JoinOptions options;
  options.method = method;
  return {options, {}, {}};
}

TEST(ClusterJoiner, TwoPiecesBehindAPoleAreOneCar) {
  RandomStream random(1);
  const Snapshot shot = look({kCar, kPole}, {}, random);
  const Clusters pieces = cut_apart(shot);
  ASSERT_EQ(pieces.size(), 3u);
  auto join = joiner();
  EXPECT_EQ(join(shot.scan, pieces, {}).size(), 2u);
}

TEST(ClusterJoiner, TwoPiecesWithNothingInFrontStayTwo) {
  RandomStream random(1);
  Snapshot shot = look({kCar, kPole}, {}, random);
  const Clusters pieces = cut_apart(shot);
  for (const std::uint32_t i : shot.clusters[1]) {  // the pole's beams now pass and hit a wall
    shot.scan.points[i].range_m = 40;
    shot.scan.points[i].x_m = 40 * std::cos(shot.scan.points[i].bearing_rad);
    shot.scan.points[i].y_m = 40 * std::sin(shot.scan.points[i].bearing_rad);
  }
  auto join = joiner();
  EXPECT_EQ(join(shot.scan, pieces, {}).size(), pieces.size());
}

TEST(ClusterJoiner, CarsSideBySideBehindAPoleStayTwo) {
  RandomStream random(1);
  const Box2 pole{{10, 0.65}, 0, 0.6, 0.6};
  const Snapshot shot = look({kCarBesides, kCarBesides2, pole}, {}, random);
  auto join = joiner();
  EXPECT_EQ(join(shot.scan, shot.clusters, {}).size(), 3u);
}

TEST(ClusterJoiner, GuosRuleJoinsNeighboursInLineWhateverStandsBetween) {
  RandomStream random(1);
  const Snapshot shot = look({{{20, 2.4}, 0, 0.1, 1.8}, {{20, 0.2}, 0, 0.1, 1.8}}, {}, random);
  auto guo = joiner(JoinMethod::kGuo), occluder = joiner();
  Clusters in_order;  // by bearing: the right car first
  for (const std::size_t k : {1, 0}) {
    const auto points = shot.clusters[k];
    in_order.indices.insert(in_order.indices.end(), points.begin(), points.end());
    in_order.close();
  }
  EXPECT_EQ(guo(shot.scan, in_order, {}).size(), 1u);
  EXPECT_EQ(occluder(shot.scan, in_order, {}).size(), 2u);
}

TEST(ClusterJoiner, WhatLiesWhereATrackExpectsACarIsOneCar) {
  RandomStream random(1);
  Snapshot shot = look({kCar}, {}, random);
  Clusters pieces;  // the middle third is lost to no cluster
  const auto all = shot.clusters[0];
  const std::size_t third = all.size() / 3;
  for (const auto part : {all.first(third), all.last(third)}) {
    pieces.indices.insert(pieces.indices.end(), part.begin(), part.end());
    pieces.close();
  }
  const Expected expected{kCar, 0.1, ObjectClass::kVehicle};
  auto join = joiner();
  const Clusters joined = join(shot.scan, pieces, std::span(&expected, 1));
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(join.expected_of()[0], 0);
  EXPECT_TRUE(std::ranges::is_sorted(joined[0]));
}

TEST(ClusterJoiner, LoosePointsWhereACarIsExpectedBecomeACluster) {
  RandomStream random(1);
  Snapshot shot = look({kCar}, {radians(2), 0.03, radians(60)}, random);
  const Expected expected{kCar, 0.1, ObjectClass::kVehicle};
  Clusters elsewhere;  // one cluster of nothing expected, so that there is something to join
  elsewhere.indices.push_back(0);
  elsewhere.close();
  auto join = joiner();
  const Clusters joined = join(shot.scan, elsewhere, std::span(&expected, 1));
  std::size_t points = 0;
  for (std::size_t k = 0; k < joined.size(); ++k) points += joined[k].size();
  EXPECT_EQ(points, shot.scan.points.size());
}

TEST(ClusterJoiner, TheMethodNoneChangesNothing) {
  RandomStream random(1);
  const Snapshot shot = look({kCar, kPole}, {}, random);
  const Clusters pieces = cut_apart(shot);
  auto join = joiner(JoinMethod::kNone);
  EXPECT_EQ(&join(shot.scan, pieces, {}), &pieces);
}

TEST(ClusterJoiner, EmptyClustersStayAsTheyAre) {
  RandomStream random(1);
  const Snapshot shot = look({kCar}, {}, random);
  Clusters pieces;
  pieces.close();
  pieces.indices.assign(shot.clusters[0].begin(), shot.clusters[0].end());
  pieces.close();
  pieces.close();
  for (const auto method : {JoinMethod::kOccluder, JoinMethod::kGuo}) {
    auto join = joiner(method);
    EXPECT_EQ(join(shot.scan, pieces, {}).size(), 3u);
  }
}

Box2 leg(double x_m, double y_m) { return {{x_m, y_m}, 0, 0.13, 0.13}; }

std::size_t objects_of(const std::vector<Box2>& boxes, double limb_m = JoinOptions{}.limb_m) {
  RandomStream random(3);
  const Snapshot shot = look(boxes, {}, random);
  JoinOptions options;
  options.limb_m = limb_m;
  ClusterJoiner join(options, {}, {});
  return join(shot.scan, shot.clusters, {}).size();
}

TEST(ClusterJoiner, TwoLegsWithinAStrideAreOnePerson) {
  EXPECT_EQ(objects_of({leg(2, 0), leg(2.3, 0.25)}), 1u);
  EXPECT_EQ(objects_of({leg(2, 0), leg(2.3, 0.25)}, 0), 2u);
}

TEST(ClusterJoiner, FourLegsInARowAreTwoPeople) {
  EXPECT_EQ(objects_of({leg(3, -0.5), leg(3, -0.3), leg(3, 0.2), leg(3, 0.4)}), 2u);
}

TEST(ClusterJoiner, WhatStandsFartherThanAStrideOrIsNoLimbStaysApart) {
  EXPECT_EQ(objects_of({leg(2, 0), leg(2, 0.7)}), 2u);
  EXPECT_EQ(objects_of({leg(2, 0), Box2{{2, 0.5}, kPi / 2, 0.5, 0.2}}), 2u);
}

TEST(ClusterJoiner, OfThreeLimbsTheNearestTwoAreAPair) {
  EXPECT_EQ(objects_of({leg(3, 0), leg(3, 0.25), leg(3, 0.6)}), 2u);
}

TEST(ClusterJoiner, AnEmptyScanHasNothingToJoin) {
  auto join = joiner();
  const Expected expected{kCar, 0.1, ObjectClass::kVehicle};
  EXPECT_EQ(join(VirtualScan{}, Clusters{}, std::span(&expected, 1)).size(), 0u);
}

}  // namespace
}  // namespace scanfuse::shape
