#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/stream.hpp"

namespace scanfuse::drivers::hokuyo {

/// What the sensor tells of itself when asked with PP [Scip2008].
struct ScipParameters {
  int min_range_mm = 23;
  int max_range_mm = 60000;
  int steps_per_turn = 1440;
  int first_step = 0, last_step = 1080;
  int front_step = 540;
  int turns_per_minute = 2400;
};

/// One scan, as MD (ranges) or ME (ranges and strengths) sends it.
struct ScipScan {
  bool has_strengths = false;
  int first_step = 0, last_step = 0;
  int cluster = 1;            ///< neighbouring steps of which the nearest is told
  std::uint32_t time_ms = 0;  ///< 24 bits, then it starts again
  std::vector<std::uint32_t> ranges_mm;
  std::vector<std::uint32_t> strengths;
};

/// A number in characters of six bits each, the highest first, counted from '0' on.
[[nodiscard]] std::optional<std::uint32_t> decode_characters(std::string_view text);
[[nodiscard]] std::string encode_characters(std::uint32_t value, int characters);
/// The character that ends each line: the six low bits of the sum of its bytes, counted from '0'.
[[nodiscard]] char checksum(std::string_view text);

/// The front of what a sensor says: an answer ends at an empty line.
[[nodiscard]] Cut cut_scip(ByteView bytes);

/// An answer taken apart: what was asked, the status, and the lines behind it without checksums.
struct ScipAnswer {
  std::string command;
  std::string status;
  std::vector<std::string> lines;
};
/// A wrong checksum is an error that names the line.
[[nodiscard]] Result<ScipAnswer> parse_answer(ByteView answer);
[[nodiscard]] Bytes encode_answer(const ScipAnswer& answer);

[[nodiscard]] bool is_scan(const ScipAnswer& answer);
[[nodiscard]] Result<ScipScan> parse_scan(const ScipAnswer& answer);
[[nodiscard]] ScipAnswer answer_of(const ScipScan& scan, std::string_view command);
[[nodiscard]] ScipParameters parse_parameters(const ScipAnswer& answer);
[[nodiscard]] ScipAnswer answer_of(const ScipParameters& parameters);

/// Hokuyo scanners by SCIP 2.2 over TCP, port 10940. Asks for parameters (PP), then for ranges
/// with strengths (ME), without (MD) where the sensor has none.
[[nodiscard]] std::unique_ptr<Driver> make_scip_driver(const DriverOptions& options);
/// Plays a UTM-30LX.
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_scip_simulator();

}  // namespace scanfuse::drivers::hokuyo
