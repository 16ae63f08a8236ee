#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scanfuse/report/passive_report.hpp"

namespace scanfuse::report {
namespace {

constexpr double kEllipse95 = 5.991;  ///< chi-square of two degrees of freedom

std::string colour_of(std::int64_t target) {
  return series_colour(static_cast<std::size_t>(target) % (kSeriesColours - 1));  // not the grey
}

class MapCanvas {
 public:
  MapCanvas(const PassiveView& view, std::span<const PassiveSensor> sensors, ViewFrom from)
      : view_(view), sensors_(sensors), up_(from == ViewFrom::kAbove ? 1 : 2) {
    for (const auto& s : sensors) cover(s.world_from_sensor.translation_m);
    for (const auto& fix : view.fixes) cover(fix.position_m);
    for (const auto& p : view.truth_m) cover(p);
    const Eigen::Array2d size = high_ - low_;
    const double room = std::max(0.08 * size.maxCoeff(), 1e-3);
    low_ -= room;
    high_ += room;
    const Eigen::Array2d whole = high_ - low_;
    scale_ = std::min((kWidth - kLeft - kRight) / whole.x(), kTallest / whole.y());
    height_ = std::max(scale_ * whole.y(), 60.0);
  }

  std::string draw() {
    const bool above = up_ == 1;
    put(R"svg(<svg class="chart" viewBox="0 0 {} {:.0f}" role="img" aria-label="{}" )svg"
        R"svg(font-family="system-ui,sans-serif" font-size="11">)svg",
        kWidth, kTop + height_ + kBottom, above ? "From above" : "From the side");
    put(R"svg(<text x="{}" y="14" font-size="12" font-weight="600" fill="var(--ink,#222)">{}</text>)svg",
        kLeft, above ? "From above" : "From the side");
    grid(above ? "y" : "z");
    put(R"svg(<svg x="{0}" y="{1}" width="{2:.1f}" height="{3:.1f}" viewBox="{0} {1} {2:.1f} {3:.1f}">)svg",
        kLeft, kTop, width(), height_);
    for (const auto& line : view_.lines) sight_line(line);
    for (const auto& p : view_.truth_m) ring(p);
    for (std::size_t k = 0; k < view_.fixes.size(); ++k) fix(view_.fixes[k], is_ghost(k));
    put("</svg>");
    for (const auto& sensor : sensors_) square(sensor);
    return text_ + "</svg>\n";
  }

 private:
  static constexpr int kWidth = 1220, kLeft = 70, kRight = 60, kTop = 24, kBottom = 36;
  static constexpr double kTallest = 760;

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
  }
  [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& v) const { return {v.x(), v[up_]}; }
  [[nodiscard]] double width() const { return scale_ * (high_ - low_).x(); }
  [[nodiscard]] bool is_ghost(std::size_t k) const {
    return k < view_.ghosts.size() && view_.ghosts[k];
  }

  void cover(const Eigen::Vector3d& place_m) {
    if (!place_m.allFinite()) return;
    const Eigen::Array2d p = flat(place_m).array();
    low_ = empty_ ? p : low_.min(p).eval();
    high_ = empty_ ? p : high_.max(p).eval();
    empty_ = false;
  }

  [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& place_m) const {
    const Eigen::Array2d d = scale_ * (flat(place_m).array() - low_);
    return {kLeft + d.x(), kTop + height_ - d.y()};
  }

