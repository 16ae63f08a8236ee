#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {

struct ReportTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// One HTML page of tables and charts that needs no other file; all texts are escaped.
[[nodiscard]] std::string figures_page(const std::string& title, const std::string& note,
                                       const std::vector<ReportTable>& tables,
                                       const std::vector<Chart>& charts);

}  // namespace scanfuse::report
