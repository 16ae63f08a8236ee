#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"

namespace scanfuse {

/// One echo of one beam: Cartesian, in the sensor's frame (x forward, y left, z up; metres), beams
/// starting at the origin. Readers drop "no return" codes; every coordinate here is finite.
struct Return {
  float x_m = 0;
  float y_m = 0;
  float z_m = 0;
  float intensity = 0;
  float time_offset_s = 0;  ///< when this beam was fired, after the scan's stamp
  std::int32_t beam = -1;   ///< column of the beam pattern, increasing with bearing; -1: unknown
  std::int16_t layer = 0;   ///< 0 is the lowest
  std::uint8_t echo = 0;    ///< 0 is the nearest of its beam

  [[nodiscard]] float squared_range() const { return x_m * x_m + y_m * y_m; }
};

/// How the beams of a planar or few-layer scanner are laid out. Absent for unorganised clouds.
struct BeamPattern {
  double first_azimuth_rad = 0;  ///< of column 0
  double step_rad = 0;           ///< between columns, positive (counter-clockwise)
  int columns = 0;
  int layers = 1;
  double min_range_m = 0;
  double max_range_m = 0;
};

/// One sweep of one sensor. Returns are in no guaranteed order.
struct Scan {
  Time stamp;              ///< of the first beam, from the message's header
  std::int64_t frame = 0;  ///< counts the scans of a recording from 0; files may bring their own
  std::string sensor;      ///< topic or sensor column; tells sensors apart
  std::string frame_id;    ///< coordinate frame, for tf; may be empty
  std::vector<Return> returns;
  std::optional<BeamPattern> beams;
};

}  // namespace scanfuse
