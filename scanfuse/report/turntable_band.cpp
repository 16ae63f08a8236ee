#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scanfuse/report/turntable_scene.hpp"

namespace scanfuse::report {
namespace {

constexpr int kWidth = 860, kHeight = 280, kLeft = 62, kRight = 14, kTop = 16, kBottom = 40;
constexpr int kSteps = 180;

/// Places of angle (degrees) and error (mm, logarithmic) in the picture.
struct BandAxes {
  double first_deg = -90, last_deg = 90;
  double low_mm = 0.01, high_mm = 1;

  [[nodiscard]] double x(double angle_deg) const {
    return kLeft + (kWidth - kLeft - kRight) * (angle_deg - first_deg) / (last_deg - first_deg);
  }
  [[nodiscard]] double y(double error_mm) const {
    const double share = std::log(error_mm / low_mm) / std::log(high_mm / low_mm);
    return kHeight - kBottom - (kHeight - kTop - kBottom) * std::clamp(share, 0.0, 1.0);
  }
};

std::string grid(const BandAxes& axes) {
  std::string svg;
  for (double decade = axes.low_mm; decade <= axes.high_mm * 1.001; decade *= 10) {
    const double y = axes.y(decade);
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g} mm</text>",
        kLeft, kWidth - kRight, y, kLeft - 6, y + 4, decade);
  }
  const double span = axes.last_deg - axes.first_deg;
  const double step = span > 250 ? 60 : span > 120 ? 30 : 15;
  for (double a = std::ceil(axes.first_deg / step) * step; a <= axes.last_deg + 1e-9; a += step) {
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}&#176;</text>",
        axes.x(a), kTop, kHeight - kBottom, kHeight - kBottom + 16, a);
  }
  return svg;
}

}  // namespace

std::string error_band_chart(const TurntableReport& report) {
  if (!report.point_sigma || report.rig.covariance.isZero(0)) {
    return "<p class=\"note\">This method gives no covariance; calibrate with --method joint.</p>";
  }
  const auto [first, last] =
      std::minmax(report.rig.first_turntable_rad, report.rig.last_turntable_rad);
  const double middle = degrees((first + last) / 2), half = std::max(90.0, degrees(last - first));
  BandAxes axes{middle - half, middle + half, 0.01, 1};
  std::vector<Eigen::Vector2d> curve;
  double least = 1e9, most = 0;
  for (int k = 0; k <= kSteps; ++k) {
    const double angle = axes.first_deg + (axes.last_deg - axes.first_deg) * k / kSteps;
    const double error = std::max(report.point_sigma(radians(angle), kBandRange_m) * 1e3, 1e-6);
    curve.emplace_back(angle, error);
    least = std::min(least, error);
    most = std::max(most, error);
  }
  axes.low_mm = std::pow(10, std::floor(std::log10(least)));
  axes.high_mm = std::max(std::pow(10, std::ceil(std::log10(most))), axes.low_mm * 10);
  std::string svg = fmt::format(
      "<svg class=\"band\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Error of a point over "
      "the turntable's angle\">",
      kWidth, kHeight);
  const double from = axes.x(degrees(first)), to = axes.x(degrees(last));
  svg += fmt::format(
      "<rect class=\"arc\" x=\"{:.1f}\" width=\"{:.1f}\" y=\"{}\" height=\"{}\"/>"
      "<text class=\"in\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">calibrated arc</text>",
      from, std::max(to - from, 1.0), kTop, kHeight - kTop - kBottom, (from + to) / 2, kTop + 14);
  svg += grid(axes);
  std::string area = fmt::format("M{:.1f} {}", axes.x(curve.front().x()), kHeight - kBottom), line;
  for (const auto& p : curve) {
    const auto at = fmt::format("{:.1f} {:.1f}", axes.x(p.x()), axes.y(p.y()));
    area += "L" + at;
    line += (line.empty() ? "M" : "L") + at;
  }
  svg += fmt::format("<path class=\"under\" d=\"{}L{:.1f} {}Z\"/><path class=\"over\" d=\"{}\"/>",
                     area, axes.x(curve.back().x()), kHeight - kBottom, line);
  return svg + fmt::format(
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">angle of the turntable; "
                   "standard deviation of a point 1.5 m from the lidar, from the calibration "
                   "alone</text></svg>",
                   kWidth / 2, kHeight - 6);
}

}  // namespace scanfuse::report
