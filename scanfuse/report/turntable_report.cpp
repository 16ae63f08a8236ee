#include "scanfuse/report/turntable_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scanfuse/report/assets.hpp"
#include "scanfuse/report/svg_plot.hpp"
#include "scanfuse/report/table.hpp"
#include "scanfuse/report/turntable_scene.hpp"

namespace scanfuse::report {
namespace {

std::size_t used(const TurntableReport& report) {
  return static_cast<std::size_t>(
      std::ranges::count_if(report.positions, [](const auto& p) { return p.used; }));
}

double block_sigma(const Rig& rig, int first, int count) {
  return std::sqrt(std::max(rig.covariance.diagonal().segment(first, count).sum(), 0.0));
}

double worst_in_arc_mm(const TurntableReport& report) {
  double worst = 0;
  for (int k = 0; k <= 20; ++k) {
    const double angle = report.rig.first_turntable_rad +
                         (report.rig.last_turntable_rad - report.rig.first_turntable_rad) * k / 20;
    worst = std::max(worst, report.point_sigma(angle, kBandRange_m) * 1e3);
  }
  return worst;
}

std::string verdict(const TurntableReport& report) {
  std::string text =
      fmt::format("{} of {} positions used. ", used(report), report.positions.size());
  if (report.point_sigma && !report.rig.covariance.isZero(0)) {
    text += fmt::format(
        "Within the calibrated arc a point at {} m is placed to {:.2f} mm (one standard deviation, "
        "from the calibration alone).",
        kBandRange_m, worst_in_arc_mm(report));
  } else {
    text += fmt::format("Method {}: no uncertainty is known.", report.method);
  }
  if (report.warnings.empty()) return text + " Nothing is weak.";
  return text + fmt::format(" {} warning{}, see below.", report.warnings.size(),
                            report.warnings.size() == 1 ? "" : "s");
}

ReportTable rig_table(const TurntableReport& report) {
  const Rig& rig = report.rig;
  const Eigen::Vector3d n = rig.axis_direction, p = rig.axis_point_m * 1e3;
  const Eigen::Vector3d c = rig.camera_from_lidar.translation_m * 1e3;
  const bool known = !rig.covariance.isZero(0);
  const auto sigma = [&](int first, int count, double scale, const char* unit) {
    return known ? fmt::format("{:.4f} {}", block_sigma(rig, first, count) * scale, unit) : "-";
  };
  ReportTable table{"The rig, camera frame", {"", "estimate", "standard deviation"}, {}};
  table.rows = {
      {"axis direction", fmt::format("{:.6f}, {:.6f}, {:.6f}", n.x(), n.y(), n.z()),
       sigma(0, 2, degrees(1), "deg")},
      {"axis point nearest to the camera",
       fmt::format("{:.3f}, {:.3f}, {:.3f} mm", p.x(), p.y(), p.z()), sigma(2, 2, 1e3, "mm")},
      {"lidar centre at angle 0", fmt::format("{:.3f}, {:.3f}, {:.3f} mm", c.x(), c.y(), c.z()),
       sigma(7, 3, 1e3, "mm")},
      {"lidar axes", "", sigma(4, 3, degrees(1), "deg")},
      {"range bias", fmt::format("{:.3f} mm", rig.range_bias_m * 1e3), sigma(10, 1, 1e3, "mm")},
      {"turn over commanded turn", fmt::format("{:.6f}", rig.angle_scale), sigma(11, 1, 1, "")},
      {"calibrated arc",
       fmt::format("{:.2f} to {:.2f} deg", degrees(rig.first_turntable_rad),
                   degrees(rig.last_turntable_rad)),
       ""},
      {"rms of corners, stripe, lidar",
       fmt::format("{:.3f} px, {:.3f} px, {:.3f} mm", report.rms[0], report.rms[1], report.rms[2]),
       ""},
      {"chi-squared per degree of freedom", fmt::format("{:.3f}", report.chi2_per_dof),
       "1 is right"}};
  return table;
}

ReportTable table1(const TurntableReport& report) {
  const auto& ours = report.table1;
  ReportTable table{
      "Beside Table 1 of [Liu2023]", {"", "lidar centre, mm", "z axis, deg", "x axis, deg"}, {}};
  const auto row = [&](const char* name, std::size_t k) {
    return std::vector<std::string>{name, fmt::format("{:.2f}", ours[0][k]),
                                    fmt::format("{:.3f}", ours[1][k]),
                                    fmt::format("{:.3f}", ours[2][k])};
  };
  table.rows = {row("mean, here", 0),
                {"mean, paper", "1.12", "0.203", "0.662"},
                row("greatest, here", 1),
                {"greatest, paper", "2.72", "0.455", "1.580"}};
  table.note =
      "These are residuals: how far the pose from each single position lies from the rig fitted to "
      "all of them. They tell how noisy a single position is, not how accurate the rig is: small "
      "residuals can stand beside an axis that is millimetres off. The accuracy is the band below.";
  return table;
}

Chart residual_chart(const TurntableReport& report, const char* title, const char* unit,
                     const std::function<double(const ReportedPosition&, std::size_t)>& value,
                     std::size_t curves) {
  Chart chart;
  chart.title = title;
  chart.x_label = "turntable, degrees";
  chart.y_label = unit;
  for (std::size_t b = 0; b < curves; ++b) {
    Series series{curves > 1 ? fmt::format("board {}", b) : "", {}, Series::Style::kDots};
    for (const auto& position : report.positions) {
      if (!position.used) continue;
      series.points.emplace_back(degrees(position.turntable_rad), value(position, b));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string charts(const TurntableReport& report) {
  std::string html =
      "<section class=\"card\"><h2>Residuals of each position</h2><div class=\"charts\">\n";
  html += line_chart(residual_chart(
      report, "Stripe, rms distance from the model", "px",
      [](const auto& p, std::size_t b) { return p.stripe_px[b]; }, 2));
  html += line_chart(residual_chart(
      report, "Lidar, rms along the rays", "mm",
      [](const auto& p, std::size_t b) { return p.lidar_m[b] * 1e3; }, 2));
  html += line_chart(residual_chart(
      report, "Turntable, estimated minus commanded", "mdeg",
      [](const auto& p, std::size_t) { return degrees(p.correction_rad) * 1e3; }, 1));
  return html + "</div></section>\n";
}

std::string warning_list(const TurntableReport& report) {
  std::string html;
  for (const auto& warning : report.warnings) html += "<li>" + escape_html(warning) + "</li>";
  std::string left;
  for (const auto& position : report.positions) {
    if (position.used) continue;
    left += fmt::format("<li>{} ({:.2f}&deg;): {}</li>", escape_html(position.name),
                        degrees(position.turntable_rad), escape_html(position.reason));
  }
  if (!html.empty()) {
    html = "<section class=\"card warn\"><h2>Warnings</h2><ul>" + html + "</ul></section>\n";
  }
  if (!left.empty()) {
    html += "<section class=\"card\"><h2>Positions left out</h2><ul>" + left + "</ul></section>\n";
  }
  return html;
}

constexpr std::string_view kView = R"html(
<section class="card viewer"><h2>The rig in space</h2>
<canvas id="space" tabindex="0" aria-label="Camera, boards, lidar and turntable axis"></canvas>
<p class="keys">Drag to turn, wheel or <kbd>+</kbd><kbd>-</kbd> to zoom, arrows to turn, <kbd>0</kbd> to
start anew. Blue: boards. Orange: the turntable's axis and the lidar's x axis. Green: where the lidar's
centre goes over the calibrated arc. Dots: returns on the boards, placed by the rig.</p>
</section>
)html";

}  // namespace

std::string turntable_page(const TurntableReport& report) {
  std::string html = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  html += "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">";
  html += fmt::format("<title>{}</title>\n<style>\n{}{}</style></head>\n",
                      escape_html(report.title), page_style(), turntable_style());
  html += fmt::format(
      "<body><header><h1>Turntable calibration: {}</h1><p class=\"verdict\">{}</p>"
      "</header>\n<main>\n",
      escape_html(report.title), escape_html(verdict(report)));
  html += warning_list(report);
  html += "<div class=\"pair\">" + html_table(rig_table(report)) + html_table(table1(report)) +
          "</div>\n";
  html += "<section class=\"card\"><h2>How sure a point is</h2>" + error_band_chart(report) +
          "</section>\n";
  html += kView;
  html += charts(report);
  const std::string pictures = position_pictures(report);
  if (!pictures.empty()) {
    html += "<section class=\"card\"><h2>What was found</h2><div class=\"found\">\n" + pictures +
            "</div></section>\n";
  }
  html += "</main>\n<script id=\"scene\" type=\"application/json\">" +
          turntable_scene_json(report) + "</script>\n<script>\n";
  return html + std::string(turntable_script()) + "</script></body></html>\n";
}

}  // namespace scanfuse::report
