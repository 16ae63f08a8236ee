#include "scanfuse/drivers/sick/lmd_scandata.hpp"

#include <algorithm>
#include <charconv>

namespace scanfuse::drivers::sick {
namespace {

constexpr std::string_view kSent = "sSN LMDscandata";
constexpr std::string_view kAsked = "sRA LMDscandata";
constexpr std::size_t kMostChannels = 16;
constexpr std::size_t kMostEncoders = 16;

/// Fields of dialect B: fixed widths, big endian.
class BinaryFields {
 public:
  explicit BinaryFields(ByteView bytes) : reader_(bytes) {}
  template <Number T>
  T read() {
    return reader_.read<T>();
  }
  std::string text(std::size_t count) { return std::string(text_of(reader_.take(count))); }
  [[nodiscard]] bool ok() const { return reader_.ok(); }
  [[nodiscard]] std::size_t place() const { return reader_.place(); }
  [[nodiscard]] std::size_t left() const { return reader_.left(); }

 private:
  BigReader reader_;
};

/// Fields of dialect A: words, numbers in hexadecimal without leading zeros (negative ones in
/// two's complement, fractions as the bits of a float), or in decimal behind a sign.
class TextFields {
 public:
  explicit TextFields(ByteView bytes) : text_(text_of(bytes)) {}
  template <Number T>
  T read() {
    const std::string_view w = word();
    if (w.starts_with('+') || w.starts_with('-')) {
      return static_cast<T>(number<std::int64_t>(w.substr(w[0] == '+' ? 1 : 0), 10));
    }
    const auto bits = number<std::uint32_t>(w, 16);
    if constexpr (std::floating_point<T>) {
      return std::bit_cast<float>(bits);
    } else {
      return static_cast<T>(bits);
    }
  }
  std::string text(std::size_t count) {
    if (place_ < text_.size()) ++place_;  // the space before
    const std::string_view found = text_.substr(std::min(place_, text_.size()), count);
    ok_ = ok_ && found.size() == count;
    place_ += found.size();
    return std::string(found);
  }
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t place() const { return place_; }
  [[nodiscard]] std::size_t left() const { return text_.size() - place_; }

 private:
  std::string_view word() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    const std::size_t end = std::min(text_.find(' ', place_), text_.size());
    const std::string_view found = text_.substr(place_, end - place_);
    place_ = end;
    ok_ = ok_ && !found.empty();
    return found;
  }
  template <class T>
  T number(std::string_view word, int base) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    ok_ = ok_ && error == std::errc{} && end == word.data() + word.size();
    return value;
  }

  std::string_view text_;
  std::size_t place_ = 0;
  bool ok_ = true;
};

template <class Value, class Fields>
LmdChannel read_channel(Fields& in) {
  LmdChannel channel;
  channel.content = in.text(5);
  channel.scale = in.template read<float>();
  channel.offset = in.template read<float>();
  channel.first_angle = in.template read<std::int32_t>();
  channel.step = in.template read<std::uint16_t>();
  const std::size_t count = in.template read<std::uint16_t>();
  // Every value takes a byte at least: a count that cannot be is not believed.
  channel.values.reserve(std::min(count, in.left()));
  for (std::size_t i = 0; i < count && in.ok(); ++i) {
    channel.values.push_back(in.template read<Value>());
  }
  return channel;
}

template <class Value, class Fields>
void read_channels(Fields& in, std::vector<LmdChannel>& channels) {
  const std::size_t count = in.template read<std::uint16_t>();
  for (std::size_t i = 0; i < std::min(count, kMostChannels) && in.ok(); ++i) {
    channels.push_back(read_channel<Value>(in));
  }
}

template <class Fields>
LmdTime read_time(Fields& in) {
  LmdTime time;
  time.year = in.template read<std::uint16_t>();
  for (auto* field : {&time.month, &time.day, &time.hour, &time.minute, &time.second}) {
    *field = in.template read<std::uint8_t>();
  }
  time.microsecond = in.template read<std::uint32_t>();
  return time;
}

template <class Fields>
void read_status(Fields& in, LmdScan& scan) {
  const auto pair = [&] {
    const auto high = in.template read<std::uint8_t>();
    return static_cast<std::uint16_t>(high << 8 | in.template read<std::uint8_t>());
  };
  scan.version = in.template read<std::uint16_t>();
  scan.device = in.template read<std::uint16_t>();
  scan.serial = in.template read<std::uint32_t>();
  scan.status = pair();
  scan.telegram_counter = in.template read<std::uint16_t>();
  scan.scan_counter = in.template read<std::uint16_t>();
  scan.start_us = in.template read<std::uint32_t>();
  scan.transmit_us = in.template read<std::uint32_t>();
  scan.inputs = pair();
  scan.outputs = pair();
  scan.layer_angle = in.template read<std::int16_t>();
  scan.scan_frequency = in.template read<std::uint32_t>();
  scan.sample_frequency = in.template read<std::uint32_t>();
  const std::size_t encoders = in.template read<std::uint16_t>();
  for (std::size_t i = 0; i < std::min(encoders, kMostEncoders) && in.ok(); ++i) {
    const auto position = in.template read<std::uint32_t>();
    scan.encoders.emplace_back(position, in.template read<std::uint16_t>());
  }
}

template <class Fields>
void read_tail(Fields& in, LmdScan& scan) {
  if (in.template read<std::uint16_t>() == 1) {
    std::array<float, 6> position{};
    for (float& value : position) value = in.template read<float>();
    scan.position = position;
    scan.rotation_type = in.template read<std::uint8_t>();
  }
  for (std::string* text : {&scan.name, &scan.comment}) {
    if (in.template read<std::uint16_t>() != 1) continue;
    *text = in.text(in.template read<std::uint8_t>());
  }
  if (in.template read<std::uint16_t>() == 1) scan.time = read_time(in);
}

