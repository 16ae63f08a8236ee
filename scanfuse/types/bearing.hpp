#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse {

/// A sensor that tells directions and no ranges: direction finder, camera, acoustic array.
struct PassiveSensor {
  std::string name;
  Pose3 world_from_sensor;
  double sigma_azimuth_rad = 0.005;
  std::optional<double> sigma_elevation_rad;  ///< empty: tells azimuth only
  double detection_probability = 0.9;         ///< of a target in the field of view
  /// False alarms per scan and steradian (azimuth only: per radian).
  double clutter_density = 0;
  double field_of_view_azimuth_rad = 2 * kPi;  ///< centred on the sensor's x axis
  double field_of_view_elevation_rad = kPi;    ///< centred on its horizon

  [[nodiscard]] bool tells_elevation() const { return sigma_elevation_rad.has_value(); }
  /// In steradian; in radian where the sensor tells azimuth only.
  [[nodiscard]] double field_of_view() const {
    if (!tells_elevation()) return field_of_view_azimuth_rad;
    return 2 * field_of_view_azimuth_rad * std::sin(field_of_view_elevation_rad / 2);
  }
};

/// One direction seen by a sensor, in the sensor's frame: azimuth about z from x towards y,
/// elevation up from the horizon.
struct Bearing {
  std::int32_t sensor = 0;       ///< place in PassiveScene::sensors
  std::int64_t measurement = 0;  ///< the file's number of it, unique within its scan and sensor
  double azimuth_rad = 0;
  double elevation_rad = 0;  ///< 0 and without meaning where the sensor tells azimuth only
  std::optional<double> sigma_azimuth_rad;  ///< empty: the sensor's
  std::optional<double> sigma_elevation_rad;
  std::optional<std::int64_t> truth;  ///< of simulated data: the target, -1 for a false alarm
};

/// What all sensors saw at one time.
struct BearingScan {
  std::int64_t scan = 0;
  Time stamp;
  std::vector<Bearing> bearings;
};

/// The sensors and what is known of the scene before anything is seen.
struct PassiveScene {
  std::vector<PassiveSensor> sensors;
  using Volume = std::array<std::array<double, 2>, 3>;
  std::optional<Volume> volume_m;          ///< where targets may be, world frame: [x0, x1], ...
  std::optional<double> expected_targets;  ///< in the volume
};

/// Where the bearings of one target meet.
struct Fix {
  std::int64_t target = 0;  ///< unique within its scan
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Identity();
  double chi2 = 0;             ///< of the bearings against the position
  int degrees_of_freedom = 0;  ///< of chi2
  double weight = 0;           ///< log evidence against all of its bearings being false alarms
  double existence_probability = 1;
  std::vector<std::int32_t> bearings;  ///< places in BearingScan::bearings, ascending
};

}  // namespace scanfuse
