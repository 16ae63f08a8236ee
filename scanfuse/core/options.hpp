#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse {

/// One option of a plain struct, declared once: name, member, range, doc. From a struct's
/// `static constexpr auto fields()` (a tuple of these) come the TOML reader and writer,
/// `--set section.name=value`, the reference page and the bindings.
template <class Owner, class T>
struct Field {
  std::string_view name;
  T Owner::* member;
  T low{};
  T high{};
  std::string_view doc;

  constexpr Field(std::string_view n, T Owner::* m, std::type_identity_t<T> l,
                  std::type_identity_t<T> h, std::string_view d)
    requires std::is_arithmetic_v<T>
      : name(n), member(m), low(l), high(h), doc(d) {}
  constexpr Field(std::string_view n, T Owner::* m, std::string_view d)
      : name(n), member(m), doc(d) {}
};

/// An enumeration becomes an option by a function found beside it:
/// `constexpr auto choices(Method) { return std::array{std::pair{"pag", Method::kPag}, ...}; }`
template <class T>
concept Choice = std::is_enum_v<T> && requires(T value) { choices(value); };

/// One option as text, whatever its type: what printers, parsers and forms need.
struct OptionView {
  std::string section;
  std::string name;
  std::string value;     ///< as `--set` would take it
  std::string fallback;  ///< the default, in the same form
  std::string range;     ///< "0.01 .. 10", "pag | euclidean", "true | false", or empty
  std::string doc;
  bool quoted = false;  ///< text or a choice: TOML puts it in quotes
};

namespace detail {

std::string print(double value);
std::string print(int value);
std::string print(bool value);
std::string print(const std::string& value);
Result<double> parse_double(std::string_view text);
Result<int> parse_int(std::string_view text);
Result<bool> parse_bool(std::string_view text);

template <Choice T>
std::string print(T value) {
  for (const auto& [name, choice] : choices(value)) {
    if (choice == value) return name;
  }
  return "?";
}

template <class T>
Result<T> parse(std::string_view text) {
  if constexpr (std::is_same_v<T, double>) {
    return parse_double(text);
  } else if constexpr (std::is_same_v<T, int>) {
    return parse_int(text);
  } else if constexpr (std::is_same_v<T, bool>) {
    return parse_bool(text);
  } else if constexpr (Choice<T>) {
    std::string known;
    for (const auto& [name, choice] : choices(T{})) {
      if (text == name) return choice;
      known += known.empty() ? name : std::string(", ") + name;
    }
    return fail(Error::Code::kMalformed, "'{}' is none of: {}", text, known);
  } else {
    return std::string(text);
  }
}

template <class T>
std::string range_text(const T& low, const T& high) {
  if constexpr (std::is_same_v<T, bool>) {
    return "true | false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return print(low) + " .. " + print(high);
  } else if constexpr (Choice<T>) {
    std::string text;
    for (const auto& [name, choice] : choices(T{})) {
      text += text.empty() ? name : std::string(" | ") + name;
    }
    return text;
  } else {
    return "";
  }
}

}  // namespace detail

/// "section.option=value", taken apart; its texts are views of it.
struct Setting {
  std::string_view section;
  std::string_view name;
  std::string_view value;
};
/// Empty for text of another form.
[[nodiscard]] std::optional<Setting> split_setting(std::string_view text);

/// The candidate closest to `name` by edit distance; empty where there is none.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// Every option of one struct as text.
template <class Options>
std::vector<OptionView> view_options(std::string_view section, const Options& options) {
  std::vector<OptionView> views;
  const Options defaults{};
  std::apply(
      [&](const auto&... field) {
        (views.push_back({std::string(section), std::string(field.name),
                          detail::print(options.*field.member),
                          detail::print(defaults.*field.member),
                          detail::range_text(field.low, field.high), std::string(field.doc),
                          !std::is_arithmetic_v<std::decay_t<decltype(options.*field.member)>>}),
         ...);
      },
      Options::fields());
  return views;
}

/// Sets one option from text. Unknown name: an error naming the nearest known one. Out of range: an
/// error naming the range.
template <class Options>
Result<void> set_option(Options& options, std::string_view name, std::string_view text) {
  Result<void> outcome = fail(Error::Code::kNotFound, "");
  bool found = false;
  std::vector<std::string> names;
  const auto try_field = [&](const auto& field) {
    names.emplace_back(field.name);
    if (field.name != name) return;
    found = true;
    using T = std::decay_t<decltype(options.*field.member)>;
    auto value = detail::parse<T>(text);
    if (!value) {
      outcome = fail(value.error().code, "{}: {}", name, value.error().message);
      return;
    }
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      if (!(*value >= field.low && *value <= field.high)) {
        outcome = fail(Error::Code::kOutOfRange, "{} = {} is outside {}", name, text,
                       detail::range_text(field.low, field.high));
        return;
      }
    }
    options.*field.member = *value;
    outcome = {};
  };
  std::apply([&](const auto&... field) { (try_field(field), ...); }, Options::fields());
  if (!found) {
    return fail(Error::Code::kNotFound, "unknown option '{}'; did you mean '{}'?", name,
                nearest_name(name, names));
  }
  return outcome;
}

}  // namespace scanfuse
