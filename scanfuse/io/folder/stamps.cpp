#include "scanfuse/io/folder/stamps.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/io/text/natural_order.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr Duration kDefaultPeriod = std::chrono::milliseconds(100);

/// "2011-09-26 13:02:25.964389445"
std::optional<Time> parse_date(std::string_view text) {
  if (text.size() < 19 || text[4] != '-' || text[7] != '-' || text[13] != ':' || text[16] != ':') {
    return std::nullopt;
  }
  const auto year = parse_whole(text.substr(0, 4)), month = parse_whole(text.substr(5, 2)),
             day = parse_whole(text.substr(8, 2)), hour = parse_whole(text.substr(11, 2)),
             minute = parse_whole(text.substr(14, 2));
  const auto second = parse_seconds(text.substr(17));
  if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(*year)),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok() || *year < 1900 || *year > 2100 || *second > std::chrono::seconds(61)) {
    return std::nullopt;
  }
  return Time{std::chrono::sys_days(date)} + std::chrono::hours(*hour) +
         std::chrono::minutes(*minute) + *second;
}

/// Names such as 1317384506402394000.pcd: later than 1973, so that frame numbers are none.
std::optional<Time> stamp_of_name(const std::filesystem::path& file) {
  const auto stamp = parse_stamp(file.stem().string());
  return stamp && to_nanos(*stamp) >= 100'000'000'000'000'000 ? stamp : std::nullopt;
}

bool fill_from_list(const std::filesystem::path& folder, std::vector<ScanFile>& files,
                    Diagnostics& diagnostics) {
  std::error_code ignored;
  for (const auto& place : {folder, folder.parent_path()}) {
    const auto list = place / "timestamps.txt";
    if (place != folder && folder.filename() != "data") continue;
    if (!std::filesystem::is_regular_file(list, ignored)) continue;
    const auto stamps = read_stamps(list, diagnostics);
    const bool whole = stamps.size() >= files.size() &&
                       std::all_of(stamps.begin(), stamps.begin() + std::ssize(files),
                                   [](const auto& stamp) { return stamp.has_value(); });
    if (!whole) {
      diagnostics.note("timestamps.txt does not have a stamp for each file: not used",
                       list.string());
      continue;
    }
    for (std::size_t i = 0; i < files.size(); ++i) files[i].stamp = *stamps[i];
    return true;
  }
  return false;
}

}  // namespace

std::optional<Time> parse_stamp(std::string_view text) {
  text = trimmed(text);
  if (auto date = parse_date(text)) return date;
  const bool digits_only =
      !text.empty() && text.size() <= 19 && text.find_first_not_of("0123456789") == text.npos;
  if (digits_only && text.size() >= 13) {
    const auto count = parse_whole(text);
    if (!count) return std::nullopt;
    const std::int64_t scale = text.size() >= 18   ? 1
                               : text.size() >= 16 ? 1000
                               : text.size() == 13 ? 1'000'000
                                                   : 0;
    if (scale == 0 || *count > 4'600'000'000'000'000'000 / scale) return std::nullopt;
    return time_from_nanos(*count * scale);
  }
  const auto seconds = parse_seconds(text);
  return seconds ? std::optional(Time{*seconds}) : std::nullopt;
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder,
                                            std::string_view extension) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    if (it->path().extension() == extension && it->is_regular_file(ignored)) {
      files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return files;
}

std::vector<ScanFile> stamp_files(const std::filesystem::path& folder,
                                  std::vector<std::filesystem::path> files,
                                  Diagnostics& diagnostics) {
  std::vector<ScanFile> stamped;
  stamped.reserve(files.size());
  for (auto& file : files) stamped.push_back({std::move(file), Time{}});
  if (fill_from_list(folder, stamped, diagnostics)) return stamped;
  const bool named = std::all_of(stamped.begin(), stamped.end(), [](const ScanFile& file) {
    return stamp_of_name(file.path).has_value();
  });
  if (!named) diagnostics.note("no times known: ten scans a second assumed", folder.string());
  for (std::size_t i = 0; i < stamped.size(); ++i) {
    stamped[i].stamp = named ? *stamp_of_name(stamped[i].path)
                             : Time{kDefaultPeriod * static_cast<std::int64_t>(i)};
  }
  return stamped;
}

std::vector<std::optional<Time>> read_stamps(const std::filesystem::path& file,
                                             Diagnostics& diagnostics) {
  std::vector<std::optional<Time>> stamps;
  auto lines = LineReader::open(file);
  if (!lines) return stamps;
  while (const auto line = lines->next(diagnostics)) {
    if (trimmed(*line).empty()) continue;
    stamps.push_back(parse_stamp(*line));
    if (!stamps.back()) diagnostics.damage("unreadable stamp", lines->where());
  }
  return stamps;
}

}  // namespace scanfuse::io
