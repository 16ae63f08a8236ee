#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scanfuse/io/ros/message_decoders.hpp"

namespace scanfuse::io::ros {

namespace {

constexpr double kLongestSweepS = 10;  ///< beam times beyond this are a driver's mistake

/// The fields that LaserScan and MultiEchoLaserScan start with, made fit for use.
struct Sweep {
  double first_angle_rad = 0;
  double increment_rad = 0;  ///< negative for scanners that turn clockwise
  double time_step_s = 0;
  float min_range_m = 0;
  float max_range_m = std::numeric_limits<float>::infinity();
};

Sweep read_sweep(WireReader& reader) {
  std::array<float, 7> v{};
  for (auto& value : v) value = reader.read<float>();
  Sweep sweep;
  sweep.first_angle_rad = v[0];
  sweep.increment_rad = v[2];
  sweep.time_step_s = v[3];
  if (v[5] >= 0 && v[6] > v[5]) {
    sweep.min_range_m = v[5];
    sweep.max_range_m = v[6];
  }
  return sweep;
}

/// Refuses angles that place no beams; leaves out times that cannot be.
void check_sweep(Sweep& sweep, std::size_t beams, WireReader& reader, Diagnostics& diagnostics) {
  const bool angles_finite = std::isfinite(sweep.first_angle_rad) &&
                             std::isfinite(sweep.increment_rad) &&
                             std::abs(sweep.first_angle_rad) < 100;
  const auto steps = static_cast<double>(beams);
  if (!angles_finite || std::abs(sweep.increment_rad) * steps > 100 ||
      (sweep.increment_rad == 0 && beams > 1)) {
    reader.refuse(fmt::format("angle_min {} and angle_increment {} place no beams",
                              sweep.first_angle_rad, sweep.increment_rad));
  }
  if (!(std::abs(sweep.time_step_s) * steps <= kLongestSweepS)) {
    diagnostics.note("beam times left out: time_increment makes no sense");
    sweep.time_step_s = 0;
  }
}

/// Where beam `index` of the message points, with its column and time.
Return aimed(const Sweep& sweep, std::size_t index, std::size_t beams, float range) {
  const auto i = static_cast<double>(index);
  const double azimuth = sweep.first_angle_rad + i * sweep.increment_rad;
  Return point;
  point.x_m = static_cast<float>(range * std::cos(azimuth));
  point.y_m = static_cast<float>(range * std::sin(azimuth));
  point.time_offset_s = static_cast<float>(i * sweep.time_step_s);
  point.beam = static_cast<std::int32_t>(sweep.increment_rad < 0 ? beams - 1 - index : index);
  return point;
}

bool is_return(const Sweep& sweep, float range) {
  return range > 0 && range >= sweep.min_range_m && range < sweep.max_range_m && range < kFarthestM;
}

std::optional<BeamPattern> pattern_of(const Sweep& sweep, std::size_t beams) {
  if (beams == 0 || sweep.increment_rad == 0) return std::nullopt;
  BeamPattern pattern;
  const double span = sweep.increment_rad * static_cast<double>(beams - 1);
  pattern.first_azimuth_rad = sweep.first_angle_rad + std::min(span, 0.0);
  pattern.step_rad = std::abs(sweep.increment_rad);
  pattern.columns = static_cast<int>(beams);
  pattern.min_range_m = sweep.min_range_m;
  pattern.max_range_m = sweep.max_range_m;
  return pattern;
}

std::vector<float> read_floats(WireReader& reader) {
  const auto count = reader.read_count(sizeof(float));
  std::vector<float> values(count);
  for (auto& value : values) value = reader.read<float>();
  return values;
}

float intensity_at(const std::vector<float>& intensities, std::size_t i) {
  return i < intensities.size() && std::isfinite(intensities[i]) ? intensities[i] : 0.0F;
}

struct Echo {
  float range;
  float intensity;
  std::size_t place;  ///< in the message
};

void append_echoes(const Sweep& sweep, std::size_t index, std::size_t beams,
                   std::vector<Echo>& echoes, Scan& scan) {
  std::erase_if(echoes, [&](const Echo& echo) { return !is_return(sweep, echo.range); });
  std::sort(echoes.begin(), echoes.end(), [](const Echo& a, const Echo& b) {
    return a.range != b.range ? a.range < b.range : a.place < b.place;
  });
  for (std::size_t k = 0; k < std::min<std::size_t>(echoes.size(), 256); ++k) {
    auto point = aimed(sweep, index, beams, echoes[k].range);
    point.intensity = std::isfinite(echoes[k].intensity) ? echoes[k].intensity : 0.0F;
    point.echo = static_cast<std::uint8_t>(k);
    scan.returns.push_back(point);
  }
}

std::vector<std::vector<float>> read_echo_lists(WireReader& reader) {
  std::vector<std::vector<float>> lists(reader.read_count(sizeof(std::uint32_t)));
  for (auto& list : lists) list = read_floats(reader);
  return lists;
}

}  // namespace

DecodedMessage decode_laser_scan(WireReader& reader) {
  DecodedMessage decoded;
  auto scan = read_stamped<Scan>(reader);
  Sweep sweep = read_sweep(reader);
  const auto ranges = read_floats(reader);
  const auto intensities = read_floats(reader);
  check_sweep(sweep, ranges.size(), reader, decoded.diagnostics);
  if (!reader.ok()) return decoded;
  if (!intensities.empty() && intensities.size() != ranges.size()) {
    decoded.diagnostics.note("LaserScan with another number of intensities than of ranges");
  }
  scan.beams = pattern_of(sweep, ranges.size());
  scan.returns.reserve(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!is_return(sweep, ranges[i])) continue;
    scan.returns.push_back(aimed(sweep, i, ranges.size(), ranges[i]));
    scan.returns.back().intensity = intensity_at(intensities, i);
  }
  decoded.payload = std::move(scan);
  return decoded;
}

DecodedMessage decode_multi_echo_laser_scan(WireReader& reader) {
  DecodedMessage decoded;
  auto scan = read_stamped<Scan>(reader);
  Sweep sweep = read_sweep(reader);
  const auto ranges = read_echo_lists(reader);
  const auto intensities = read_echo_lists(reader);
  check_sweep(sweep, ranges.size(), reader, decoded.diagnostics);
  if (!reader.ok()) return decoded;
  scan.beams = pattern_of(sweep, ranges.size());
  std::vector<Echo> echoes;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    echoes.clear();
    for (std::size_t k = 0; k < ranges[i].size(); ++k) {
      const bool known = i < intensities.size() && k < intensities[i].size();
      echoes.push_back({ranges[i][k], known ? intensities[i][k] : 0.0F, k});
    }
    append_echoes(sweep, i, ranges.size(), echoes, scan);
  }
  decoded.payload = std::move(scan);
  return decoded;
}

}  // namespace scanfuse::io::ros
