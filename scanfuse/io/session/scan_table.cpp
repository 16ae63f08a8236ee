#include "scanfuse/io/session/scan_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {
namespace {

constexpr double kNoRange = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostBeams = 1'000'000;

/// A row as it stands in the file.
struct RawBeam {
  double angle = 0;
  double range = 0;  ///< NaN where the cell is empty or "nan"
  double intensity = kNoRange;
};

/// "nan", "inf" and an empty cell are no range rather than a bad row.
std::optional<double> range_cell(std::string_view text) {
  if (const auto number = parse_number(text)) return number;
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  if (small.starts_with('-') || small.starts_with('+')) small.erase(0, 1);
  if (small.empty() || small == "nan" || small == "inf" || small == "infinity") return kNoRange;
  return std::nullopt;
}

bool is_code(double range, const LidarConventions& lidar) {
  return std::isnan(range) || range < 0 ||
         std::ranges::find(lidar.invalid_ranges, range) != lidar.invalid_ranges.end();
}

bool in_reach(double range_m, const LidarConventions& lidar) {
  return range_m >= lidar.min_range_m && range_m <= lidar.max_range_m;
}

/// An error where another unit than the declared one fits.
Result<void> check_units(const std::vector<RawBeam>& beams, const std::string& name,
                         const LidarConventions& lidar) {
  double largest = 0;
  std::vector<double> ranges;
  for (const RawBeam& beam : beams) {
    largest = std::max(largest, std::abs(beam.angle));
    if (!is_code(beam.range, lidar)) ranges.push_back(beam.range);
  }
  if (largest * lidar.angle_unit_rad > 4 * kPi) {
    return fail(Error::Code::kOutOfRange,
                "{}: an angle of {:g} is more than two turns in the declared unit; {}", name,
                largest,
                lidar.angle_unit_rad == 1 ? "declare [lidar] angle_unit = \"deg\""
                                          : "check the column and [lidar] angle_unit");
  }
  if (ranges.empty()) {
    return fail(Error::Code::kMalformed,
                "{}: no valid range: all are invalid codes; check [lidar] invalid_ranges", name);
  }
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
  std::ranges::nth_element(ranges, middle);
  if (in_reach(*middle * lidar.range_unit_m, lidar)) return {};
  for (const auto& [unit, metres] :
       {std::pair{"m", 1.0}, {"mm", 1e-3}, {"0.1mm", 1e-4}, {"cm", 1e-2}}) {
    if (*middle * metres < 0.05 || *middle * metres > 50 || !in_reach(*middle * metres, lidar)) {
      continue;
    }
    return fail(Error::Code::kOutOfRange,
                "{}: most ranges are about {:g}, which is out of reach ({:g} to {:g} m) in the "
                "declared unit; declare [lidar] range_unit = \"{}\"",
                name, *middle, lidar.min_range_m, lidar.max_range_m, unit);
  }
  return fail(Error::Code::kOutOfRange,
              "{}: most ranges are about {:g}, out of reach ({:g} to {:g} m); check [lidar] "
              "range_unit, min_range_m and max_range_m",
              name, *middle, lidar.min_range_m, lidar.max_range_m);
}

/// Ascending angles; notes a file whose rows were in no order.
void sort_scan(std::vector<BeamReturn>& scan, const std::string& name, Diagnostics& diagnostics) {
  const auto by_angle = [](const BeamReturn& a, const BeamReturn& b) {
    return a.angle_rad < b.angle_rad;
  };
  if (std::ranges::is_sorted(scan, by_angle)) return;
  std::ranges::reverse(scan);
  if (std::ranges::is_sorted(scan, by_angle)) return;
  std::ranges::reverse(scan);
  std::ranges::stable_sort(scan, by_angle);
  diagnostics.note("beams not in order of angle, sorted", name);
}

Result<std::vector<BeamReturn>> understood(const std::vector<RawBeam>& beams,
                                           const std::string& name, const LidarConventions& lidar,
                                           Diagnostics& diagnostics) {
  if (auto fine = check_units(beams, name, lidar); !fine) return tl::unexpected(fine.error());
  std::vector<BeamReturn> scan;
  scan.reserve(beams.size());
  for (const RawBeam& beam : beams) {
    const double turn = beam.angle * lidar.angle_unit_rad;
    const double range_m = beam.range * lidar.range_unit_m;
    const bool valid = !is_code(beam.range, lidar) && in_reach(range_m, lidar);
    scan.push_back({(lidar.clockwise ? -turn : turn) + lidar.zero_rad, valid ? range_m : kNoRange,
                    beam.intensity});
  }
  sort_scan(scan, name, diagnostics);
  return scan;
}

/// Reads rows; `position` is column 0 where the table has one.
Result<std::map<int, std::vector<RawBeam>>> read_rows(LineReader lines, bool positions,
                                                      Diagnostics& diagnostics) {
  CsvColumns columns{"scans", {"angle", "range"}, {"intensity"}};
  if (positions) columns.required.insert(columns.required.begin(), "position");
  auto table = CsvTable::open(std::move(lines), columns, diagnostics);
  if (!table) return tl::unexpected(table.error());
  const std::size_t first = positions ? 1 : 0;
  std::map<int, std::vector<RawBeam>> scans;
  std::size_t beams = 0;
  while (table->next_row(diagnostics)) {
    const auto position = positions ? table->whole(0) : 0;
    if (position < 0 || position > 1'000'000) table->reject(0, "no position");
    RawBeam beam;
    beam.angle = table->metres(first);
    const auto range = range_cell(table->text(first + 1));
    if (!range) table->reject(first + 1, "no number");
    beam.range = range.value_or(kNoRange);
    beam.intensity = table->number(first + 2, kNoRange);
    if (!table->row_is_good(diagnostics)) continue;
    if (++beams > kMostBeams * 100) {
      return fail(Error::Code::kUnsupported, "{}: too many beams", table->where());
    }
    scans[static_cast<int>(position)].push_back(beam);
  }
  if (scans.empty()) return table->nothing_found("scans");
  return scans;
}

Result<std::vector<BeamReturn>> one_scan(LineReader lines, const LidarConventions& lidar,
                                         Diagnostics& diagnostics) {
  const std::string name = lines.name();
  const auto scans = read_rows(std::move(lines), false, diagnostics);
  if (!scans) return tl::unexpected(scans.error());
  return understood(scans->begin()->second, name, lidar, diagnostics);
}

/// A CSV whose header names a position, an angle and a range.
bool is_position_table(LineReader& lines, Diagnostics& diagnostics) {
  std::vector<std::string> scratch;
  std::vector<std::string_view> fields;
  split_csv(lines.peek_content(diagnostics), scratch, fields);
  const auto has = [&](std::string_view name) {
    return std::ranges::find(fields, name) != fields.end();
  };
  return has("position") && has("angle") && has("range");
}

std::vector<BeamReturn> beams_of(const Scan& scan) {
  std::vector<BeamReturn> beams;
  for (const Return& r : scan.returns) {
    beams.push_back({std::atan2(r.y_m, r.x_m), std::hypot(r.x_m, r.y_m), r.intensity});
  }
  std::ranges::stable_sort(beams, {}, &BeamReturn::angle_rad);
  return beams;
}

Result<std::map<int, std::vector<BeamReturn>>> scans_of_recording(const std::filesystem::path& path,
                                                                  Diagnostics& diagnostics) {
  auto reader = open_recording(path);
  if (!reader) return tl::unexpected(reader.error());
  std::map<int, std::vector<BeamReturn>> scans;
  while (true) {
    auto event = (*reader)->next();
    if (!event) return tl::unexpected(event.error());
    if (!*event) break;
    if (const Scan* scan = std::get_if<Scan>(&(*event)->payload)) {
      scans.emplace(static_cast<int>(scans.size()), beams_of(*scan));
    }
  }
  diagnostics.merge((*reader)->diagnostics());
  if (!scans.empty()) return scans;
  return fail(Error::Code::kMalformed, "{}: holds no scans", path.string());
}

}  // namespace

