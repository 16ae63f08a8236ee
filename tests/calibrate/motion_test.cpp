#include "scanfuse/calibrate/motion.hpp"

#include "calibrate/rig_scene.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::calibrate {
namespace {

using testing::points_apart_m;
using testing::TurntableWorldOptions;

std::vector<TurnedPose> poses_along(const Rig& rig, const std::vector<double>& angles,
                                    double noise_rad = 0, double noise_m = 0) {
  std::vector<TurnedPose> poses;
  RandomStream random(3);
  const auto draw = [&](double sigma) -> Eigen::Vector3d {
    return sigma * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  };
  for (const double psi : angles) {
    Pose3 pose = rig.pose(psi);
    const Eigen::Vector3d w = draw(noise_rad);
    if (w.norm() > 0) {
      pose.rotation = Eigen::AngleAxisd(w.norm(), w.normalized()) * pose.rotation;
    }
    pose.translation_m += draw(noise_m);
    poses.push_back({psi, pose});
  }
  return poses;
}

std::vector<double> arc(double first_deg, double step_deg, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(radians(first_deg + step_deg * i));
  return angles;
}

Rig rig_with(double radius_m, double axis_tilt_rad, bool reversed, double beam_zero_rad) {
  TurntableWorldOptions options;
  options.radius_m = radius_m;
  options.axis_tilt_rad = axis_tilt_rad;
  options.reversed = reversed;
  options.beam_zero_rad = beam_zero_rad;
  return simulate::turntable_world(options).rig;
}

// Radius 0, the axis along the scan plane's normal, x along the axis, a reversed turntable.
TEST(ClosedForm, HasNoDegenerateMounting) {
  const auto angles = arc(0, 1, 22);
  for (const Rig& truth : {rig_with(0.08, 0.03, false, 0), rig_with(0, 0.03, false, 0),
                           rig_with(0.08, kPi / 2, false, 0), rig_with(0.08, 0.03, false, kPi / 2),
                           rig_with(0.08, 0.03, true, 0)}) {
    const auto fit = rig_closed_form(poses_along(truth, angles));
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_LT(fit->rig.axis_direction.cross(truth.axis_direction).norm(), 1e-8);
    EXPECT_GT(fit->rig.axis_direction.dot(truth.axis_direction), 0);
    EXPECT_LT((fit->rig.axis_point_m - truth.axis_point_m).norm(), 1e-7);
    EXPECT_LT(points_apart_m(truth, fit->rig), 1e-8);
    EXPECT_NEAR(fit->turn_ratio, 1, 1e-9);
  }
}

TEST(ClosedForm, WorksOnAWholeTurnAndOnUnsortedAngles) {
  const Rig truth = rig_with(0.08, 0.03, false, 0);
  auto angles = arc(-170, 20, 18);
  std::swap(angles[2], angles[15]);
  const auto fit = rig_closed_form(poses_along(truth, angles));
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->rig.axis_point_m - truth.axis_point_m).norm(), 1e-7);
}

TEST(ClosedForm, IsNotMovedByBadPoses) {
  const Rig truth = rig_with(0.08, 0.03, false, 0);
  auto poses = poses_along(truth, arc(0, 1, 22), 1e-5, 1e-5);
  poses[4].camera_from_lidar.translation_m += Eigen::Vector3d(0.3, 0, 0);
  poses[9].camera_from_lidar.rotation = Eigen::Quaterniond(0.9, 0.3, -0.2, 0.1).normalized();
  const auto fit = rig_closed_form(poses);
  ASSERT_TRUE(fit);
  EXPECT_LT(points_apart_m(truth, fit->rig), 1e-4);
  EXPECT_GT(fit->centre_m[4], 0.2);
}

TEST(ClosedForm, RefusesAnglesThatDoNotDiffer) {
  const Rig truth = rig_with(0.08, 0.03, false, 0);
  const auto fit = rig_closed_form(poses_along(truth, {0.1, 0.1, 0.1}));
  ASSERT_FALSE(fit);
  EXPECT_NE(fit.error().message.find("do not differ"), std::string::npos);
}

TEST(PapersFunctions, AreExactWithoutNoiseOnAShortArc) {
  const Rig truth = rig_with(0.08, 0.2, false, 0.4);
  const auto fit = rig_liu2023(poses_along(truth, arc(0, 1, 22)));
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_FALSE(fit->contradiction);
  EXPECT_LT(points_apart_m(truth, fit->rig), 1e-6);
  EXPECT_LT((fit->rig.axis_point_m - truth.axis_point_m).norm(), 1e-5);
}

// eq. 16 and the circle amplify noise on a short arc; known angles do not.
TEST(PapersFunctions, AreFarFromTheClosedFormUnderNoise) {
  const Rig truth = rig_with(0.08, 0.03, false, 0.4);
  const auto poses = poses_along(truth, arc(0, 0.25, 87), radians(0.02), 3e-4);
  const auto paper = rig_liu2023(poses);
  const auto closed = rig_closed_form(poses);
  ASSERT_TRUE(paper && closed);
  const auto axis_error = [&](const Rig& rig) {
    return rig.axis_direction.cross(truth.axis_direction).norm();
  };
  EXPECT_GT(axis_error(paper->rig), 3 * axis_error(closed->rig));
}

}  // namespace
}  // namespace scanfuse::calibrate
