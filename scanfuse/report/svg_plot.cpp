#include "scanfuse/report/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scanfuse::report {
namespace {

constexpr std::array<const char*, kSeriesColours> kPalette{
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#882255", "#777777"};

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void cover(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// A little room, and never nothing.
  void widen() {
    const double room = high > low ? 0.04 * (high - low) : std::max(0.5, 0.05 * std::abs(high));
    low -= room;
    high += room;
  }
};

/// About `count` round numbers inside the extent.
std::vector<double> round_ticks(const Extent& extent, int count) {
  const double raw = (extent.high - extent.low) / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double step = power * (raw / power < 1.5   ? 1
                               : raw / power < 3.5 ? 2
                               : raw / power < 7.5 ? 5
                                                   : 10);
  std::vector<double> ticks;
  const double first = std::ceil(extent.low / step);
  for (int k = 0; k <= 4 * count && (first + k) * step <= extent.high; ++k) {
    ticks.push_back((first + k) * step + 0.0);
  }
  return ticks;
}

class ChartCanvas {
 public:
  explicit ChartCanvas(const Chart& chart) : chart_(chart) {
    for (const auto& series : chart.series) {
      for (const auto& p : series.points) {
        if (std::isfinite(p.x())) x_.cover(p.x());
        if (std::isfinite(p.y()) && series.style != Series::Style::kMarks) y_.cover(p.y());
      }
    }
    empty_ = !(x_.low <= x_.high && y_.low <= y_.high);
    if (!empty_) {
      x_.widen();
      y_.widen();
    }
    int rows = 1;
    place_legend([&](std::size_t, double, int row) { rows = row + 1; });
    top_ = kTop + kLegendRow * (rows - 1);
  }

  std::string draw() {
    put(R"svg(<svg class="chart" viewBox="0 0 {} {}" role="img" aria-label="{}" )svg"
        R"svg(font-family="system-ui,sans-serif" font-size="11">)svg",
        chart_.width_px, chart_.height_px, escape_html(chart_.title));
    put(R"svg(<text x="{}" y="14" font-size="12" font-weight="600" fill="var(--ink,#222)">{}</text>)svg",
        kLeft, escape_html(chart_.title));
    if (empty_) {
      put(R"svg(<text x="{}" y="{}" fill="var(--muted,#666)">no data</text>)svg", kLeft,
          chart_.height_px / 2);
    } else {
      axes();
      for (std::size_t k = 0; k < chart_.series.size(); ++k) curve(chart_.series[k], k);
      legend();
    }
    return text_ + "</svg>";
  }

 private:
  static constexpr int kLeft = 56, kRight = 12, kTop = 40, kBottom = 36;
  static constexpr int kLegendRow = 14;

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
  }
  [[nodiscard]] double px(double x) const {
    return kLeft + (x - x_.low) / (x_.high - x_.low) * (chart_.width_px - kLeft - kRight);
  }
  [[nodiscard]] double py(double y) const {
    return chart_.height_px - kBottom -
           (y - y_.low) / (y_.high - y_.low) * (chart_.height_px - top_ - kBottom);
  }

  void axes() {
    const int bottom = chart_.height_px - kBottom, right = chart_.width_px - kRight;
    for (const double x : round_ticks(x_, 8)) {
      put(R"svg(<path d="M{0:.1f} {1}V{2}" stroke="var(--line,#ddd)"/><text x="{0:.1f}" y="{3}" )svg"
          R"svg(text-anchor="middle" fill="var(--muted,#666)">{4:g}</text>)svg",
          px(x), top_, bottom, bottom + 14, x);
    }
    for (const double y : round_ticks(y_, 5)) {
      put(R"svg(<path d="M{0} {1:.1f}H{2}" stroke="var(--line,#ddd)"/><text x="{3}" y="{4:.1f}" )svg"
          R"svg(text-anchor="end" fill="var(--muted,#666)">{5:.6g}</text>)svg",
          kLeft, py(y), right, kLeft - 5, py(y) + 4, std::abs(y) < 1e-12 ? 0.0 : y);
    }
    put(R"svg(<path d="M{0} {1}V{2}H{3}" fill="none" stroke="var(--muted,#666)"/>)svg", kLeft, top_,
        bottom, right);
    put(R"svg(<text x="{}" y="{}" text-anchor="middle" fill="var(--muted,#666)">{}</text>)svg",
        (kLeft + right) / 2, chart_.height_px - 6, escape_html(chart_.x_label));
    put(R"svg(<text transform="translate(12 {}) rotate(-90)" text-anchor="middle" )svg"
        R"svg(fill="var(--muted,#666)">{}</text>)svg",
        (top_ + bottom) / 2, escape_html(chart_.y_label));
  }

  void curve(const Series& series, std::size_t k) {
    if (series.style == Series::Style::kMarks) return marks(series, k);
    if (series.style == Series::Style::kDots) return dots(series, k);
    std::string path;
    bool pen_down = false;
    for (const auto& p : series.points) {
      if (!p.allFinite()) {
        pen_down = false;
        continue;
      }
      path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', px(p.x()), py(p.y()));
      pen_down = true;
    }
    put(R"svg(<path d="{}" fill="none" stroke="{}" stroke-width="1.6"{}/>)svg", path,
        series_colour(k),
        series.style == Series::Style::kDashed ? " stroke-dasharray=\"5 3\"" : "");
  }

  void dots(const Series& series, std::size_t k) {
    std::string path;
    for (const auto& p : series.points) {
      if (p.allFinite()) path += fmt::format("M{:.1f} {:.1f}h0", px(p.x()), py(p.y()));
    }
    put(R"svg(<path d="{}" stroke="{}" stroke-width="3.6" stroke-linecap="round"/>)svg", path,
        series_colour(k));
  }

  void marks(const Series& series, std::size_t k) {
    std::string path;
    const int foot = chart_.height_px - kBottom;
    for (const auto& p : series.points) {
      if (std::isfinite(p.x())) path += fmt::format("M{:.1f} {}l-3 7h6z", px(p.x()), foot - 7);
    }
    put(R"svg(<path d="{}" fill="{}"/>)svg", path, series_colour(k));
  }

  /// Tells `place` the number, x and row of each entry; a row ends at the right margin.
  template <class Place>
  void place_legend(Place&& place) const {
    double x = kLeft;
    int row = 0;
    for (std::size_t k = 0; k < chart_.series.size(); ++k) {
      if (chart_.series[k].points.empty() || chart_.series[k].name.empty()) continue;
      const double width = 34 + 6.2 * static_cast<double>(chart_.series[k].name.size());
      if (x > kLeft && x + width - 18 > chart_.width_px) {
        x = kLeft;
        ++row;
      }
      place(k, x, row);
      x += width;
    }
  }

  void legend() {
    place_legend([&](std::size_t k, double x, int row) {
      put(R"svg(<rect x="{:.1f}" y="{}" width="12" height="4" rx="2" fill="{}"/>)svg"
          R"svg(<text x="{:.1f}" y="{}" fill="var(--muted,#666)">{}</text>)svg",
          x, 23 + kLegendRow * row, series_colour(k), x + 16, 29 + kLegendRow * row,
          escape_html(chart_.series[k].name));
    });
  }

  const Chart& chart_;
  Extent x_, y_;
  bool empty_ = false;
  int top_ = kTop;
  std::string text_;
};

}  // namespace

std::string series_colour(std::size_t k) {
  return fmt::format("var(--s{},{})", k % kPalette.size(), kPalette[k % kPalette.size()]);
}

std::string line_chart(const Chart& chart) { return ChartCanvas(chart).draw(); }

std::string escape_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace scanfuse::report
