#include "scanfuse/triangulate/lines_by_sensor.hpp"

#include <algorithm>

namespace scanfuse::triangulate {

std::vector<LinesOfSensor> lines_by_sensor(std::span<const LineOfSight> lines,
                                           const PassiveScene& scene) {
  std::vector<LinesOfSensor> sensors(scene.sensors.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    LinesOfSensor& of = sensors[static_cast<std::size_t>(lines[i].sensor)];
    of.lines.push_back(lines[i]);
    of.places.push_back(static_cast<std::int32_t>(i));
    of.widest_rad = std::max({of.widest_rad, lines[i].sigma_left_rad, lines[i].sigma_up_rad});
  }
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    sensors[s].origin_m = scene.sensors[s].world_from_sensor.translation_m;
    sensors[s].by_azimuth = AzimuthIndex(scene.sensors[s], sensors[s].lines);
  }
  return sensors;
}

}  // namespace scanfuse::triangulate
