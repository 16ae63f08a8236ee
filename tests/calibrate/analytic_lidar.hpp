#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/types/turntable.hpp"

// A small lidar on a turntable that looks at flat things in closed form: its spot is a set of rays,
// and a return is the mean range of what the spot meets. Camera frame, metres.
namespace scanfuse::calibrate_testing {

/// A flat thing: a disc, or a rectangle where the radius is zero, in the plane z = 0 of its frame.
struct FlatThing {
  Pose3 camera_from_thing;
  double radius_m = 0;
  Eigen::Vector2d half_m = Eigen::Vector2d::Zero();

  [[nodiscard]] std::optional<double> range(const Eigen::Vector3d& origin,
                                            const Eigen::Vector3d& ray) const {
    const Pose3 thing_from_camera = camera_from_thing.inverse();
    const Eigen::Vector3d from = thing_from_camera * origin;
    const Eigen::Vector3d along = thing_from_camera.rotation * ray;
    const double t = -from.z() / along.z();
    if (!(t > 0)) return std::nullopt;
    const Eigen::Vector2d at = (from + t * along).head<2>();
    const bool inside =
        radius_m > 0 ? at.norm() <= radius_m : (at.cwiseAbs().array() <= half_m.array()).all();
    return inside ? std::optional(t) : std::nullopt;
  }
};

struct LidarModel {
  double beam_step_rad = radians(0.0833);
  double turntable_step_rad = radians(0.25);
  double field_rad = radians(20);
  double first_turntable_rad = radians(-10);
  int positions = 81;
  double noise_m = 0.001;
  double turntable_noise_rad = radians(0.002);
  double spot_rad = 0.0015;  ///< half angle of the spot
  double least_share = 0.5;  ///< of the spot that must meet something for a return
};

/// A rig whose axis stands upright (camera y down) 0.1 m behind the lidar, beams fanning up and
/// down.
inline Rig upright_rig() {
  Rig rig;
  rig.axis_direction = Eigen::Vector3d(0.01, -1, 0.02).normalized();
  rig.camera_from_lidar.translation_m = {0.2, 0.05, -0.3};
  Eigen::Matrix3d r;
  r.col(0) = Eigen::Vector3d(0.02, 0.01, 1).normalized();
  r.col(2) = Eigen::Vector3d(1, 0.03, 0).cross(r.col(0)).cross(r.col(0)).normalized();
  r.col(2) = (Eigen::Vector3d(1, 0.03, 0) - r.col(0) * r.col(0).dot(Eigen::Vector3d(1, 0.03, 0)))
                 .normalized();
  r.col(1) = r.col(2).cross(r.col(0));
  rig.camera_from_lidar.rotation = Eigen::Quaterniond(r);
  const Eigen::Vector3d point = rig.camera_from_lidar.translation_m + Eigen::Vector3d(0, 0, -0.1);
  rig.axis_point_m = point - rig.axis_direction * rig.axis_direction.dot(point);
  rig.first_turntable_rad = radians(-20);
  rig.last_turntable_rad = radians(20);
  return rig;
}

/// Mean range over the spot's rays that meet anything; nothing where too few do.
inline double spot_range(const std::vector<FlatThing>& things, const Eigen::Vector3d& origin,
                         const Eigen::Matrix3d& lidar, double angle, const LidarModel& model) {
  constexpr int kRays = 7;
  double sum = 0;
  int met = 0, all = 0;
  for (int i = -kRays / 2; i <= kRays / 2; ++i) {
    for (int j = -kRays / 2; j <= kRays / 2; ++j) {
      const double a = 2.0 * i / (kRays - 1), b = 2.0 * j / (kRays - 1);
      if (a * a + b * b > 1.01) continue;
      ++all;
      const double t = angle + a * model.spot_rad;
      const Eigen::Vector3d ray =
          (lidar * Eigen::Vector3d(std::cos(t), std::sin(t), b * model.spot_rad)).normalized();
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& thing : things) {
        nearest = std::min(nearest, thing.range(origin, ray).value_or(nearest));
      }
      if (!std::isfinite(nearest)) continue;
      sum += nearest;
      ++met;
    }
  }
  return met >= model.least_share * all && met > 0 ? sum / met
                                                   : std::numeric_limits<double>::quiet_NaN();
}

/// What the rig's lidar sees of the things; the turntable's error is drawn once a position.
inline std::vector<TurntablePosition> look_at(const std::vector<FlatThing>& things, const Rig& rig,
                                              const LidarModel& model, std::uint64_t seed) {
  std::vector<TurntablePosition> scans;
  RandomStream random(seed);
  for (int p = 0; p < model.positions; ++p) {
    TurntablePosition position;
    position.turntable_rad = model.first_turntable_rad + p * model.turntable_step_rad;
    const double turned = position.turntable_rad + random.normal(0, model.turntable_noise_rad);
    const Pose3 pose = rig.pose(turned);
    const Eigen::Matrix3d lidar = pose.rotation.toRotationMatrix();
    const int beams = static_cast<int>(model.field_rad / model.beam_step_rad);
    for (int b = 0; b < beams; ++b) {
      const double angle = (b - beams / 2) * model.beam_step_rad;
      const double range = spot_range(things, pose.translation_m, lidar, angle, model);
      const double noisy = range + random.normal(0, model.noise_m) + rig.range_bias_m;
      position.scan.push_back({angle, std::round(noisy * 1e4) * 1e-4, 100});
    }
    scans.push_back(std::move(position));
  }
  return scans;
}

/// A disc of 140 mm about 1.5 m before the lidar, moved and tilted by a placement's number.
inline FlatThing placed_disc(std::uint64_t placement, double radius_m = 0.07) {
  RandomStream random(placement, 77);
  FlatThing disc;
  disc.radius_m = radius_m;
  const Eigen::Vector3d tilt(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), 0);
  disc.camera_from_thing.rotation =
      Eigen::Quaterniond(Eigen::AngleAxisd(std::max(tilt.norm(), 1e-9), tilt.normalized()));
  disc.camera_from_thing.translation_m = {0.2 + random.uniform(-0.08, 0.08),
                                          0.05 + random.uniform(-0.08, 0.08),
                                          1.2 + random.uniform(-0.05, 0.05)};
  return disc;
}

/// A wall that fills the view.
inline FlatThing wall_at(double z_m) {
  FlatThing wall;
  wall.half_m = {5, 5};
  wall.camera_from_thing.translation_m = {0, 0, z_m};
  return wall;
}

}  // namespace scanfuse::calibrate_testing
