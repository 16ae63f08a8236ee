#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/bearing.hpp"

namespace scanfuse::simulate {

enum class TargetLayout { kLine, kGrid, kRandom, kCluster };
constexpr auto choices(TargetLayout) {
  using enum TargetLayout;
  return std::array{std::pair{"line", kLine}, std::pair{"grid", kGrid},
                    std::pair{"random", kRandom}, std::pair{"cluster", kCluster}};
}

enum class SensorLayout { kPaper, kRandom, kCameras };
constexpr auto choices(SensorLayout) {
  using enum SensorLayout;
  return std::array{std::pair{"paper", kPaper}, std::pair{"random", kRandom},
                    std::pair{"cameras", kCameras}};
}

/// A scene of sensors that tell directions. Layouts:
/// sensors `paper`: [Lu2015, table 1], three at (30, 0, 0.1), (0, 30, 0.1), (0, 0, 0) km; `random`:
/// anywhere on the ground of the volume, at least 3 km apart; `cameras`: around a measuring cube of
/// 0.1 m at 0.5 m, looking at it. Targets `line`: (20, 20, 8) km + k (spacing, 0, 0); `grid`: a
/// square grid around that point in x and y; `random`: uniform in the volume of 40 x 40 x 11 km
/// (cameras: in the cube); `cluster`: one anywhere there, each next one spacing_m from the last, in
/// a level random direction. The scene's volume grows with a line or grid that would leave it.
struct PassiveOptions {
  int targets = 20;
  double spacing_m = 1000;
  double noise_rad = 0.005;
  double noise_ratio = 1;
  double detection_probability = 1;
  double false_alarms = 0;
  int sensors = 3;
  bool azimuth_only = false;
  TargetLayout target_layout = TargetLayout::kLine;
  SensorLayout sensor_layout = SensorLayout::kPaper;
  double field_of_view_elevation_rad = kPi;
  int scans = 1;
  double interval_s = 1;
  double speed_m_per_s = 0;
  double azimuth_bias_rad = 0;

  static constexpr auto fields() {
    using O = PassiveOptions;
    return std::tuple{
        Field{"targets", &O::targets, 0, 1000000, "how many targets"},
        Field{"spacing_m", &O::spacing_m, 0.0, 1e6, "line and grid: from target to target"},
        Field{"noise_rad", &O::noise_rad, 1e-7, 1.0, "standard deviation of both angles"},
        Field{"noise_ratio", &O::noise_ratio, 1.0, 1000.0,
              "each sensor's noise is this times that of the sensor before"},
        Field{"detection_probability", &O::detection_probability, 0.01, 1.0,
              "that a sensor sees a target"},
        Field{"false_alarms", &O::false_alarms, 0.0, 1e5, "a sensor and scan, on average"},
        Field{"sensors", &O::sensors, 2, 64, "random and cameras: how many"},
        Field{"azimuth_only", &O::azimuth_only, "sensors tell no elevation"},
        Field{"target_layout", &O::target_layout, "where targets are"},
        Field{"sensor_layout", &O::sensor_layout, "where sensors are"},
        Field{"field_of_view_elevation_rad", &O::field_of_view_elevation_rad, 0.01, kPi,
              "of random and paper's sensors, centred on the horizon; azimuth is all around"},
        Field{"scans", &O::scans, 1, 1000000, "how many"},
        Field{"interval_s", &O::interval_s, 1e-4, 1e5, "from scan to scan"},
        Field{"speed_m_per_s", &O::speed_m_per_s, 0.0, 1e4,
              "of the targets, straight on, each in its own direction"},
        Field{"azimuth_bias_rad", &O::azimuth_bias_rad, -0.5, 0.5,
              "added to every azimuth of the first sensor"}};
  }
};

/// A target as it is at one scan.
struct PassiveTarget {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();
};

struct PassiveRecording {
  PassiveScene scene;
  std::vector<BearingScan> scans;                   ///< bearings shuffled, with their truth
  std::vector<std::vector<PassiveTarget>> targets;  ///< of each scan, in the same order
};

/// The same seed gives the same recording. An error where sensors cannot be placed apart.
[[nodiscard]] Result<PassiveRecording> simulate_passive(const PassiveOptions& options,
                                                        std::uint64_t seed);

}  // namespace scanfuse::simulate
