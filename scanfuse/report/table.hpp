#pragma once

#include <string>
#include <vector>

namespace scanfuse::report {

struct ReportTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string note = {};  ///< under the table; may be empty
};

/// A card of a page; all texts are escaped.
[[nodiscard]] std::string html_table(const ReportTable& table);

}  // namespace scanfuse::report
