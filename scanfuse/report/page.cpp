#include "scanfuse/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scanfuse/report/assets.hpp"
#include "scanfuse/report/opening.hpp"
#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string value_table(std::string_view title, const Rows& rows) {
  if (rows.empty()) return "";
  std::string html = fmt::format("<section class=\"card\"><h2>{}</h2><table>", title);
  for (const auto& [name, value] : rows) {
    html += fmt::format("<tr><th>{}</th><td>{}</td></tr>", escape_html(name), escape_html(value));
  }
  return html + "</table></section>\n";
}

Rows summary_rows(const TrackReport& report, const TrackReportHeader& header) {
  Rows rows = header.summary;
  rows.emplace_back("tracks started", fmt::format("{}", report.lives().size()));
  return rows;
}

std::string thinning_note(const TrackReport& report) {
  std::string note;
  if (report.frame_stride() > 1) {
    note +=
        fmt::format("To keep this page small it shows one frame in {}. ", report.frame_stride());
  }
  if (report.points_thinned()) note += "Returns are thinned in full frames. ";
  return note.empty() ? "" : "<p class=\"note\">" + note + "All sums are over all frames.</p>";
}

std::string charts_of(const TrackReportHeader& header) {
  if (header.charts.empty()) return "";
  std::string html = "<section class=\"card\"><div class=\"charts\">\n";
  for (const auto& chart : header.charts) html += line_chart(chart);
  return html + "</div></section>\n";
}

constexpr std::string_view kViewer = R"html(
<section class="card viewer" aria-label="Top view">
<canvas id="view" tabindex="0" aria-label="Top view of returns, tracks and truth"></canvas>
<div class="bar">
<button id="play" title="Space">Play</button>
<button id="back" title="Left arrow">&#9664;</button><button id="next" title="Right arrow">&#9654;</button>
<input id="seek" type="range" min="0" max="0" value="0" step="1" aria-label="Frame">
<output id="clock"></output>
</div>
<div class="bar">
<label>speed <select id="speed"><option value="0.25">1/4</option><option value="0.5">1/2</option>
<option value="1" selected>1</option><option value="2">2</option><option value="5">5</option>
<option value="20">20</option></select></label>
<label><input id="follow" type="checkbox" checked> follow ego</label>
<label><input id="trails" type="checkbox" checked> trails</label>
<label><input id="ellipses" type="checkbox" checked> ellipses</label>
<label><input id="truths" type="checkbox" checked> truth</label>
<label><input id="tentative" type="checkbox" checked> tentative</label>
<label><input id="clusters" type="checkbox"> clusters in colour</label>
<button id="fit" title="0">Fit</button>
<span class="legend"><span style="--c:var(--vehicle)">vehicle</span><span
style="--c:var(--pedestrian)">pedestrian</span><span style="--c:var(--cyclist)">cyclist</span><span
style="--c:var(--other)">other</span></span>
</div>
<p id="picked" class="note"></p>
<p class="keys"><kbd>Space</kbd> play <kbd>&larr;</kbd><kbd>&rarr;</kbd> step <kbd>Home</kbd><kbd>End</kbd>
first, last <kbd>+</kbd><kbd>-</kbd> zoom <kbd>W</kbd><kbd>A</kbd><kbd>S</kbd><kbd>D</kbd> pan <kbd>F</kbd> follow
<kbd>0</kbd> fit <kbd>Esc</kbd> release; drag, wheel, click a track. Colour: class. Thick sides face the sensor,
dashed towards an end that is hidden; faded: coasting; thin grey: tentative; dotted: truth; arrows: way of one second;
ellipses: 2 sigma of the centre.</p>
</section>
<section class="card"><h2>Tracks over time</h2><canvas id="strip" aria-label="Timeline of tracks"></canvas>
<p class="keys"><span id="rows"></span>Top: how many are confirmed or coasting. Bars: thin tentative, full confirmed, hollow
coasting; | birth, x death. Click to go there.</p></section>
)html";

}  // namespace

std::string track_report_page(const TrackReport& report, const TrackReportHeader& header) {
  std::string html;
  html += html_opening(header.input + " - tracks", header.input, header.configuration);
  html += thinning_note(report);
  html += kViewer;
  html += "<div class=\"cards\">\n" + value_table("Run", summary_rows(report, header)) +
          value_table("Against truth", header.metrics) +
          value_table("Diagnostics", header.diagnostics) + "</div>\n";
  for (const auto& table : header.tables) html += html_table(table);
  html += charts_of(header);
  html += "<section class=\"card\"><h2>Estimate minus measurement, beside table 2 of [Lu2018]</h2>";
  html += difference_table(report);
  html +=
      "<p class=\"note\">Axes of the paper: x lateral, to the right; y forward; seen from the ego "
      "vehicle. Frames in which a target was missed are left out, not counted as zero. A small "
      "difference means that the estimate follows the measurement, not that it is right: the last "
      "two columns compare with the nearest true centre within 2 m, where truth is known.</p>"
      "</section>\n";
  html += "<section class=\"card\"><h2>Measured and estimated, as figures 8 to 14 of [Lu2018]</h2>";
  html += track_curves(report) + "</section>\n</main>\n";
  html += "<script type=\"application/json\" id=\"data\">" + track_report_data(report);
  html += "</script>\n<script>\n";
  html += viewer_script();
  return html + "</script></body></html>\n";
}

}  // namespace scanfuse::report
