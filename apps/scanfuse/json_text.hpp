#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

namespace scanfuse::app {

/// Text as a JSON string, quotes included. Bytes that are no UTF-8 are the caller's matter: file
/// and topic names are passed as they are.
inline std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// A number, or null where it is not finite.
inline std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
}

}  // namespace scanfuse::app
