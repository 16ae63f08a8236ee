#include "scanfuse/drivers/hokuyo/scip.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace scanfuse::drivers::hokuyo {
namespace {

constexpr std::size_t kLongest = std::size_t{1} << 17;
constexpr std::size_t kLine = 64;  // characters of data in a full line
constexpr int kMostSteps = 100'000;

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Parameters set their checksum behind a semicolon, which does not count; in data it is a digit.
std::string_view without_checksum(std::string_view command, std::string_view line) {
  const bool is_told = command == "PP" || command == "VV" || command == "II";
  line.remove_suffix(1);
  if (is_told && line.ends_with(';')) line.remove_suffix(1);
  return line;
}

/// What is behind "MD" or "ME".
struct ScanCommand {
  bool has_strengths = false;
  int first = 0, last = 0, cluster = 1;
};

std::optional<ScanCommand> parse_command(std::string_view command) {
  if (command.size() < 12 || !(command.starts_with("MD") || command.starts_with("ME"))) {
    return std::nullopt;
  }
  const auto first = number(command.substr(2, 4)), last = number(command.substr(6, 4)),
             cluster = number(command.substr(10, 2));
  if (!first || !last || !cluster || *last < *first) return std::nullopt;
  return ScanCommand{command[1] == 'E', *first, *last, std::max(1, *cluster)};
}

}  // namespace

std::optional<std::uint32_t> decode_characters(std::string_view text) {
  std::uint32_t value = 0;
  for (const char c : text) {
    if (c < 0x30 || c > 0x6F) return std::nullopt;
    value = value << 6 | static_cast<std::uint32_t>(c - 0x30);
  }
  return value;
}

std::string encode_characters(std::uint32_t value, int characters) {
  std::string text(static_cast<std::size_t>(characters), '0');
  for (auto it = text.rbegin(); it != text.rend(); ++it, value >>= 6) {
    *it = static_cast<char>(0x30 + (value & 0x3F));
  }
  return text;
}

char checksum(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum += static_cast<unsigned char>(c);
  return static_cast<char>(0x30 + (sum & 0x3F));
}

Cut cut_scip(ByteView bytes) {
  const std::string_view text = text_of(bytes);
  if (text[0] == '\n') return {1, 0};
  const auto end = text.find("\n\n");
  if (end != text.npos) return {0, end + 2};
  return text.size() > kLongest ? Cut{text.size() - 1, 0} : Cut{};
}

Result<ScipAnswer> parse_answer(ByteView bytes) {
  const auto lines = split_lines(text_of(bytes).substr(0, bytes.size() - 1));
  if (lines.size() < 2 || lines[1].size() < 2) {
    return fail(Error::Code::kMalformed, "an answer without a status");
  }
  ScipAnswer answer{std::string(lines[0]), std::string(lines[1].substr(0, 2)), {}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    const std::string_view line = without_checksum(lines[0], lines[i]);
    // Of the status only the older protocol leaves out the checksum.
    if (checksum(line) != lines[i].back() && !(i == 1 && lines[i].size() == 2)) {
      return fail(Error::Code::kMalformed, "line {} of an answer to {}: wrong checksum", i + 1,
                  lines[0].substr(0, 2));
    }
    if (i > 1) answer.lines.emplace_back(line);
  }
  return answer;
}

Bytes encode_answer(const ScipAnswer& answer) {
  const bool parameters = answer.command.starts_with("PP");
  std::string text = answer.command + "\n" + answer.status + checksum(answer.status) + "\n";
  for (const std::string& line : answer.lines) {
    text += line + (parameters ? ";" : "") + checksum(line) + "\n";
  }
  text += "\n";
  const ByteView bytes = view_of(text);
  return {bytes.begin(), bytes.end()};
}

bool is_scan(const ScipAnswer& answer) {
  return answer.status == "99" && parse_command(answer.command).has_value();
}

Result<ScipScan> parse_scan(const ScipAnswer& answer) {
  const auto command = parse_command(answer.command);
  if (!command || answer.lines.empty()) {
    return fail(Error::Code::kMalformed, "an answer to {} without a scan", answer.command);
  }
  ScipScan scan{command->has_strengths, command->first, command->last, command->cluster, 0, {}, {}};
  const auto time = decode_characters(answer.lines[0]);
  if (!time || answer.lines[0].size() != 4) {
    return fail(Error::Code::kMalformed, "a scan without a time");
  }
  scan.time_ms = *time;
  std::string data;
  for (std::size_t i = 1; i < answer.lines.size(); ++i) data += answer.lines[i];
  const std::size_t per_step = scan.has_strengths ? 6 : 3;
  const int steps = (scan.last_step - scan.first_step) / scan.cluster + 1;
  if (steps > kMostSteps || data.size() != per_step * static_cast<std::size_t>(steps)) {
    return fail(Error::Code::kMalformed, "{} characters for {} steps", data.size(), steps);
  }
  for (std::size_t at = 0; at < data.size(); at += per_step) {
    const auto range = decode_characters(std::string_view(data).substr(at, 3));
    if (!range) return fail(Error::Code::kMalformed, "character {} is no number", at);
    scan.ranges_mm.push_back(*range);
    if (!scan.has_strengths) continue;
    scan.strengths.push_back(
        decode_characters(std::string_view(data).substr(at + 3, 3)).value_or(0));
  }
  return scan;
}

ScipAnswer answer_of(const ScipScan& scan, std::string_view command) {
  ScipAnswer answer{std::string(command), "99", {encode_characters(scan.time_ms & 0xFFFFFF, 4)}};
  std::string data;
  for (std::size_t i = 0; i < scan.ranges_mm.size(); ++i) {
    data += encode_characters(scan.ranges_mm[i], 3);
    if (scan.has_strengths) data += encode_characters(scan.strengths[i], 3);
  }
  for (std::size_t at = 0; at < data.size(); at += kLine) {
    answer.lines.push_back(data.substr(at, kLine));
  }
  return answer;
}

ScipParameters parse_parameters(const ScipAnswer& answer) {
  ScipParameters parameters;
  const std::pair<std::string_view, int*> known[] = {
      {"DMIN:", &parameters.min_range_mm},    {"DMAX:", &parameters.max_range_mm},
      {"ARES:", &parameters.steps_per_turn},  {"AMIN:", &parameters.first_step},
      {"AMAX:", &parameters.last_step},       {"AFRT:", &parameters.front_step},
      {"SCAN:", &parameters.turns_per_minute}};
  for (const std::string& line : answer.lines) {
    for (const auto& [key, value] : known) {
      if (!line.starts_with(key)) continue;
      if (const auto n = number(std::string_view(line).substr(key.size()))) *value = *n;
    }
  }
  parameters.steps_per_turn = std::clamp(parameters.steps_per_turn, 1, kMostSteps);
  parameters.last_step = std::clamp(parameters.last_step, 0, 9999);
  parameters.first_step = std::clamp(parameters.first_step, 0, parameters.last_step);
  return parameters;
}

ScipAnswer answer_of(const ScipParameters& p) {
  return {"PP",
          "00",
          {"MODL:simulated", fmt::format("DMIN:{}", p.min_range_mm),
           fmt::format("DMAX:{}", p.max_range_mm), fmt::format("ARES:{}", p.steps_per_turn),
           fmt::format("AMIN:{}", p.first_step), fmt::format("AMAX:{}", p.last_step),
           fmt::format("AFRT:{}", p.front_step), fmt::format("SCAN:{}", p.turns_per_minute)}};
}

}  // namespace scanfuse::drivers::hokuyo
