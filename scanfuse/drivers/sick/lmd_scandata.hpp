#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/sick/cola.hpp"

namespace scanfuse::drivers::sick {

/// One output channel of a scan telegram: "DIST1", "RSSI1", "ANGL1", ... Value i stands at the
/// device's angle first + i * step; it means scale * value + offset (DIST: millimetres).
struct LmdChannel {
  std::string content;  ///< five letters
  float scale = 1;
  float offset = 0;
  std::int32_t first_angle = 0;  ///< ten-thousandths of a degree
  std::uint16_t step = 0;        ///< likewise
  std::vector<std::uint16_t> values;

  [[nodiscard]] double value(std::size_t i) const { return scale * values[i] + offset; }
};

/// The device's own date and time.
struct LmdTime {
  std::uint16_t year = 1970;
  std::uint8_t month = 1, day = 1, hour = 0, minute = 0, second = 0;
  std::uint32_t microsecond = 0;
};

/// A scan telegram LMDscandata [Sick2020, section 4.3], the same in both dialects.
struct LmdScan {
  std::uint16_t version = 1;
  std::uint16_t device = 1;
  std::uint32_t serial = 0;
  std::uint16_t status = 0;
  std::uint16_t telegram_counter = 0;
  std::uint16_t scan_counter = 0;
  std::uint32_t start_us = 0;     ///< since power up, when the scan began; starts again at 2^32
  std::uint32_t transmit_us = 0;  ///< likewise, when it was handed on to be sent
  std::uint16_t inputs = 0, outputs = 0;
  std::int16_t layer_angle = 0;        ///< MRS1000: hundredths of a degree, positive downwards
  std::uint32_t scan_frequency = 0;    ///< hundredths of a hertz
  std::uint32_t sample_frequency = 0;  ///< likewise
  std::vector<std::pair<std::uint32_t, std::uint16_t>> encoders;  ///< position, speed
  std::vector<LmdChannel> channels16;
  std::vector<LmdChannel> channels8;
  std::optional<std::array<float, 6>> position;
  std::uint8_t rotation_type = 0;
  std::string name, comment;
  std::optional<LmdTime> time;

  [[nodiscard]] const LmdChannel* find(std::string_view content) const;
};

/// Whether a telegram's content is a scan, sent on its own ("sSN") or asked for ("sRA").
[[nodiscard]] bool is_lmd_scan(ByteView content);

/// Decodes the content of a telegram that `is_lmd_scan`. Errors say at which byte, and what was
/// expected. What follows the channels may be cut off: older devices end there.
[[nodiscard]] Result<LmdScan> parse_lmd_scan(const ColaTelegram& telegram);

/// The whole telegram "sSN LMDscandata ...", framed.
[[nodiscard]] Bytes encode_lmd_scan(const LmdScan& scan, Cola dialect);

}  // namespace scanfuse::drivers::sick
