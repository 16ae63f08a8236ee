#include "scanfuse/drivers/ouster/ouster.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace scanfuse::drivers::ouster {
namespace {

constexpr std::size_t kColumnHead = 16, kColumnTail = 4, kPixelBytes = 12;
constexpr std::size_t kMostChannels = 128;

/// The member of that name, wherever it stands: newer metadata have sections.
const nlohmann::json* find(const nlohmann::json& in, const std::string& name, int depth = 0) {
  if (!in.is_object() || depth > 8) return nullptr;
  if (const auto found = in.find(name); found != in.end()) return &*found;
  for (const auto& member : in) {
    if (const auto* found = find(member, name, depth + 1)) return found;
  }
  return nullptr;
}

std::vector<double> numbers(const nlohmann::json* list) {
  std::vector<double> all;
  if (list == nullptr || !list->is_array()) return all;
  for (const auto& value : *list) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) return {};
    all.push_back(value.get<double>());
  }
  return all;
}

/// "1024x10": columns a turn, turns a second.
int columns_of(const nlohmann::json& metadata) {
  if (const auto* count = find(metadata, "columns_per_frame");
      count && count->is_number_integer()) {
    const auto columns = count->get<std::int64_t>();
    return columns > 0 && columns <= 8192 ? static_cast<int>(columns) : 0;
  }
  const auto* mode = find(metadata, "lidar_mode");
  if (mode == nullptr || !mode->is_string()) return 1024;
  const int columns = std::atoi(mode->get<std::string>().c_str());
  return columns > 0 && columns <= 8192 ? columns : 0;
}

}  // namespace

Result<OusterBeams> parse_beams(std::string_view json) {
  const auto metadata = nlohmann::json::parse(json, nullptr, false);
  if (!metadata.is_object()) {
    return fail(Error::Code::kMalformed, "metadata of the Ouster: is no JSON object");
  }
  OusterBeams beams;
  beams.altitudes_deg = numbers(find(metadata, "beam_altitude_angles"));
  beams.azimuths_deg = numbers(find(metadata, "beam_azimuth_angles"));
  beams.columns_per_turn = columns_of(metadata);
  if (beams.altitudes_deg.empty() || beams.altitudes_deg.size() > kMostChannels ||
      beams.altitudes_deg.size() != beams.azimuths_deg.size() || beams.columns_per_turn == 0) {
    return fail(Error::Code::kMalformed,
                "metadata of the Ouster: beam_altitude_angles and beam_azimuth_angles are to be as "
                "many numbers each, and lidar_mode as 1024x10");
  }
  const auto* origin = find(metadata, "lidar_origin_to_beam_origin_mm");
  if (origin != nullptr && origin->is_number() && std::abs(origin->get<double>()) < 1000) {
    beams.origin_mm = origin->get<double>();
  }
  const auto transform = numbers(find(metadata, "lidar_to_sensor_transform"));
  if (transform.size() == 16) {
    std::copy(transform.begin(), transform.end(), beams.sensor_from_lidar.begin());
  }
  return beams;
}

std::string metadata_of(const OusterBeams& beams) {
  return nlohmann::json{{"beam_altitude_angles", beams.altitudes_deg},
                        {"beam_azimuth_angles", beams.azimuths_deg},
                        {"lidar_mode", std::to_string(beams.columns_per_turn) + "x10"},
                        {"lidar_origin_to_beam_origin_mm", beams.origin_mm},
                        {"lidar_to_sensor_transform", beams.sensor_from_lidar}}
      .dump();
}

OusterBeams usual_beams(int channels) {
  OusterBeams beams;
  for (int i = 0; i < channels; ++i) {
    beams.altitudes_deg.push_back(channels > 1 ? 16.6 - 33.2 * i / (channels - 1) : 0);
    beams.azimuths_deg.push_back(0);
  }
  return beams;
}

Result<std::vector<OusterColumn>> parse_packet(ByteView datagram) {
  const std::size_t column_bytes = datagram.size() / kColumnsPerPacket;
  const std::size_t fixed = kColumnHead + kColumnTail;
  const std::size_t channels = column_bytes > fixed ? (column_bytes - fixed) / kPixelBytes : 0;
  if (channels == 0 || channels > kMostChannels ||
      datagram.size() != kColumnsPerPacket * (fixed + channels * kPixelBytes)) {
    return fail(Error::Code::kMalformed, "a datagram of {} bytes is no lidar packet of LEGACY",
                datagram.size());
  }
  LittleReader in(datagram);
  std::vector<OusterColumn> columns(kColumnsPerPacket);
  for (OusterColumn& column : columns) {
    column.time_ns = in.read<std::uint64_t>();
    column.number = in.read<std::uint16_t>();
    column.frame = in.read<std::uint16_t>();
    column.encoder = in.read<std::uint32_t>();
    column.pixels.resize(channels);
    for (OusterPixel& pixel : column.pixels) {
      pixel.range_mm = in.read<std::uint32_t>() & 0xFFFFF;
      pixel.reflectivity = in.read<std::uint16_t>();
      pixel.signal = in.read<std::uint16_t>();
      pixel.ambient = in.read<std::uint16_t>();
      in.skip(2);
    }
    column.valid = in.read<std::uint32_t>() == 0xFFFFFFFF;
  }
  return columns;
}

Bytes encode_packet(const std::vector<OusterColumn>& columns) {
  Bytes datagram;
  LittleWriter out(datagram);
  for (const OusterColumn& column : columns) {
    out.write(column.time_ns).write(column.number).write(column.frame).write(column.encoder);
    for (const OusterPixel& pixel : column.pixels) {
      out.write(pixel.range_mm & 0xFFFFF).write(pixel.reflectivity).write(pixel.signal);
      out.write(pixel.ambient).write(std::uint16_t{0});
    }
    out.write(column.valid ? 0xFFFFFFFFU : 0U);
  }
  return datagram;
}

OusterBeams simulated_beams() {
  OusterBeams beams;
  for (int i = 0; i < 16; ++i) {
    beams.altitudes_deg.push_back(15 - 2 * i);
    beams.azimuths_deg.push_back(0);
  }
  beams.origin_mm = 0;
  beams.sensor_from_lidar[11] = 0;
  return beams;
}

}  // namespace scanfuse::drivers::ouster
