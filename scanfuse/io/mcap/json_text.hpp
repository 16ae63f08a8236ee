#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "scanfuse/core/time.hpp"

namespace scanfuse::io::mcap {

/// Writes JSON text front to back; keys stay in the order they are given, so the bytes are the same
/// every time. Numbers are the shortest that read back the same; those that are not finite become
/// null, as JSON has no NaN.
class JsonText {
 public:
  JsonText& begin_object() { return open('{'); }
  JsonText& end_object() { return close('}'); }
  JsonText& begin_array() { return open('['); }
  JsonText& end_array() { return close(']'); }
  JsonText& key(std::string_view name);
  JsonText& value(double number);
  JsonText& value(std::int64_t number);
  JsonText& value(bool truth);
  JsonText& value(std::string_view text);
  JsonText& null();

  template <class T>
  JsonText& field(std::string_view name, const T& member) {
    key(name);
    if constexpr (std::same_as<T, bool>) {
      return value(member);
    } else if constexpr (std::integral<T>) {
      return value(static_cast<std::int64_t>(member));
    } else if constexpr (std::floating_point<T>) {
      return value(static_cast<double>(member));
    } else {
      return value(std::string_view(member));
    }
  }
  /// {"sec":..,"nsec":..} as Foxglove's schemas write instants; sec counts down before 1970.
  JsonText& stamp(std::string_view name, Time time);
  /// {"x":..,"y":..,"z":..}
  JsonText& vector(std::string_view name, double x, double y, double z);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  void separate();

  std::string text_;
  bool first_ = true;
};

}  // namespace scanfuse::io::mcap
