#pragma once

#include <array>
#include <utility>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::simulate {

enum class SensorPreset {
  kLux,
  kSickLms111,
  kSickLms291,
  kHokuyoUtm30,
  kRplidarA2,
  kVlp16,
  kHdl32,
  kHdl64
};

constexpr auto choices(SensorPreset) {
  using enum SensorPreset;
  return std::array{std::pair{"lux", kLux},
                    std::pair{"sick-lms111", kSickLms111},
                    std::pair{"sick-lms291", kSickLms291},
                    std::pair{"hokuyo-utm30", kHokuyoUtm30},
                    std::pair{"rplidar-a2", kRplidarA2},
                    std::pair{"vlp16", kVlp16},
                    std::pair{"hdl32", kHdl32},
                    std::pair{"hdl64", kHdl64}};
}

/// One layer: its elevation, and where in azimuth it measures.
struct Layer {
  double elevation_rad = 0;
  double from_rad = -kPi;
  double to_rad = kPi;
};

/// How a lidar measures, from its maker's public data sheet (named beside each preset).
struct SensorModel {
  BeamPattern pattern;
  std::vector<Layer> layers;  ///< lowest first
  double rate_hz = 10;
  bool clockwise = false;  ///< sweeps from the largest bearing to the smallest
  double sigma_range_m = 0.03;
  double divergence_azimuth_rad = 0;  ///< full angles of the beam
  double divergence_elevation_rad = 0;
  double merge_m = 0.6;   ///< echoes of one beam nearer to each other come back as one
  int echoes = 1;         ///< at most so many are told, nearest first
  double reach_m = 50;    ///< where a straight surface of 10 % is found half the time
  Pose3 ego_from_sensor;  ///< ego frame: rear axle, on the ground

  /// When the beam of a column is fired, after the scan's stamp.
  [[nodiscard]] double time_offset_s(int column) const;
  [[nodiscard]] double azimuth_rad(int column) const {
    return pattern.first_azimuth_rad + column * pattern.step_rad;
  }
  /// First and last beam of the scan apart in time.
  [[nodiscard]] double sweep_s() const;
};

[[nodiscard]] SensorModel sensor_model(SensorPreset preset);

}  // namespace scanfuse::simulate
