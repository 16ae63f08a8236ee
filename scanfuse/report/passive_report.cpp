#include "scanfuse/report/passive_report.hpp"

#include <fmt/format.h>

#include "scanfuse/report/opening.hpp"

namespace scanfuse::report {
namespace {

std::string section_html(const PassiveSection& section, std::span<const PassiveSensor> sensors) {
  std::string html =
      fmt::format("<section class=\"card\"><h2>{}</h2>\n", escape_html(section.title));
  html += passive_map(section.view, sensors, ViewFrom::kAbove);
  html += passive_map(section.view, sensors, ViewFrom::kSide);
  html +=
      "<p class=\"note\">Squares: sensors. Dots: fixes, with the ellipse that holds the target "
      "with 95 %. Faint lines: lines of sight to the fix they went to, in its colour; grey: left "
      "as clutter. Rings: where targets really were. Crosses: ghosts, fixes whose bearings are "
      "not all of one target.</p></section>\n";
  for (const auto& table : section.tables) html += html_table(table);
  if (section.charts.empty()) return html;
  return html + html_charts(section.charts);
}

}  // namespace

std::string passive_page(const std::string& title, const std::string& note,
                         std::span<const PassiveSensor> sensors,
                         const std::vector<ReportTable>& tables,
                         const std::vector<PassiveSection>& sections) {
  std::string html = html_opening(title, title, note);
  for (const auto& table : tables) html += html_table(table);
  for (const auto& section : sections) html += section_html(section, sensors);
  return html + "</main></body></html>\n";
}

}  // namespace scanfuse::report
