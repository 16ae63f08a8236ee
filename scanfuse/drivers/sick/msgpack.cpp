#include <zlib.h>

#include <algorithm>
#include <bit>
#include <map>
#include <string>
#include <variant>

#include "scanfuse/drivers/sick/scansegment.hpp"

namespace scanfuse::drivers::sick {
namespace {

/// The words of the format are numbers [SickScanSegment2023].
enum Key : int {
  kClass = 0x10,
  kData = 0x11,
  kCount = 0x12,
  kSize = 0x13,
  kEndian = 0x14,
  kTypes = 0x15,
  kLittle = 0x30,
  kFloat32 = 0x31,
  kUint8 = 0x33,
  kUint16 = 0x34,
  kTheta = 0x50,
  kPhi = 0x51,
  kDistances = 0x52,
  kStrengths = 0x53,
  kProperties = 0x54,
  kScanClass = 0x70,
  kStart = 0x71,
  kStop = 0x72,
  kThetaStart = 0x73,
  kThetaStop = 0x74,
  kScanNumber = 0x75,
  kModule = 0x76,
  kBeams = 0x77,
  kEchoes = 0x78,
  kSegmentClass = 0x90,
  kSegmentNumber = 0x91,
  kFrame = 0x92,
  kAvailable = 0x93,
  kSender = 0x94,
  kSegmentData = 0x96,
  kLayers = 0xA0,
  kTelegram = 0xB0,
  kTransmit = 0xB1
};

constexpr int kDeepest = 16;
constexpr std::size_t kMostBeams = 16384;

struct Value;
using Map = std::map<std::int64_t, Value>;
using List = std::vector<Value>;
struct Value {
  std::variant<std::monostate, std::int64_t, double, ByteView, List, Map> is;
};

/// Unpacks msgpack [Msgpack2013], as far as segments use it.
class Unpacker {
 public:
  explicit Unpacker(ByteView bytes) : in_(bytes) {}

  Value value(int depth = 0) {
    const int tag = in_.read<std::uint8_t>();
    if (depth > kDeepest || !in_.ok()) return wrong();
    if (tag < 0x80) return {std::int64_t{tag}};
    if (tag < 0x90) return map(static_cast<std::size_t>(tag & 15), depth);
    if (tag < 0xA0) return list(static_cast<std::size_t>(tag & 15), depth);
    if (tag < 0xC0) return {in_.take(static_cast<std::size_t>(tag & 31))};
    if (tag >= 0xE0) return {std::int64_t{tag - 256}};
    return tagged(tag, depth);
  }
  [[nodiscard]] bool ok() const { return ok_ && in_.ok(); }
  [[nodiscard]] std::size_t place() const { return in_.place(); }

 private:
  Value tagged(int tag, int depth) {
    switch (tag) {
      case 0xC0:
        return {};
      case 0xC2:
      case 0xC3:
        return {std::int64_t{tag - 0xC2}};
      case 0xC4:
      case 0xD9:
        return {in_.take(in_.read<std::uint8_t>())};
      case 0xC5:
      case 0xDA:
        return {in_.take(in_.read<std::uint16_t>())};
      case 0xC6:
      case 0xDB:
        return {in_.take(in_.read<std::uint32_t>())};
      case 0xCA:
        return {static_cast<double>(in_.read<float>())};
      case 0xCB:
        return {in_.read<double>()};
      case 0xCC:
        return {std::int64_t{in_.read<std::uint8_t>()}};
      case 0xCD:
        return {std::int64_t{in_.read<std::uint16_t>()}};
      case 0xCE:
        return {std::int64_t{in_.read<std::uint32_t>()}};
      case 0xCF:
        return {static_cast<std::int64_t>(in_.read<std::uint64_t>())};
      case 0xD0:
        return {std::int64_t{in_.read<std::int8_t>()}};
      case 0xD1:
        return {std::int64_t{in_.read<std::int16_t>()}};
      case 0xD2:
        return {std::int64_t{in_.read<std::int32_t>()}};
      case 0xD3:
        return {in_.read<std::int64_t>()};
      case 0xDC:
        return list(in_.read<std::uint16_t>(), depth);
      case 0xDE:
        return map(in_.read<std::uint16_t>(), depth);
      default:
        return wrong();
    }
  }
  Value wrong() {
    ok_ = false;
    return {};
  }
  Value list(std::size_t count, int depth) {
    List list;
    for (std::size_t i = 0; i < count && ok(); ++i) list.push_back(value(depth + 1));
    return {std::move(list)};
  }
  Value map(std::size_t count, int depth) {
    Map map;
    for (std::size_t i = 0; i < count && ok(); ++i) {
      const Value key = value(depth + 1);
      const auto* number = std::get_if<std::int64_t>(&key.is);
      if (number == nullptr) return wrong();
      map[*number] = value(depth + 1);
    }
    return {std::move(map)};
  }

