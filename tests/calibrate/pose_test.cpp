#include "scanfuse/calibrate/pose.hpp"

#include "calibrate/rig_scene.hpp"

namespace scanfuse::calibrate {
namespace {

using testing::kNoNoise;
using testing::simulate_small;
using testing::small_world;

double centre_error(const testing::SimulatedTurntable& data, const FixedPose& pose, std::size_t i) {
  const Pose3 truth = data.world.rig.pose(data.turned_rad[i]);
  return (pose.camera_from_lidar.translation_m - truth.translation_m).norm();
}

TEST(FixedPose, BothMethodsAreExactWithoutNoise) {
  const auto data = simulate_small(kNoNoise);
  for (const auto method : {PoseMethod::kLiu2023, PoseMethod::kExact}) {
    for (const std::size_t i : {std::size_t{0}, std::size_t{11}, std::size_t{21}}) {
      const auto pose = fixed_pose(data.features, i, method);
      ASSERT_TRUE(pose) << pose.error().message;
      EXPECT_LT(centre_error(data, *pose, i), 1e-6);
      const Pose3 truth = data.world.rig.pose(data.turned_rad[i]);
      EXPECT_LT(pose->camera_from_lidar.rotation.angularDistance(truth.rotation), 1e-6);
      EXPECT_NEAR(degrees(pose->v_angle_rad), 120, 5);
      EXPECT_LT(pose->stripe_px, 1e-4);
      EXPECT_LT(pose->lidar_m, 1e-6);
    }
  }
}

// eq. 11's wrong factor costs accuracy wherever ranges are noisy.
TEST(FixedPose, ExactOneIsNearerThanThePapersUnderNoise) {
  double paper = 0, exact = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto data = simulate_small({}, seed);
    for (std::size_t i = 0; i < 22; i += 3) {
      const auto a = fixed_pose(data.features, i, PoseMethod::kLiu2023);
      const auto b = fixed_pose(data.features, i, PoseMethod::kExact);
      ASSERT_TRUE(a && b);
      paper += std::pow(centre_error(data, *a, i), 2);
      exact += std::pow(centre_error(data, *b, i), 2);
    }
  }
  EXPECT_LT(exact, 0.95 * paper);
}

// Slope form has no answer for a line along y, and 1 = a x + b y + c z none through the camera.
TEST(FixedPose, ExactOneHasNoForbiddenDirections) {
  auto options = small_world();
  options.beam_zero_rad = radians(60);  // the first board then runs along the lidar's y
  const auto turned = simulate::simulate_turntable_features(options, kNoNoise, 1);
  options = small_world();
  options.lateral_m = 0;
  const auto beside = simulate::simulate_turntable_features(options, kNoNoise, 1);
  for (const auto* data : {&turned, &beside}) {
    for (std::size_t i = 0; i < 22; i += 5) {
      const auto pose = fixed_pose(data->features, i, PoseMethod::kExact);
      if (data->features.positions[i].stripe_px[0].size() < 8) continue;
      ASSERT_TRUE(pose) << pose.error().message;
      EXPECT_LT(centre_error(*data, *pose, i), 1e-4);
    }
  }
}

TEST(FixedPose, FindsTheBoardsAmongWallsAndPosts) {
  const auto data = simulate_small();
  const auto& position = data.features.positions[4];
  std::array<BoardPose, 2> boards;
  for (std::size_t b = 0; b < 2; ++b) {
    boards[b] =
        *board_pose(data.features.camera, data.features.boards[b], data.features.corners_px[b]);
  }
  const auto stripes = stripe_lines(data.features.camera, position);
  ASSERT_TRUE(stripes);
  const auto seen = v_lines(data.features.camera, data.features.boards, boards, *stripes);
  ASSERT_TRUE(seen);
  const auto found = find_board_returns(*seen, position.scan);
  ASSERT_TRUE(found) << found.error().message;
  const Pose3 lidar = data.world.rig.pose(data.turned_rad[4]);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_GT(found->on_board[b].size(), 40u);
    for (const auto& r : found->on_board[b]) {
      const Eigen::Vector3d at =
          data.world.camera_from_board[b].inverse() *
          (lidar * (r.range_m * Eigen::Vector3d(std::cos(r.angle_rad), std::sin(r.angle_rad), 0)));
      EXPECT_LT(std::abs(at.z()), 0.008);
      EXPECT_GE(data.world.square_at(b, at.head<2>()), 0);
    }
  }
}

TEST(FixedPose, SaysWhatIsWrongWithAPosition) {
  const auto good = simulate_small();
  const auto message = [&](auto&& spoil) {
    TurntableFeatures features = good.features;
    spoil(features.positions[3]);
    const auto pose = fixed_pose(features, 3);
    return pose ? std::string("accepted") : pose.error().message;
  };
  const auto in_mm = message([](TurntablePosition& p) {
    for (auto& r : p.scan) r.range_m *= 1000;
  });
  EXPECT_NE(in_mm.find("millimetres"), std::string::npos) << in_mm;
  const auto dark = message([](TurntablePosition& p) { p.stripe_px[1].clear(); });
  EXPECT_NE(dark.find("position 3: no stripe on board 2"), std::string::npos) << dark;
  const auto blind = message([](TurntablePosition& p) {
    for (auto& r : p.scan) r.range_m = 0;
  });
  EXPECT_NE(blind.find("returns are usable"), std::string::npos) << blind;
  const auto wall = message([](TurntablePosition& p) {
    for (auto& r : p.scan) r.range_m = 1 / std::cos(r.angle_rad);
  });
  EXPECT_NE(wall.find("no two straight runs"), std::string::npos) << wall;
  EXPECT_FALSE(fixed_pose(good.features, 99));
}

TEST(FixedPose, UsesReturnsInAnyOrderAndSkipsBadOnes) {
  auto data = simulate_small();
  const auto plain = fixed_pose(data.features, 3);
  auto& scan = data.features.positions[3].scan;
  std::reverse(scan.begin(), scan.end());
  scan.push_back({0.1, std::numeric_limits<double>::quiet_NaN()});
  scan.push_back({0.1, 0});
  scan.push_back({0.1, std::numeric_limits<double>::infinity()});
  const auto shuffled = fixed_pose(data.features, 3);
  ASSERT_TRUE(plain && shuffled);
  EXPECT_LT(
      (plain->camera_from_lidar.translation_m - shuffled->camera_from_lidar.translation_m).norm(),
      1e-9);
}

}  // namespace
}  // namespace scanfuse::calibrate