Result<std::vector<BeamReturn>> read_scan_table(const std::filesystem::path& path,
                                                const LidarConventions& lidar,
                                                Diagnostics& diagnostics) {
  auto lines = LineReader::open(path);
  if (!lines) return tl::unexpected(lines.error());
  return one_scan(std::move(*lines), lidar, diagnostics);
}

Result<std::vector<BeamReturn>> parse_scan_table(const std::string& text, const std::string& name,
                                                 const LidarConventions& lidar,
                                                 Diagnostics& diagnostics) {
  return one_scan(LineReader(name, open_memory(name, text)), lidar, diagnostics);
}

Result<std::map<int, std::vector<BeamReturn>>> read_scan_recording(
    const std::filesystem::path& path, const LidarConventions& lidar, Diagnostics& diagnostics) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return scans_of_recording(path, diagnostics);
  auto lines = LineReader::open(path);
  if (!lines) return tl::unexpected(lines.error());
  if (!is_position_table(*lines, diagnostics)) return scans_of_recording(path, diagnostics);
  const auto rows = read_rows(std::move(*lines), true, diagnostics);
  if (!rows) return tl::unexpected(rows.error());
  std::map<int, std::vector<BeamReturn>> scans;
  for (const auto& [position, beams] : *rows) {
    auto scan = understood(beams, fmt::format("{} (position {})", path.string(), position), lidar,
                           diagnostics);
    if (!scan) return tl::unexpected(scan.error());
    scans.emplace(position, std::move(*scan));
  }
  return scans;
}

std::string scan_table_text(const std::vector<BeamReturn>& scan, const LidarConventions& lidar) {
  const bool intensity =
      std::ranges::any_of(scan, [](const auto& beam) { return std::isfinite(beam.intensity); });
  std::string text = intensity ? "angle,range,intensity\n" : "angle,range\n";
  const double code = lidar.invalid_ranges.empty() ? 0 : lidar.invalid_ranges.front();
  for (const BeamReturn& beam : scan) {
    const double turn = beam.angle_rad - lidar.zero_rad;
    const double angle = (lidar.clockwise ? -turn : turn) / lidar.angle_unit_rad;
    const double range = std::isfinite(beam.range_m) ? beam.range_m / lidar.range_unit_m : code;
    // A billionth of a unit: far below any lidar, and short to read.
    text += fmt::format("{},{}", print_number(std::round(angle * 1e9) / 1e9),
                        print_number(std::round(range * 1e9) / 1e9));
    if (intensity) text += "," + print_number(beam.intensity);
    text += "\n";
  }
  return text;
}

}  // namespace scanfuse::io