  BigReader in_;
  bool ok_ = true;
};

const Value& member(const Value& of, Key key) {
  static const Value kNone;
  const auto* map = std::get_if<Map>(&of.is);
  if (map == nullptr) return kNone;
  const auto found = map->find(key);
  return found == map->end() ? kNone : found->second;
}

std::uint64_t whole(const Value& value) {
  const auto* number = std::get_if<std::int64_t>(&value.is);
  return number == nullptr ? 0 : static_cast<std::uint64_t>(*number);
}

const List& list_of(const Value& value) {
  static const List kNone;
  const auto* list = std::get_if<List>(&value.is);
  return list == nullptr ? kNone : *list;
}

/// The numbers of a channel: packed bytes with their type and order.
template <Number T>
std::vector<T> channel(const Value& of) {
  const auto* bytes = std::get_if<ByteView>(&member(of, kData).is);
  if (bytes == nullptr || whole(member(of, kSize)) != sizeof(T)) return {};
  const bool little = whole(member(of, kEndian)) == kLittle;
  std::vector<T> numbers;
  LittleReader from_little(*bytes);
  BigReader from_big(*bytes);
  for (std::size_t i = 0; i < std::min(bytes->size() / sizeof(T), kMostBeams); ++i) {
    numbers.push_back(little ? from_little.read<T>() : from_big.read<T>());
  }
  return numbers;
}

Result<SegmentLine> line_of(const Value& scan) {
  const Value& data = member(scan, kData);
  SegmentLine line;
  line.start_us = whole(member(data, kStart));
  line.stop_us = whole(member(data, kStop));
  const auto elevations = channel<float>(member(data, kPhi));
  const auto azimuths = channel<float>(member(data, kTheta));
  if (!elevations.empty()) line.elevation_rad = elevations.front();
  line.beams.resize(azimuths.size());
  for (std::size_t i = 0; i < azimuths.size(); ++i) line.beams[i].azimuth_rad = azimuths[i];
  for (const Value& echo : list_of(member(data, kDistances))) {
    const auto millimetres = channel<float>(echo);
    if (millimetres.size() != azimuths.size()) {
      return fail(Error::Code::kMalformed, "{} ranges for {} azimuths", millimetres.size(),
                  azimuths.size());
    }
    for (std::size_t i = 0; i < azimuths.size(); ++i) {
      line.beams[i].ranges_m.push_back(millimetres[i] * 1e-3F);
    }
  }
  for (const Value& echo : list_of(member(data, kStrengths))) {
    const auto strengths = channel<std::uint16_t>(echo);
    for (std::size_t i = 0; i < std::min(azimuths.size(), strengths.size()); ++i) {
      line.beams[i].strengths.push_back(strengths[i]);
    }
  }
  const auto& properties = list_of(member(data, kProperties));
  if (!properties.empty()) {
    const auto bits = channel<std::uint8_t>(properties.front());
    for (std::size_t i = 0; i < std::min(azimuths.size(), bits.size()); ++i) {
      line.beams[i].properties = bits[i];
    }
  }
  return line;
}

class Packer {
 public:
  explicit Packer(Bytes& to) : out_(to) {}
  void map(int members) { out_.write(static_cast<std::uint8_t>(0x80 | members)); }
  void list(std::size_t count) {
    out_.write(std::uint8_t{0xDC}).write(static_cast<std::uint16_t>(count));
  }
  void number(std::uint64_t value) { out_.write(std::uint8_t{0xCF}).write(value); }
  void key(Key key) { out_.write(std::uint8_t{0xCC}).write(static_cast<std::uint8_t>(key)); }
  template <class T>
  void member(Key name, T value) {
    key(name);
    number(static_cast<std::uint64_t>(value));
  }
  void fraction(Key name, float value) {
    key(name);
    out_.write(std::uint8_t{0xCA}).write(value);
  }
  template <Number T>
  void channel(Key type, const std::vector<T>& numbers) {
    map(5);
    member(kCount, numbers.size());
    member(kSize, sizeof(T));
    member(kEndian, kLittle);
    key(kTypes);
    list(1);
    number(type);
    key(kData);
    Bytes packed;
    LittleWriter little(packed);
    for (const T n : numbers) little.write(n);
    out_.write(std::uint8_t{0xC5}).write(static_cast<std::uint16_t>(packed.size()));
    out_.text(text_of(packed));
  }

