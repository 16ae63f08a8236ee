#include "scanfuse/simulate/sensor_model.hpp"

#include <cmath>

namespace scanfuse::simulate {
namespace {

const Pose3 kBumper{Eigen::Quaterniond::Identity(), {3.7, 0, 0.55}};
const Pose3 kRoof{Eigen::Quaterniond::Identity(), {1.3, 0, 1.73}};

BeamPattern beams_deg(double first, double step, int columns, int layers, double min_m,
                      double max_m) {
  return {radians(first), radians(step), columns, layers, min_m, max_m};
}

// ibeo LUX: 4 layers 0.8 deg apart from +35 to -50 deg, two of them on to +50 and -60, 0.25 deg at
// 12.5 Hz, 200 m, 50 m at 10 % remission, 3 echoes, beam 0.08 x 0.8 deg, clockwise seen from above
// (ibeo LUX 2010 data sheet). That the two outer layers are the lower ones is our choice.
SensorModel lux() {
  SensorModel m;
  m.pattern = beams_deg(-59.875, 0.25, 440, 4, 0.3, 200);
  for (int i = 0; i < 4; ++i) {
    const bool wide = i < 2;
    m.layers.push_back(
        {radians(-1.2 + 0.8 * i), radians(wide ? -60 : -50), radians(wide ? 50 : 35)});
  }
  m.rate_hz = 12.5;
  m.clockwise = true;
  m.sigma_range_m = 0.035;
  m.divergence_azimuth_rad = radians(0.08);
  m.divergence_elevation_rad = radians(0.8);
  m.echoes = 3;
  m.reach_m = 50;
  m.ego_from_sensor = kBumper;
  return m;
}

SensorModel planar(const BeamPattern& pattern, double rate_hz, double sigma_m,
                   double divergence_rad, double reach_m) {
  SensorModel m;
  m.pattern = pattern;
  m.layers = {Layer{}};
  m.rate_hz = rate_hz;
  m.sigma_range_m = sigma_m;
  m.divergence_azimuth_rad = m.divergence_elevation_rad = divergence_rad;
  m.reach_m = reach_m;
  m.ego_from_sensor = kBumper;
  return m;
}

SensorModel spinning(const BeamPattern& pattern, double sigma_m, double divergence_rad,
                     double reach_m) {
  SensorModel m = planar(pattern, 10, sigma_m, divergence_rad, reach_m);
  m.clockwise = true;
  m.layers.clear();
  m.ego_from_sensor = kRoof;
  return m;
}

// Velodyne VLP-16 manual: 16 layers from -15 to +15 deg, 0.2 deg at 10 Hz, 100 m, +-3 cm, 3 mrad.
SensorModel vlp16() {
  auto m = spinning(beams_deg(-180, 0.2, 1800, 16, 0.5, 100), 0.015, 0.003, 45);
  for (int i = 0; i < 16; ++i) m.layers.push_back({radians(-15 + 2.0 * i), -4, 4});
  return m;
}

// Velodyne HDL-32E data sheet: 32 layers from -30.67 to +10.67 deg, 1.33 deg apart, about 0.166 deg
// at 10 Hz, 100 m, +-2 cm.
SensorModel hdl32() {
  auto m = spinning(beams_deg(-180, 360.0 / 2170, 2170, 32, 1.0, 100), 0.01, 0.003, 45);
  for (int i = 0; i < 32; ++i) m.layers.push_back({radians(-30.67 + 41.34 / 31 * i), -4, 4});
  return m;
}

// Velodyne HDL-64E S2 data sheet: 32 layers from -24.33 to -8.83 deg 0.5 deg apart and 32 from
// -8.33 to +2 deg 1/3 deg apart, 0.1728 deg at 10 Hz, 120 m (50 m at 10 %), sigma below 2 cm.
SensorModel hdl64() {
  auto m = spinning(beams_deg(-180, 360.0 / 2083, 2083, 64, 0.9, 120), 0.02, 0.002, 50);
  for (int i = 0; i < 32; ++i) m.layers.push_back({radians(-24.33 + 0.5 * i), -4, 4});
  for (int i = 0; i < 32; ++i) m.layers.push_back({radians(-8.33 + 10.33 / 31 * i), -4, 4});
  return m;
}

}  // namespace

double SensorModel::time_offset_s(int column) const {
  const int order = clockwise ? pattern.columns - 1 - column : column;
  return order * pattern.step_rad / (2 * kPi) / rate_hz;
}

double SensorModel::sweep_s() const {
  return (pattern.columns - 1) * pattern.step_rad / (2 * kPi) / rate_hz;
}

SensorModel sensor_model(SensorPreset preset) {
  switch (preset) {
    case SensorPreset::kLux:
      return lux();
    // SICK LMS111 data sheet: 270 deg, 0.5 deg at 50 Hz, 0.5-20 m (18 m at 10 %), statistical error
    // 12 mm, beam 15 mrad.
    case SensorPreset::kSickLms111:
      return planar(beams_deg(-135, 0.5, 541, 1, 0.5, 20), 50, 0.012, 0.015, 18);
    // SICK LMS291 data sheet: 180 deg, 1 deg at 75 Hz, 80 m (30 m at 10 %), statistical error 10
    // mm; spot about 13 mrad.
    case SensorPreset::kSickLms291:
      return planar(beams_deg(-90, 1, 181, 1, 0.5, 80), 75, 0.01, 0.013, 30);
    // Hokuyo UTM-30LX data sheet: 270 deg, 0.25 deg, 40 Hz, 0.1-30 m, repeatability below 1 cm to
    // 10 m and 3 cm to 30 m.
    case SensorPreset::kHokuyoUtm30:
      return planar(beams_deg(-135, 0.25, 1081, 1, 0.1, 30), 40, 0.012, 0.003, 25);
    // Slamtec RPLidar A2M8 data sheet: 360 deg, 0.9 deg at 10 Hz, 0.15-12 m, below 1 % of the
    // range.
    case SensorPreset::kRplidarA2: {
      auto m = planar(beams_deg(-180, 0.9, 400, 1, 0.15, 12), 10, 0.02, 0.004, 10);
      m.clockwise = true;
      return m;
    }
    case SensorPreset::kVlp16:
      return vlp16();
    case SensorPreset::kHdl32:
      return hdl32();
    case SensorPreset::kHdl64:
      return hdl64();
  }
  return lux();
}

}  // namespace scanfuse::simulate
