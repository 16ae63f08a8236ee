#include "scanfuse/calibrate/board_plane.hpp"

#include "calibrate/rig_scene.hpp"
#include "scanfuse/calibrate/undistort.hpp"

namespace scanfuse::calibrate {
namespace {

using testing::kNoNoise;
using testing::simulate_small;

TEST(Undistort, IsTheInverseOfProjection) {
  Camera camera = simulate::turntable_world().camera;
  camera.p1 = 0.002;
  camera.p2 = -0.001;
  camera.k3 = 0.1;
  for (const double x : {-0.28, 0.0, 0.21}) {
    for (const double y : {-0.2, 0.05, 0.22}) {
      const Eigen::Vector2d at = undistort(camera, camera.project({x, y, 1}));
      EXPECT_NEAR((at - Eigen::Vector2d(x, y)).norm(), 0, 1e-12);
    }
  }
}

TEST(BoardPose, IsExactWithoutNoise) {
  const auto data = simulate_small(kNoNoise);
  for (std::size_t b = 0; b < 2; ++b) {
    const Pose3& truth = data.world.camera_from_board[b];
    for (const auto locate : {board_pose_liu2023, board_pose}) {
      const auto found = locate(data.features.camera, data.features.boards[b],
                                data.features.corners_px[b], "board");
      ASSERT_TRUE(found) << found.error().message;
      EXPECT_NEAR((found->camera_from_board.translation_m - truth.translation_m).norm(), 0, 1e-8);
      EXPECT_NEAR(found->camera_from_board.rotation.angularDistance(truth.rotation), 0, 1e-8);
      EXPECT_GT(found->plane().normal.dot(-truth.translation_m), 0);  // faces the camera
    }
  }
}

// The print's algebraic pose is a start, not an optimum.
TEST(BoardPose, RefinementLowersTheErrorOfTheLinearPose) {
  double linear = 0, refined = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto data = simulate_small({}, seed);
    const Pose3& truth = data.world.camera_from_board[0];
    const auto error = [&](const auto& locate) {
      const auto found = locate(data.features.camera, data.features.boards[0],
                                data.features.corners_px[0], "board");
      return (found->camera_from_board.translation_m - truth.translation_m).squaredNorm();
    };
    linear += error(board_pose_liu2023);
    refined += error(board_pose);
  }
  EXPECT_LT(refined, linear);
}

TEST(BoardPose, NamesWhatIsWrongWithCorners) {
  auto data = simulate_small();
  auto& features = data.features;
  const auto message = [&] {
    const auto found =
        board_pose(features.camera, features.boards[0], features.corners_px[0], "board1.png");
    return found ? std::string("accepted") : found.error().message;
  };
  EXPECT_EQ(message(), "accepted");
  std::swap(features.boards[0].rows, features.boards[0].columns);
  EXPECT_NE(message().find("rows and columns swapped"), std::string::npos) << message();
  std::swap(features.boards[0].rows, features.boards[0].columns);
  features.corners_px[0][17].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message().find("board1.png: a corner's coordinates"), std::string::npos) << message();
  features.corners_px[0].pop_back();
  EXPECT_NE(message().find("279 corners where 14 x 20"), std::string::npos) << message();
  for (auto& corner : features.corners_px[0]) corner = {100, 100};
  features.corners_px[0].emplace_back(100, 100);
  EXPECT_NE(message(), "accepted");
}

}  // namespace
}  // namespace scanfuse::calibrate
