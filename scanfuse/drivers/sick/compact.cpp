#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scanfuse/drivers/sick/scansegment.hpp"

namespace scanfuse::drivers::sick {
namespace {

constexpr std::uint32_t kScan = 1;  // what a compact telegram holds
constexpr std::uint32_t kInertial = 2;
constexpr std::size_t kInertialBytes = 64;
constexpr std::size_t kHead = 32;
constexpr std::size_t kLongest = std::size_t{1} << 20;
constexpr std::uint32_t kMostLines = 256, kMostBeams = 16384, kMostEchoes = 16;

std::uint32_t word(ByteView bytes, std::size_t at) {
  return LittleReader(bytes.subspan(at)).read<std::uint32_t>();
}

std::uint32_t checksum(ByteView bytes) {
  return static_cast<std::uint32_t>(
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

bool is_sound(ByteView telegram, std::size_t from) {
  const auto checked = telegram.subspan(from, telegram.size() - from - 4);
  return checksum(checked) == word(telegram, telegram.size() - 4);
}

/// Where a module says how long the next is; 0 where the module is not all there.
std::size_t next_size_at(ByteView module) {
  if (module.size() < 32) return 0;
  const std::size_t lines = word(module, 20);
  const std::size_t at = 32 + 28 * lines + 4;
  return lines <= kMostLines && at + 8 <= module.size() ? at : 0;
}

/// How long a compact telegram is: its modules say so, each of the next. 0: more bytes must come;
/// nothing: it makes no sense.
std::optional<std::size_t> length_of_compact(ByteView bytes) {
  std::size_t end = kHead;
  for (std::size_t size = word(bytes, 28); size > 0;) {
    if (size > kLongest || end + size > kLongest) return std::nullopt;
    const auto module = bytes.subspan(std::min(end, bytes.size()));
    if (module.size() < size) return std::size_t{0};
    const std::size_t at = next_size_at(module.first(size));
    if (at == 0) return std::nullopt;
    end += size;
    size = word(module, at);
  }
  return end + 4;
}

Cut whole_if_sound(ByteView bytes, std::size_t size, std::size_t checked_from) {
  if (bytes.size() < size) return {};
  return is_sound(bytes.first(size), checked_from) ? Cut{0, size} : Cut{1, 0};
}

struct ModuleShape {
  std::uint32_t lines = 0, beams = 0, echoes = 0;
  float scale = 1;
  bool strengths = false, properties = false, azimuths = false;
};

SegmentBeam read_beam(LittleReader& in, const ModuleShape& shape) {
  SegmentBeam beam;
  for (std::uint32_t echo = 0; echo < shape.echoes; ++echo) {
    beam.ranges_m.push_back(static_cast<float>(in.read<std::uint16_t>()) * shape.scale * 1e-3F);
    beam.strengths.push_back(shape.strengths ? in.read<std::uint16_t>() : std::uint16_t{0});
  }
  if (shape.properties) beam.properties = in.read<std::uint8_t>();
  if (shape.azimuths) {
    beam.azimuth_rad = (static_cast<float>(in.read<std::uint16_t>()) - 16384.0F) / 5215.0F;
  }
  return beam;
}

Result<std::size_t> read_module(ByteView module, Segment& segment) {
  LittleReader in(module);
  segment.number = in.read<std::uint64_t>();
  segment.frame = in.read<std::uint64_t>();
  segment.sender = in.read<std::uint32_t>();
  ModuleShape shape;
  shape.lines = in.read<std::uint32_t>();
  shape.beams = in.read<std::uint32_t>();
  shape.echoes = in.read<std::uint32_t>();
  if (shape.lines > kMostLines || shape.beams > kMostBeams || shape.echoes > kMostEchoes) {
    return fail(Error::Code::kMalformed, "a module of {} lines, {} beams, {} echoes", shape.lines,
                shape.beams, shape.echoes);
  }
  std::vector<SegmentLine> lines(shape.lines);
  std::vector<float> first(shape.lines), last(shape.lines);
  for (auto& line : lines) line.start_us = in.read<std::uint64_t>();
  for (auto& line : lines) line.stop_us = in.read<std::uint64_t>();
  for (auto& line : lines) line.elevation_rad = in.read<float>();
  for (auto& azimuth : first) azimuth = in.read<float>();
  for (auto& azimuth : last) azimuth = in.read<float>();
  shape.scale = in.read<float>();
  const std::size_t next = in.read<std::uint32_t>();
  in.skip(1);
  const auto per_echo = in.read<std::uint8_t>(), per_beam = in.read<std::uint8_t>();
  in.skip(1);
  shape.strengths = (per_echo & 2) != 0;
  shape.properties = (per_beam & 1) != 0;
  shape.azimuths = (per_beam & 2) != 0;
  const std::size_t per = shape.echoes * (shape.strengths ? 4 : 2) + (shape.properties ? 1 : 0) +
                          (shape.azimuths ? 2 : 0);
  if ((per_echo & 1) == 0 || in.left() < per * shape.beams * shape.lines) {
    return fail(Error::Code::kMalformed, "a module without ranges, or with too few bytes for them");
  }
  for (std::uint32_t beam = 0; beam < shape.beams; ++beam) {
    for (std::uint32_t line = 0; line < shape.lines; ++line) {
      auto& beams = lines[line].beams;
      beams.push_back(read_beam(in, shape));
      const float share = shape.beams > 1 ? static_cast<float>(beam) / (shape.beams - 1) : 0;
      if (!shape.azimuths) {
        beams.back().azimuth_rad = first[line] + share * (last[line] - first[line]);
      }
    }
  }
  segment.lines.insert(segment.lines.end(), lines.begin(), lines.end());
  return next;
}

Result<Segment> parse_compact(ByteView telegram) {
  LittleReader in(telegram);
  in.skip(8);
  Segment segment;
  segment.telegram = in.read<std::uint64_t>();
  segment.transmit_us = in.read<std::uint64_t>();
  in.skip(4);
  std::size_t size = in.read<std::uint32_t>();
  while (size > 0) {
    const std::size_t at = in.place();
    const ByteView module = in.take(size);
    if (!in.ok()) return fail(Error::Code::kMalformed, "byte {}: a module is cut off", at);
    const auto next = read_module(module, segment);
    if (!next) {
      return fail(next.error().code, "module at byte {}: {}", at, next.error().message);
    }
    size = *next;
  }
  return segment;
}

bool fits_module(const SegmentLine& a, const SegmentLine& b) {
  const auto echoes = [](const SegmentLine& line) {
    return line.beams.empty() ? 0 : line.beams.front().ranges_m.size();
  };
  return a.beams.size() == b.beams.size() && echoes(a) == echoes(b);
}

template <class Lines, class Value>
void write_all(LittleWriter& out, const Lines& lines, Value&& value) {
  for (const SegmentLine& line : lines) out.write(value(line));
}

void write_beam(LittleWriter& out, const SegmentBeam& beam) {
  for (std::size_t echo = 0; echo < beam.ranges_m.size(); ++echo) {
    const long raw = std::lround(beam.ranges_m[echo] * 1e3F);
    out.write(static_cast<std::uint16_t>(std::clamp(raw, 0L, 65535L)));
    out.write(echo < beam.strengths.size() ? beam.strengths[echo] : std::uint16_t{0});
  }
  out.write(beam.properties);
  const long raw = std::lround(beam.azimuth_rad * 5215.0F + 16384.0F);
  out.write(static_cast<std::uint16_t>(std::clamp(raw, 0L, 65535L)));
}

Bytes module_of(const Segment& segment, std::span<const SegmentLine> lines) {
  Bytes module;
  LittleWriter out(module);
  const auto& beams = lines.front().beams;
  out.write(segment.number).write(segment.frame).write(segment.sender);
  out.write(static_cast<std::uint32_t>(lines.size()));
  out.write(static_cast<std::uint32_t>(beams.size()));
  out.write(static_cast<std::uint32_t>(beams.empty() ? 0 : beams.front().ranges_m.size()));
  write_all(out, lines, [](auto& line) { return line.start_us; });
  write_all(out, lines, [](auto& line) { return line.stop_us; });
  write_all(out, lines, [](auto& line) { return line.elevation_rad; });
  write_all(out, lines,
            [](auto& line) { return line.beams.empty() ? 0.0F : line.beams.front().azimuth_rad; });
  write_all(out, lines,
            [](auto& line) { return line.beams.empty() ? 0.0F : line.beams.back().azimuth_rad; });
  out.write(1.0F).write(std::uint32_t{0});  // how long the next module is, once it is known
  out.write(std::uint32_t{0x00030301});     // there: ranges, strengths, properties, azimuths
  for (std::size_t beam = 0; beam < beams.size(); ++beam) {
    for (const SegmentLine& line : lines) write_beam(out, line.beams[beam]);
  }
  return module;
}

}  // namespace

Cut cut_scansegment(ByteView bytes) {
  std::size_t count = 0;
  while (count < bytes.size() && count < 4 && bytes[count] == std::byte{2}) ++count;
  if (count == 0) return {until(bytes, std::byte{2}), 0};
  if (count == bytes.size()) return {};
  if (count < 4) return {count, 0};
  if (bytes.size() < 12) return {};
  const std::size_t kind = word(bytes, 4);
  if (kind == kInertial) return whole_if_sound(bytes, kInertialBytes, 0);
  if (kind != kScan) {
    // The length of a msgpack telegram, whose content is a map.
    if (kind > kLongest || kind < 16 || (std::to_integer<int>(bytes[8]) & 0xF0) != 0x80) {
      return {1, 0};
    }
    return whole_if_sound(bytes, kind + 12, 8);
  }
  if (bytes.size() < kHead) return {};
  const auto size = length_of_compact(bytes);
  if (!size) return {1, 0};
  return *size == 0 ? Cut{} : whole_if_sound(bytes, *size, 0);
}

bool is_segment(ByteView telegram) { return word(telegram, 4) != kInertial; }

Result<Segment> parse_segment(ByteView telegram) {
  if (telegram.size() < 16) return fail(Error::Code::kMalformed, "a segment of too few bytes");
  const auto content = telegram.first(telegram.size() - 4);
  return word(telegram, 4) == kScan ? parse_compact(content)
                                    : parse_msgpack_segment(content.subspan(8));
}

Bytes encode_compact(const Segment& segment) {
  std::vector<Bytes> modules;
  for (std::size_t i = 0; i < segment.lines.size();) {
    std::size_t end = i + 1;
    while (end < segment.lines.size() && fits_module(segment.lines[i], segment.lines[end])) ++end;
    modules.push_back(module_of(segment, std::span(segment.lines).subspan(i, end - i)));
    i = end;
  }
  Bytes telegram(4, std::byte{2});
  LittleWriter out(telegram);
  out.write(kScan).write(segment.telegram).write(segment.transmit_us).write(std::uint32_t{4});
  out.write(static_cast<std::uint32_t>(modules.empty() ? 0 : modules.front().size()));
  for (std::size_t i = 0; i < modules.size(); ++i) {
    Bytes size;
    const std::size_t next = i + 1 < modules.size() ? modules[i + 1].size() : 0;
    LittleWriter(size).write(static_cast<std::uint32_t>(next));
    std::ranges::copy(size,
                      modules[i].begin() + static_cast<std::ptrdiff_t>(next_size_at(modules[i])));
    append(telegram, modules[i]);
  }
  out.write(checksum(telegram));
  return telegram;
}

}  // namespace scanfuse::drivers::sick
