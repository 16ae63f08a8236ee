#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scanfuse/core/time.hpp"

namespace scanfuse::io {

/// Coordinates beyond this are damage, not measurements; squares of them stay finite in float.
inline constexpr double kFarthestCoordinate_m = 1e9;

[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A finite number in decimal text, whatever the locale; nothing for "nan", "inf", "1.5 m" or "".
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
[[nodiscard]] std::optional<float> parse_float(std::string_view text);
/// A whole number; "12.0" counts as one.
[[nodiscard]] std::optional<std::int64_t> parse_whole(std::string_view text);

/// Seconds in decimal text to the nearest nanosecond, exact: "1575811624.359102488" does not pass
/// through a double. Takes an exponent. Nothing outside +-4.6e9 s (so that differences fit).
[[nodiscard]] std::optional<Duration> parse_seconds(std::string_view text);

/// Seconds with nine digits after the point, exact.
[[nodiscard]] std::string print_seconds(Time time);
/// The shortest text that reads back as the same number; nothing for NaN and infinities.
[[nodiscard]] std::string print_number(double value);

}  // namespace scanfuse::io
