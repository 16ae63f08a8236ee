#include "scanfuse/report/opening.hpp"

#include <fmt/format.h>

#include "scanfuse/report/assets.hpp"

namespace scanfuse::report {

std::string html_opening(std::string_view title, std::string_view heading, std::string_view note) {
  std::string html = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  html += "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">";
  html += fmt::format("<title>{}</title>\n<style>\n{}</style></head>\n", escape_html(title),
                      page_style());
  html += fmt::format("<body><header><h1>{}</h1><p>{}</p></header>\n<main>\n", escape_html(heading),
                      escape_html(note));
  return html;
}

std::string html_charts(const std::vector<Chart>& charts) {
  std::string html = "<section class=\"card\"><div class=\"charts\">\n";
  for (const auto& chart : charts) html += line_chart(chart);
  return html + "</div></section>\n";
}

}  // namespace scanfuse::report