 private:
  BigWriter out_;
};

template <class T, class Get>
std::vector<T> each(const SegmentLine& line, Get&& get) {
  std::vector<T> all;
  for (const SegmentBeam& beam : line.beams) all.push_back(get(beam));
  return all;
}

void pack_line(Packer& out, const SegmentLine& line, std::size_t number) {
  const std::size_t echoes = line.beams.empty() ? 0 : line.beams.front().ranges_m.size();
  const auto azimuths = each<float>(line, [](auto& beam) { return beam.azimuth_rad; });
  out.map(2);
  out.member(kClass, kScanClass);
  out.key(kData);
  out.map(13);
  out.member(kStart, line.start_us);
  out.member(kStop, line.stop_us);
  out.fraction(kThetaStart, azimuths.empty() ? 0.0F : azimuths.front());
  out.fraction(kThetaStop, azimuths.empty() ? 0.0F : azimuths.back());
  out.member(kScanNumber, number);
  out.member(kModule, std::uint64_t{0});
  out.key(kTheta);
  out.channel(kFloat32, azimuths);
  out.key(kPhi);
  out.channel(kFloat32, std::vector{line.elevation_rad});
  out.key(kDistances);
  out.list(echoes);
  for (std::size_t e = 0; e < echoes; ++e) {
    out.channel(kFloat32, each<float>(line, [e](auto& b) { return b.ranges_m[e] * 1e3F; }));
  }
  out.key(kStrengths);
  out.list(echoes);
  for (std::size_t e = 0; e < echoes; ++e) {
    out.channel(kUint16, each<std::uint16_t>(line, [e](auto& b) { return b.strengths[e]; }));
  }
  out.key(kProperties);
  out.list(1);
  out.channel(kUint8, each<std::uint8_t>(line, [](auto& beam) { return beam.properties; }));
  out.member(kBeams, line.beams.size());
  out.member(kEchoes, echoes);
}

}  // namespace

Result<Segment> parse_msgpack_segment(ByteView content) {
  Unpacker unpacker(content);
  const Value top = unpacker.value();
  if (!unpacker.ok()) {
    return fail(Error::Code::kMalformed, "byte {}: is no msgpack as segments have it",
                unpacker.place());
  }
  const Value& data = member(top, kData);
  if (whole(member(top, kClass)) != kSegmentClass) {
    return fail(Error::Code::kMalformed, "msgpack that is no segment");
  }
  Segment segment;
  segment.telegram = whole(member(data, kTelegram));
  segment.transmit_us = whole(member(data, kTransmit));
  segment.number = whole(member(data, kSegmentNumber));
  segment.frame = whole(member(data, kFrame));
  segment.sender = static_cast<std::uint32_t>(whole(member(data, kSender)));
  for (const Value& scan : list_of(member(data, kSegmentData))) {
    auto line = line_of(scan);
    if (!line) return tl::unexpected(line.error());
    segment.lines.push_back(std::move(*line));
  }
  return segment;
}

Bytes encode_msgpack(const Segment& segment) {
  Bytes content;
  Packer out(content);
  out.map(2);
  out.member(kClass, kSegmentClass);
  out.key(kData);
  out.map(8);
  out.member(kTelegram, segment.telegram);
  out.member(kTransmit, segment.transmit_us);
  out.member(kSegmentNumber, segment.number);
  out.member(kFrame, segment.frame);
  out.member(kAvailable, std::uint64_t{1});
  out.member(kSender, segment.sender);
  out.key(kLayers);
  out.list(segment.lines.size());
  for (std::size_t i = 0; i < segment.lines.size(); ++i) out.number(i + 1);
  out.key(kSegmentData);
  out.list(segment.lines.size());
  for (std::size_t i = 0; i < segment.lines.size(); ++i) pack_line(out, segment.lines[i], i + 1);
  Bytes telegram(4, std::byte{2});
  LittleWriter frame(telegram);
  frame.write(static_cast<std::uint32_t>(content.size()));
  append(telegram, content);
  frame.write(static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                                 static_cast<uInt>(content.size()))));
  return telegram;
}

}  // namespace scanfuse::drivers::sick
