#include "scanfuse/report/table.hpp"

#include <fmt/format.h>

#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {

std::string html_table(const ReportTable& table) {
  std::string html =
      fmt::format("<section class=\"card\"><h2>{}</h2><table class=\"wide\"><thead><tr>",
                  escape_html(table.title));
  for (const auto& name : table.columns) html += "<th>" + escape_html(name) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += (i == 0 ? "<th>" : "<td>") + escape_html(row[i]) + (i == 0 ? "</th>" : "</td>");
    }
    html += "</tr>\n";
  }
  html += "</tbody></table>";
  if (!table.note.empty()) html += "<p class=\"note\">" + escape_html(table.note) + "</p>";
  return html + "</section>\n";
}

}  // namespace scanfuse::report
