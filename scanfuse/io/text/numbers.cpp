#include "scanfuse/io/text/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace scanfuse::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

template <class T>
std::optional<T> parse_finite(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range && text.find_first_of("eE") != text.npos &&
      text[text.find_first_of("eE") + 1] == '-') {
    return T{0};  // too small to tell from zero
  }
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A decimal number taken apart: digits without leading zeros, the point after `point` of them.
struct Decimal {
  bool negative = false;
  std::string digits;
  int point = 0;
};

std::optional<Decimal> take_apart(std::string_view text) {
  Decimal number;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    number.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  bool any = false, after_point = false;
  std::size_t i = 0;
  for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !after_point)); ++i) {
    if (text[i] == '.') {
      after_point = true;
      continue;
    }
    any = true;
    if (number.digits.empty() && text[i] == '0') {
      number.point -= after_point ? 1 : 0;
    } else if (number.digits.size() < 40) {
      number.digits += text[i];
      number.point += after_point ? 0 : 1;
    } else {
      number.point += after_point ? 0 : 1;
    }
  }
  if (!any) return std::nullopt;
  if (i < text.size()) {
    if (text[i] != 'e' && text[i] != 'E') return std::nullopt;
    const auto exponent = parse_whole(text.substr(i + 1));
    if (!exponent || std::abs(*exponent) > 10000) return std::nullopt;
    number.point += static_cast<int>(*exponent);
  }
  return number;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parse_number(std::string_view text) { return parse_finite<double>(text); }
std::optional<float> parse_float(std::string_view text) { return parse_finite<float>(text); }

std::optional<std::int64_t> parse_whole(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  const auto number = parse_number(text);
  if (!number || std::abs(*number) > 9e15 || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<Duration> parse_seconds(std::string_view text) {
  const auto number = take_apart(trimmed(text));
  if (!number) return std::nullopt;
  const int whole_digits = number->point + 9;  // in nanoseconds
  if (number->digits.empty() || whole_digits < 0) return Duration{0};
  if (whole_digits > 19) return std::nullopt;
  std::uint64_t nanos = 0;
  for (int i = 0; i < whole_digits; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const int digit = place < number->digits.size() ? number->digits[place] - '0' : 0;
    nanos = nanos * 10 + static_cast<std::uint64_t>(digit);
  }
  const auto next = static_cast<std::size_t>(whole_digits);
  if (next < number->digits.size() && number->digits[next] >= '5') ++nanos;
  if (nanos > 4'600'000'000'000'000'000ULL) return std::nullopt;
  const auto signed_nanos = static_cast<std::int64_t>(nanos);
  return Duration{number->negative ? -signed_nanos : signed_nanos};
}

std::string print_seconds(Time time) {
  const std::int64_t nanos = to_nanos(time);
  const auto size =
      nanos < 0 ? ~static_cast<std::uint64_t>(nanos) + 1 : static_cast<std::uint64_t>(nanos);
  return fmt::format("{}{}.{:09}", nanos < 0 ? "-" : "", size / 1'000'000'000,
                     size % 1'000'000'000);
}

std::string print_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string{};
}

}  // namespace scanfuse::io
