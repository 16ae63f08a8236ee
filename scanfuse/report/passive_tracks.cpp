#include "scanfuse/report/passive_tracks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scanfuse/report/assets.hpp"
#include "scanfuse/report/opening.hpp"

namespace scanfuse::report {
namespace {

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "0";
}

std::string triple(const Eigen::Vector3d& v, int digits) {
  return number(v.x(), digits) + "," + number(v.y(), digits) + "," + number(v.z(), digits);
}

template <class Items, class Text>
std::string list_of(const Items& items, Text&& text) {
  std::string list = "[";
  for (const auto& item : items) {
    if (list.size() > 1) list += ',';
    list += text(item);
  }
  return list + "]";
}

/// A JSON string that can stand in HTML.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || c == '<' || c == '>' || c == '&' || c == '"' || c == '\\') {
      result += fmt::format("\\u{:04x}", byte);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string point_track_data(const PointTrack& t) {
  const auto& P = t.covariance_m2;
  return fmt::format("[{},{},{},{},{},{},{},{},{},{},{}]", t.id, static_cast<int>(t.status),
                     triple(t.position_m, 2), triple(t.velocity_m_per_s, 2), number(P(0, 0), 2),
                     number(P(0, 1), 2), number(P(0, 2), 2), number(P(1, 1), 2), number(P(1, 2), 2),
                     number(P(2, 2), 2), number(t.existence_probability, 4));
}

std::string point_frame_data(const PointTrackFrame& frame) {
  std::string lines = "[";
  for (std::size_t k = 0; k < frame.lines.size(); ++k) {
    lines += fmt::format("{}[{},{},{}]", k > 0 ? "," : "", frame.sensor_of_line[k],
                         triple(frame.lines[k].direction, 5), frame.lines[k].target);
  }
  return fmt::format(
      "{{\"n\":{},\"t\":{},\"l\":{}],\"k\":{},\"g\":{}}}", frame.scan, number(frame.time_s, 3),
      lines, list_of(frame.tracks, point_track_data),
      list_of(frame.truth_m, [](const auto& p) { return "[" + triple(p, 1) + "]"; }));
}

std::string viewer_html() {
  return R"html(<section class="card viewer"><h2>Tracks</h2>
<canvas id="view" aria-label="Sensors, lines of sight and tracks"></canvas>
<div class="bar"><button id="play">Play</button>
<input id="at" type="range" min="0" max="0" value="0" aria-label="Scan">
<label>from <select id="side"><option value="above">above</option><option value="side">the side</option></select></label>
<label><input id="lines" type="checkbox" checked> lines of sight</label>
<output id="shown"></output></div>
<p class="note">Squares: sensors. Dots: tracks with their number, their way so far and the ellipse that holds the
target with 95 %; hollow: not seen in this scan; grey: not yet confirmed. Lines of sight have the colour of the track
they went to; grey: clutter, or a new target. Rings: where targets really were.</p></section>
)html";
}

}  // namespace

std::string point_track_page(const std::string& title, const std::string& note,
                             std::span<const PassiveSensor> sensors,
                             std::span<const PointTrackFrame> frames,
                             const std::vector<ReportTable>& tables,
                             const std::vector<Chart>& charts) {
  std::string html = html_opening(title, title, note);
  html += viewer_html();
  for (const auto& table : tables) html += html_table(table);
  html +=
      html_charts(charts) + "</main>\n<script type=\"application/json\" id=\"data\">{\"sensors\":";
  html += list_of(sensors, [](const PassiveSensor& s) {
    return fmt::format("{{\"name\":{},\"p\":[{}]}}", quoted(s.name),
                       triple(s.world_from_sensor.translation_m, 2));
  });
  html += ",\"frames\":" + list_of(frames, point_frame_data) + "}</script>\n<script>\n";
  html += passive_tracks_script();
  return html + "</script></body></html>\n";
}

}  // namespace scanfuse::report
