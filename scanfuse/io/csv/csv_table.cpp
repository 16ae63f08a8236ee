#include "scanfuse/io/csv/csv_table.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/io/csv/json_row.hpp"

namespace scanfuse::io {
namespace {

bool is_comment_or_blank(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#';
}

/// Unquotes the field that starts at `line[i]`; leaves i at the comma behind it or at the end.
std::string unquote(std::string_view line, std::size_t& i) {
  std::string field;
  for (++i; i < line.size(); ++i) {
    if (line[i] != '"') {
      field += line[i];
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      field += line[++i];
    } else {
      break;
    }
  }
  i = std::min(line.find(',', i), line.size());
  return field;
}

}  // namespace

void split_csv(std::string_view line, std::vector<std::string>& scratch,
               std::vector<std::string_view>& fields) {
  fields.clear();
  scratch.clear();
  if (line.find('"') == line.npos) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      fields.push_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    return;
  }
  for (std::size_t i = 0; i <= line.size(); ++i) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
    if (i < line.size() && line[i] == '"') {
      scratch.push_back(unquote(line, i));
    } else {
      const std::size_t end = std::min(line.find(',', i), line.size());
      scratch.emplace_back(trimmed(line.substr(i, end - i)));
      i = end;
    }
  }
  fields.assign(scratch.begin(), scratch.end());
}

Result<CsvTable> CsvTable::open(LineReader lines, const CsvColumns& columns,
                                Diagnostics& diagnostics) {
  CsvTable table(std::move(lines));
  if (auto read = table.read_header(columns, diagnostics); !read) {
    return tl::unexpected(read.error());
  }
  return table;
}

Result<void> CsvTable::read_header(const CsvColumns& columns, Diagnostics& diagnostics) {
  std::vector<std::string_view> wanted = columns.required;
  wanted.insert(wanted.end(), columns.optional.begin(), columns.optional.end());
  names_.assign(wanted.begin(), wanted.end());
  required_ = columns.required.size();
  places_.assign(wanted.size(), -1);

  std::optional<std::string_view> line;
  do {
    line = lines_.next(diagnostics);
  } while (line && is_comment_or_blank(*line));
  if (!line) {
    if (lines_.broken()) return tl::unexpected(*lines_.broken());
    return fail(Error::Code::kMalformed, "{}: empty: no header line with the columns of {}", name(),
                columns.table);
  }
  if (trimmed(*line).starts_with('{')) {
    json_ = pending_ = true;
    for (std::size_t k = 0; k < places_.size(); ++k) places_[k] = static_cast<std::ptrdiff_t>(k);
    if (!split_row(*line)) fault_ = "no JSON object";
    return {};
  }
  split_csv(*line, scratch_, fields_);
  std::string missing;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto found = std::find(fields_.begin(), fields_.end(), wanted[k]);
    if (found != fields_.end()) {
      places_[k] = found - fields_.begin();
    } else if (k < columns.required.size()) {
      missing += (missing.empty() ? "" : ", ") + names_[k];
    }
  }
  if (!missing.empty()) {
    return fail(Error::Code::kMalformed, "{}: a table of {} needs the column{} {}", where(),
                columns.table, missing.find(',') == missing.npos ? "" : "s", missing);
  }
  note_unknown(wanted, diagnostics);
  return {};
}

void CsvTable::note_unknown(const std::vector<std::string_view>& wanted,
                            Diagnostics& diagnostics) const {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if (std::find(wanted.begin(), wanted.end(), fields_[k]) == wanted.end()) {
      diagnostics.note("unknown column ignored", fmt::format("{}: '{}'", where(), fields_[k]));
    } else if (std::find(fields_.begin(), fields_.begin() + static_cast<std::ptrdiff_t>(k),
                         fields_[k]) != fields_.begin() + static_cast<std::ptrdiff_t>(k)) {
      diagnostics.note("column named twice, the first counts",
                       fmt::format("{}: '{}'", where(), fields_[k]));
    }
  }
}

bool CsvTable::split_row(std::string_view line) {
  if (!json_) {
    split_csv(line, scratch_, fields_);
    return true;
  }
  const bool whole = split_json(line, names_, scratch_);
  fields_.assign(scratch_.begin(), scratch_.end());
  return whole;
}

bool CsvTable::next_row(Diagnostics& diagnostics) {
  if (pending_) {
    pending_ = false;
    return true;
  }
  fault_.clear();
  for (;;) {
    const auto line = lines_.next(diagnostics);
    if (!line) return false;
    if (is_comment_or_blank(*line)) continue;
    if (!split_row(*line)) fault_ = "no JSON object";
    return true;
  }
}

std::string_view CsvTable::cell(std::size_t column) const {
  const auto place = places_[column];
  if (place < 0 || place >= std::ssize(fields_)) return {};
  return fields_[static_cast<std::size_t>(place)];
}

void CsvTable::reject(std::size_t column, std::string_view why) {
  if (fault_.empty()) fault_ = fmt::format("{} '{:.40}' {}", names_[column], cell(column), why);
}

double CsvTable::number(std::size_t column, double fallback) {
  if (empty(column) && column >= required_) return fallback;
  const auto value = parse_number(cell(column));
  if (!value) reject(column, "is not a number");
  return value.value_or(fallback);
}

double CsvTable::metres(std::size_t column, double fallback) {
  const double value = number(column, fallback);
  if (std::abs(value) > kFarthestCoordinate_m) reject(column, "is out of range");
  return value;
}

std::int64_t CsvTable::whole(std::size_t column, std::int64_t fallback) {
  if (empty(column) && column >= required_) return fallback;
  const auto value = parse_whole(cell(column));
  if (!value) reject(column, "is not a whole number");
  return value.value_or(fallback);
}

Time CsvTable::time(std::size_t column) {
  const auto value = parse_seconds(cell(column));
  if (!value) reject(column, "is not a time in seconds");
  return Time{value.value_or(Duration{0})};
}

bool CsvTable::row_is_good(Diagnostics& diagnostics) {
  if (fault_.empty()) {
    ++good_rows_;
    return true;
  }
  const std::string place = fmt::format("{}: {}", where(), fault_);
  diagnostics.damage("bad row skipped", place);
  if (first_fault_.empty()) first_fault_ = place;
  return false;
}

tl::unexpected<Error> CsvTable::nothing_found(std::string_view table) const {
  if (lines_.broken()) return tl::unexpected(*lines_.broken());
  if (first_fault_.empty()) {
    return fail(Error::Code::kMalformed, "{}: no row of {} below the header", name(), table);
  }
  return fail(Error::Code::kMalformed, "{}: no good row of {}; the first: {}", name(), table,
              first_fault_);
}

}  // namespace scanfuse::io