  void grid(std::string_view upward) {
    const double step = round_step((high_ - low_).maxCoeff() / 8);
    const double unit = step >= 1000 ? 1000 : 1;
    const std::string_view name = unit > 1 ? "km" : "m";
    const double bottom = kTop + height_, right = kLeft + width();
    for (double x = std::ceil(low_.x() / step) * step; x <= high_.x(); x += step) {
      put(R"svg(<path d="M{0:.1f} {1}V{2:.1f}" stroke="var(--line,#ddd)"/><text x="{0:.1f}" )svg"
          R"svg(y="{3:.1f}" text-anchor="middle" fill="var(--muted,#666)">{4:.4g}</text>)svg",
          kLeft + scale_ * (x - low_.x()), kTop, bottom, bottom + 14, tidy(x, step) / unit);
    }
    for (double y = std::ceil(low_.y() / step) * step; y <= high_.y(); y += step) {
      const double at = bottom - scale_ * (y - low_.y());
      put(R"svg(<path d="M{0} {1:.1f}H{2:.1f}" stroke="var(--line,#ddd)"/><text x="{3}" )svg"
          R"svg(y="{4:.1f}" text-anchor="end" fill="var(--muted,#666)">{5:.4g}</text>)svg",
          kLeft, at, right, kLeft - 6, at + 4, tidy(y, step) / unit);
    }
    put(R"svg(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" fill="var(--muted,#666)">x [{}]</text>)svg",
        (kLeft + right) / 2, bottom + 30, name);
    put(R"svg(<text transform="translate(16 {:.1f}) rotate(-90)" text-anchor="middle" )svg"
        R"svg(fill="var(--muted,#666)">{} [{}]</text>)svg",
        (kTop + bottom) / 2, upward, name);
  }

  static double round_step(double raw) {
    const double power = std::pow(10, std::floor(std::log10(raw)));
    return power * (raw / power < 1.5 ? 1 : raw / power < 3.5 ? 2 : raw / power < 7.5 ? 5 : 10);
  }
  static double tidy(double value, double step) { return std::round(value / step) * step + 0.0; }

  /// To the point nearest to its fix; clutter to the edge, and in a tilted view only if it has a
  /// slope to show.
  void sight_line(const SightLine& line) {
    const auto target = static_cast<std::size_t>(line.target);
    const bool taken = line.target >= 0 && target < view_.fixes.size();
    double length = 4 * (high_ - low_).matrix().norm();
    if (taken) {
      length = (view_.fixes[target].position_m - line.origin_m).dot(line.direction);
    }
    const auto from = pixel(line.origin_m), to = pixel(line.origin_m + length * line.direction);
    put(R"svg(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}" stroke-opacity="{}"/>)svg",
        from.x(), from.y(), to.x(), to.y(), taken ? colour_of(line.target) : "var(--muted,#888)",
        taken ? 0.45 : 0.3);
  }

  void fix(const Fix& fix, bool ghost) {
    const auto at = pixel(fix.position_m);
    const auto colour = colour_of(fix.target);
    ellipse(fix, at, colour);
    put(R"svg(<circle cx="{:.1f}" cy="{:.1f}" r="2.6" fill="{}"><title>{}</title></circle>)svg",
        at.x(), at.y(), colour,
        fmt::format("target {}: {:.1f}, {:.1f}, {:.1f} m, exists with {:.3f}", fix.target,
                    fix.position_m.x(), fix.position_m.y(), fix.position_m.z(),
                    fix.existence_probability));
    if (!ghost) return;
    put(R"svg(<path d="M{:.1f} {:.1f}m-6 -6l12 12m0 -12l-12 12" stroke="var(--ink,#222)" )svg"
        R"svg(stroke-width="2"/>)svg",
        at.x(), at.y());
  }

  void ellipse(const Fix& fix, const Eigen::Vector2d& at, const std::string& colour) {
    Eigen::Matrix2d P;
    P << fix.covariance_m2(0, 0), fix.covariance_m2(0, up_), fix.covariance_m2(up_, 0),
        fix.covariance_m2(up_, up_);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(P);
    const Eigen::Array2d radii = scale_ * (kEllipse95 * axes.eigenvalues().array().max(0)).sqrt();
    const Eigen::Vector2d longest = axes.eigenvectors().col(1);
    put(R"svg(<ellipse rx="{:.2f}" ry="{:.2f}" transform="translate({:.1f} {:.1f}) rotate({:.1f})" )svg"
        R"svg(fill="{}" fill-opacity="0.15" stroke="{}"/>)svg",
        radii[1], radii[0], at.x(), at.y(),
        -std::atan2(longest.y(), longest.x()) * 180 / std::numbers::pi, colour, colour);
  }

  void ring(const Eigen::Vector3d& place_m) {
    const auto at = pixel(place_m);
    put(R"svg(<circle cx="{:.1f}" cy="{:.1f}" r="5.5" fill="none" stroke="var(--ink,#222)"/>)svg",
        at.x(), at.y());
  }

  void square(const PassiveSensor& sensor) {
    const auto at = pixel(sensor.world_from_sensor.translation_m);
    put(R"svg(<path d="M{:.1f} {:.1f}h10v10h-10z" fill="var(--ink,#222)"/>)svg", at.x() - 5,
        at.y() - 5);
    put(R"svg(<text x="{:.1f}" y="{:.1f}" fill="var(--ink,#222)" font-size="12">{}</text>)svg",
        at.x() + 9, at.y() - 7, escape_html(sensor.name));
  }

  const PassiveView& view_;
  std::span<const PassiveSensor> sensors_;
  int up_;
  Eigen::Array2d low_ = Eigen::Array2d::Zero(), high_ = Eigen::Array2d::Zero();
  bool empty_ = true;
  double scale_ = 1, height_ = 0;
  std::string text_;
};

}  // namespace

std::string passive_map(const PassiveView& view, std::span<const PassiveSensor> sensors,
                        ViewFrom from) {
  return MapCanvas(view, sensors, from).draw();
}

}  // namespace scanfuse::report
