#include "scanfuse/io/kitti/oxts.hpp"

#include <array>
#include <cmath>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {

Result<OxtsPacket> parse_oxts(std::string_view line) {
  constexpr std::size_t kUsed = 23;  // up to the yaw rate about the upward axis
  std::array<double, kUsed> values{};
  std::size_t count = 0;
  for (std::size_t i = 0; count < kUsed;) {
    const std::size_t begin = line.find_first_not_of(" \t\r", i);
    if (begin == line.npos) break;
    i = std::min(line.find_first_of(" \t\r", begin), line.size());
    const auto word = line.substr(begin, i - begin);
    const auto number = parse_number(word);
    if (!number || std::abs(*number) > 1e6) {
      return fail(Error::Code::kMalformed, "'{:.40}' is not a fitting number", word);
    }
    values[count++] = *number;
  }
  if (count < kUsed) {
    return fail(Error::Code::kMalformed, "an oxts packet has 30 numbers, here are {}", count);
  }
  if (std::abs(values[0]) > 89) {
    return fail(Error::Code::kMalformed, "latitude {} is outside -89 .. 89 degrees", values[0]);
  }
  return OxtsPacket{radians(values[0]), radians(values[1]), values[2], values[3],
                    values[4],          values[5],          values[8], values[22]};
}

Eigen::Vector3d OxtsProjection::place(const OxtsPacket& packet) const {
  constexpr double kEarthRadius_m = 6378137;
  return {scale_ * kEarthRadius_m * packet.longitude_rad,
          scale_ * kEarthRadius_m * std::log(std::tan(kPi / 4 + packet.latitude_rad / 2)),
          packet.altitude_m};
}

Pose3 OxtsProjection::world_from_imu(const OxtsPacket& packet) {
  if (!started_) {
    started_ = true;
    scale_ = std::cos(packet.latitude_rad);
    origin_m_ = place(packet);
  }
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const Eigen::Quaterniond rotation = AngleAxisd(packet.yaw_rad, Vector3d::UnitZ()) *
                                      AngleAxisd(packet.pitch_rad, Vector3d::UnitY()) *
                                      AngleAxisd(packet.roll_rad, Vector3d::UnitX());
  return {rotation, place(packet) - origin_m_};
}

}  // namespace scanfuse::io
