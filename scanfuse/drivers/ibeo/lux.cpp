#include "scanfuse/drivers/ibeo/lux.hpp"

namespace scanfuse::drivers::ibeo {
namespace {

constexpr std::uint32_t kMagic = 0xAFFEC0C2;
constexpr std::uint32_t kLongest = 1 << 20;
constexpr std::size_t kPointBytes = 10;

LuxPoint read_point(LittleReader& in) {
  LuxPoint point;
  const auto layer_and_echo = in.read<std::uint8_t>();
  point.layer = layer_and_echo & 15;
  point.echo = layer_and_echo >> 4;
  point.flags = in.read<std::uint8_t>();
  point.angle = in.read<std::int16_t>();
  point.range_cm = in.read<std::uint16_t>();
  point.width_cm = in.read<std::uint16_t>();
  in.skip(2);
  return point;
}

}  // namespace

Cut cut_lux(ByteView bytes) {
  if (bytes[0] != std::byte{0xAF}) return {until(bytes, std::byte{0xAF}), 0};
  if (bytes.size() < kLuxHeadBytes) return {};
  if (BigReader(bytes).read<std::uint32_t>() != kMagic) return {1, 0};
  const LuxHead head = parse_lux_head(bytes);
  if (head.size > kLongest) return {1, 0};
  const std::size_t whole = kLuxHeadBytes + head.size;
  return bytes.size() < whole ? Cut{} : Cut{0, whole};
}

LuxHead parse_lux_head(ByteView message) {
  BigReader in(message);
  in.skip(4);
  LuxHead head;
  head.previous_size = in.read<std::uint32_t>();
  head.size = in.read<std::uint32_t>();
  in.skip(1);
  head.device = in.read<std::uint8_t>();
  head.type = in.read<std::uint16_t>();
  head.ntp = in.read<std::uint64_t>();
  return head;
}

Result<LuxScan> parse_lux_scan(ByteView body) {
  LittleReader in(body);
  LuxScan scan;
  scan.number = in.read<std::uint16_t>();
  scan.status = in.read<std::uint16_t>();
  scan.sync_offset = in.read<std::uint16_t>();
  scan.start_ntp = in.read<std::uint64_t>();
  scan.end_ntp = in.read<std::uint64_t>();
  scan.ticks_per_turn = in.read<std::uint16_t>();
  scan.start_angle = in.read<std::int16_t>();
  scan.end_angle = in.read<std::int16_t>();
  const std::size_t count = in.read<std::uint16_t>();
  for (auto* field : {&scan.yaw, &scan.pitch, &scan.roll, &scan.x_cm, &scan.y_cm, &scan.z_cm}) {
    *field = in.read<std::int16_t>();
  }
  scan.flags = in.read<std::uint16_t>();
  if (!in.ok() || in.left() < count * kPointBytes || scan.ticks_per_turn == 0) {
    return fail(Error::Code::kMalformed,
                "a scan of {} bytes cannot have {} points, or its angles have no unit", body.size(),
                count);
  }
  scan.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) scan.points.push_back(read_point(in));
  return scan;
}

Bytes encode_lux_scan(const LuxScan& scan, std::uint64_t sent_ntp) {
  Bytes body;
  LittleWriter out(body);
  out.write(scan.number).write(scan.status).write(scan.sync_offset);
  out.write(scan.start_ntp).write(scan.end_ntp).write(scan.ticks_per_turn);
  out.write(scan.start_angle).write(scan.end_angle);
  out.write(static_cast<std::uint16_t>(scan.points.size()));
  out.write(scan.yaw).write(scan.pitch).write(scan.roll);
  out.write(scan.x_cm).write(scan.y_cm).write(scan.z_cm).write(scan.flags);
  for (const LuxPoint& point : scan.points) {
    out.write(static_cast<std::uint8_t>(point.layer | point.echo << 4)).write(point.flags);
    out.write(point.angle).write(point.range_cm).write(point.width_cm).write(std::uint16_t{0});
  }
  Bytes message;
  BigWriter head(message);
  head.write(kMagic).write(std::uint32_t{0}).write(static_cast<std::uint32_t>(body.size()));
  head.write(std::uint8_t{0}).write(std::uint8_t{1}).write(kScanData).write(sent_ntp);
  append(message, body);
  return message;
}

}  // namespace scanfuse::drivers::ibeo
