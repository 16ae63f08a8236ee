#include "scanfuse/report/class_report.hpp"

#include "scanfuse/report/opening.hpp"

namespace scanfuse::report {

std::string figures_page(const std::string& title, const std::string& note,
                         const std::vector<ReportTable>& tables, const std::vector<Chart>& charts) {
  std::string html = html_opening(title, title, note);
  for (const auto& table : tables) html += html_table(table);
  return html + html_charts(charts) + "</main></body></html>\n";
}

}  // namespace scanfuse::report
