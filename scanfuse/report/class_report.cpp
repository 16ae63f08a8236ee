#include "scanfuse/report/class_report.hpp"

#include <fmt/format.h>

#include "scanfuse/report/assets.hpp"
#include "scanfuse/report/opening.hpp"

namespace scanfuse::report {
std::string figures_page(const std::string& title, const std::string& note,
                         const std::vector<ReportTable>& tables, const std::vector<Chart>& charts) {
  std::string html = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  html += fmt::format("<title>{}</title>\n<style>\n", escape_html(title));
  html += page_style();
  html += fmt::format("</style></head>\n<body><header><h1>{}</h1><p>{}</p></header>\n<main>\n",
                      escape_html(title), escape_html(note));
  for (const auto& table : tables) html += html_table(table);
  return html + html_charts(charts) + "</main></body></html>\n";
}

}  // namespace scanfuse::report
