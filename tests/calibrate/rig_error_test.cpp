#include "scanfuse/calibrate/rig_error.hpp"

#include "calibrate/rig_scene.hpp"

namespace scanfuse::calibrate {
namespace {

Rig some_rig() {
  Rig rig = simulate::turntable_world().rig;
  rig.range_bias_m = 0.002;
  rig.angle_scale = 1.01;
  return rig;
}

TEST(RigError, DifferenceUndoesChange) {
  const Rig rig = some_rig();
  RigVector delta;
  delta << 1e-5, -2e-5, 3e-5, 1e-5, 2e-5, -1e-5, 4e-5, 1e-5, 5e-5, -3e-5, 2e-5, 1e-5;
  EXPECT_LT((difference(rig, changed(rig, delta)) - delta).norm(), 1e-8);
  EXPECT_LT(difference(rig, rig).norm(), 1e-15);
}

TEST(RigError, JacobiansAreDerivatives) {
  const Rig rig = some_rig();
  for (const double psi : {-1.5, 0.0, 0.3}) {
    const auto of_pose = pose_jacobian(rig, psi);
    const auto of_point = point_jacobian(rig, psi, 0.2, 1.4);
    for (int k = 0; k < Rig::kParameters; ++k) {
      const double h = 1e-6;
      const Rig up = changed(rig, h * RigVector::Unit(k)),
                down = changed(rig, -h * RigVector::Unit(k));
      const Pose3 a = up.pose(psi), b = down.pose(psi);
      const Eigen::AngleAxisd turn(a.rotation * b.rotation.conjugate());
      Eigen::Matrix<double, 6, 1> numeric;
      numeric << wrap_pi(turn.angle()) * turn.axis(), a.translation_m - b.translation_m;
      EXPECT_LT((numeric / (2 * h) - of_pose.col(k)).norm(), 1e-6) << k << " at " << psi;
      const Eigen::Vector3d moved =
          point_camera(up, psi, 0.2, 1.4) - point_camera(down, psi, 0.2, 1.4);
      EXPECT_LT((moved / (2 * h) - of_point.col(k)).norm(), 1e-6) << k << " at " << psi;
    }
  }
}

TEST(RigError, PointCovarianceGrowsWithTheReturnsOwnNoise) {
  Rig rig = some_rig();
  rig.covariance.diagonal().setConstant(1e-10);
  const auto shared = point_covariance(rig, 0.2, 0, 1.5);
  const auto all = point_covariance(rig, 0.2, 0, 1.5, {.range_m = 1e-3, .turntable_rad = 1e-5});
  EXPECT_NEAR((all - shared).trace(), 1e-6, 1e-9);
  EXPECT_GT(shared.trace(), 0);
}

}  // namespace
}  // namespace scanfuse::calibrate
