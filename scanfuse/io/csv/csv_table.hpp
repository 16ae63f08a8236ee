#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {

/// The columns a table is asked for. The rows' cells are addressed by place in `required` followed
/// by `optional`.
struct CsvColumns {
  std::string_view table;  ///< for messages: "points", "truth"
  std::vector<std::string_view> required;
  std::vector<std::string_view> optional;
};

/// Splits one line at its commas. Blanks around a field are dropped; a field in double quotes may
/// hold commas and doubled quotes. `scratch` holds what had to be unquoted.
void split_csv(std::string_view line, std::vector<std::string>& scratch,
               std::vector<std::string_view>& fields);

/// Rows of a table in text whose columns are found by name, in any order: CSV, or JSON lines (one
/// object a line) where the first character is a brace. Blank lines and lines that start with # are
/// passed over. A cell that does not hold what it should makes its row bad: the row is to be
/// dropped, and `row_is_good` counts it.
class CsvTable {
 public:
  /// Reads the header. A missing required column is an error that names it, an unknown column is
  /// noted.
  [[nodiscard]] static Result<CsvTable> open(LineReader lines, const CsvColumns& columns,
                                             Diagnostics& diagnostics);

  /// Moves to the next row; false at the end.
  [[nodiscard]] bool next_row(Diagnostics& diagnostics);

  [[nodiscard]] bool has(std::size_t column) const { return places_[column] >= 0; }
  [[nodiscard]] bool empty(std::size_t column) const { return cell(column).empty(); }
  [[nodiscard]] std::string_view text(std::size_t column) const { return cell(column); }
  /// The cells as numbers; an absent or empty optional cell gives `fallback`.
  [[nodiscard]] double number(std::size_t column, double fallback = 0);
  /// A number of at most 1e9 in size: a length or a place in metres.
  [[nodiscard]] double metres(std::size_t column, double fallback = 0);
  [[nodiscard]] std::int64_t whole(std::size_t column, std::int64_t fallback = 0);
  [[nodiscard]] Time time(std::size_t column);
  /// Says that the row is bad for another reason.
  void reject(std::size_t column, std::string_view why);

  /// False where a cell of this row could not be read; counted with the line.
  [[nodiscard]] bool row_is_good(Diagnostics& diagnostics);

  [[nodiscard]] std::string where() const { return lines_.where(); }
  [[nodiscard]] const std::string& name() const { return lines_.name(); }
  [[nodiscard]] std::int64_t good_rows() const { return good_rows_; }
  [[nodiscard]] const std::string& first_fault() const { return first_fault_; }
  /// The error of a table without any good row.
  [[nodiscard]] tl::unexpected<Error> nothing_found(std::string_view table) const;

 private:
  explicit CsvTable(LineReader lines) : lines_(std::move(lines)) {}
  [[nodiscard]] Result<void> read_header(const CsvColumns& columns, Diagnostics& diagnostics);
  [[nodiscard]] std::string_view cell(std::size_t column) const;
  [[nodiscard]] bool split_row(std::string_view line);
  void note_unknown(const std::vector<std::string_view>& wanted, Diagnostics& diagnostics) const;

  LineReader lines_;
  bool json_ = false;
  bool pending_ = false;  ///< the first JSON line is already split
  std::size_t required_ = 0;
  std::vector<std::string> names_;      ///< of all asked columns
  std::vector<std::ptrdiff_t> places_;  ///< of each asked column in the row, -1: absent
  std::vector<std::string> scratch_;
  std::vector<std::string_view> fields_;
  std::string fault_;  ///< of this row
  std::string first_fault_;
  std::int64_t good_rows_ = 0;
};

}  // namespace scanfuse::io
