#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scanfuse/report/svg_plot.hpp"
#include "scanfuse/report/table.hpp"

namespace scanfuse::report {

/// One HTML page of tables and charts that needs no other file; all texts are escaped.
[[nodiscard]] std::string figures_page(const std::string& title, const std::string& note,
                                       const std::vector<ReportTable>& tables,
                                       const std::vector<Chart>& charts);

}  // namespace scanfuse::report
