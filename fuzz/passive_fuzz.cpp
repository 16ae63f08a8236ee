#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "scanfuse/io/passive/passive.hpp"

namespace {

/// Two sensors, one of them without elevation.
scanfuse::PassiveScene two_sensors() {
  scanfuse::PassiveScene scene;
  scene.sensors.resize(2);
  scene.sensors[0].name = "a";
  scene.sensors[0].sigma_elevation_rad = 0.01;
  scene.sensors[1].name = "b";
  scene.sensors[1].world_from_sensor.translation_m.x() = 1000;
  return scene;
}

/// The bearings' reader takes a path.
const std::filesystem::path& scratch_file() {
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("passive_fuzz_" + std::to_string(::getpid()));
  return path;
}

}  // namespace

// The text as sensors, and as bearings of two sensors: what is read is finite and names a sensor.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto scene = io::parse_sensors(text, "fuzz.toml")) {
    if (scene->sensors.size() < 2) std::abort();
    for (const PassiveSensor& s : scene->sensors) {
      if (!s.world_from_sensor.translation_m.allFinite()) std::abort();
      if (!(s.sigma_azimuth_rad > 0) || !(s.clutter_density >= 0)) std::abort();
    }
  }
  static const PassiveScene scene = two_sensors();
  std::ofstream(scratch_file(), std::ios::binary | std::ios::trunc) << text;
  if (const auto scans = io::read_bearings(scratch_file(), scene)) {
    for (const BearingScan& scan : *scans) {
      for (const Bearing& b : scan.bearings) {
        if (b.sensor < 0 || b.sensor > 1) std::abort();
        if (!std::isfinite(b.azimuth_rad) || !std::isfinite(b.elevation_rad)) std::abort();
      }
    }
  }
  return 0;
}