template <class Fields>
Result<LmdScan> parse(ByteView content) {
  Fields in(content);
  LmdScan scan;
  read_status(in, scan);
  read_channels<std::uint16_t>(in, scan.channels16);
  if (!in.ok()) {
    return fail(Error::Code::kMalformed, "byte {} of a scan telegram: a field is missing or wrong",
                in.place() + kSent.size() + 1);
  }
  read_channels<std::uint8_t>(in, scan.channels8);
  const LmdScan measured = scan;
  read_tail(in, scan);
  return in.ok() ? scan : measured;
}

class BinaryOut {
 public:
  explicit BinaryOut(Bytes& to) : writer_(to) { writer_.text(" "); }
  template <Number T>
  void write(T value) {
    writer_.write(value);
  }
  void text(std::string_view text) { writer_.text(text); }

 private:
  BigWriter writer_;
};

class TextOut {
 public:
  explicit TextOut(Bytes& to) : to_(&to) {}
  template <Number T>
  void write(T value) {
    std::uint32_t bits = 0;
    if constexpr (std::floating_point<T>) {
      bits = std::bit_cast<std::uint32_t>(value);
    } else {
      bits = static_cast<std::make_unsigned_t<T>>(value);
    }
    text(fmt::format("{:X}", bits));
  }
  void text(std::string_view text) {
    append(*to_, view_of(" "));
    append(*to_, view_of(text));
  }

 private:
  Bytes* to_;
};

template <class Value, class Out>
void write_channels(Out& out, const std::vector<LmdChannel>& channels) {
  out.write(static_cast<std::uint16_t>(channels.size()));
  for (const LmdChannel& channel : channels) {
    out.text(channel.content);
    out.write(channel.scale);
    out.write(channel.offset);
    out.write(channel.first_angle);
    out.write(channel.step);
    out.write(static_cast<std::uint16_t>(channel.values.size()));
    for (const auto value : channel.values) out.write(static_cast<Value>(value));
  }
}

template <class Out>
void write_status(Out& out, const LmdScan& scan) {
  const auto pair = [&](std::uint16_t value) {
    out.write(static_cast<std::uint8_t>(value >> 8));
    out.write(static_cast<std::uint8_t>(value & 0xFF));
  };
  out.write(scan.version);
  out.write(scan.device);
  out.write(scan.serial);
  pair(scan.status);
  out.write(scan.telegram_counter);
  out.write(scan.scan_counter);
  out.write(scan.start_us);
  out.write(scan.transmit_us);
  pair(scan.inputs);
  pair(scan.outputs);
  out.write(scan.layer_angle);
  out.write(scan.scan_frequency);
  out.write(scan.sample_frequency);
  out.write(static_cast<std::uint16_t>(scan.encoders.size()));
  for (const auto& [position, speed] : scan.encoders) {
    out.write(position);
    out.write(speed);
  }
}

template <class Out>
void write_tail(Out& out, const LmdScan& scan) {
  out.write(static_cast<std::uint16_t>(scan.position ? 1 : 0));
  if (scan.position) {
    for (const float value : *scan.position) out.write(value);
    out.write(scan.rotation_type);
  }
  for (const std::string* text : {&scan.name, &scan.comment}) {
    out.write(static_cast<std::uint16_t>(text->empty() ? 0 : 1));
    if (text->empty()) continue;
    out.write(static_cast<std::uint8_t>(text->size()));
    out.text(*text);
  }
  out.write(static_cast<std::uint16_t>(scan.time ? 1 : 0));
  if (scan.time) {
    out.write(scan.time->year);
    for (const auto field : {scan.time->month, scan.time->day, scan.time->hour, scan.time->minute,
                             scan.time->second}) {
      out.write(field);
    }
    out.write(scan.time->microsecond);
  }
  out.write(std::uint16_t{0});  // no event
}

template <class Out>
Bytes encode(const LmdScan& scan) {
  Bytes content;
  append(content, view_of(kSent));
  Out out(content);
  write_status(out, scan);
  write_channels<std::uint16_t>(out, scan.channels16);
  write_channels<std::uint8_t>(out, scan.channels8);
  write_tail(out, scan);
  return content;
}

}  // namespace

const LmdChannel* LmdScan::find(std::string_view content) const {
  for (const auto* channels : {&channels16, &channels8}) {
    for (const LmdChannel& channel : *channels) {
      if (channel.content == content) return &channel;
    }
  }
  return nullptr;
}

bool is_lmd_scan(ByteView content) {
  // Behind the name: the maker's viewer also asks for "LMDscandatamon", which says all again.
  const std::string_view text = text_of(content);
  const bool is_named = text.starts_with(kSent) || text.starts_with(kAsked);
  return is_named && text.size() > kSent.size() && text[kSent.size()] == ' ';
}

Result<LmdScan> parse_lmd_scan(const ColaTelegram& telegram) {
  if (!is_lmd_scan(telegram.content)) {
    return fail(Error::Code::kMalformed, "a telegram that is no scan");
  }
  const ByteView fields = telegram.content.subspan(kSent.size() + 1);
  return telegram.dialect == Cola::kA ? parse<TextFields>(fields) : parse<BinaryFields>(fields);
}

Bytes encode_lmd_scan(const LmdScan& scan, Cola dialect) {
  return close_cola(dialect, dialect == Cola::kA ? encode<TextOut>(scan) : encode<BinaryOut>(scan));
}

}  // namespace scanfuse::drivers::sick
