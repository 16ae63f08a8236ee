#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace scanfuse::report {

/// One curve of a chart. A point that is not finite breaks the line.
struct Series {
  enum class Style { kLine, kDots, kDashed, kMarks };  ///< kMarks: ticks on the x axis at each x
  std::string name;                                    ///< for the legend
  std::vector<Eigen::Vector2d> points;
  Style style = Style::kLine;
};

struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  int width_px = 620;
  int height_px = 240;
};

/// An <svg> element with axes, grid, legend and the series in colours told apart by colour-blind
/// people [Okabe2008]. Stands alone and inside a page; takes its colours from the CSS variables
/// --s0 .. --s7, --ink, --muted and --line where the page sets them. Texts are escaped. Without any
/// finite point the chart says so.
[[nodiscard]] std::string line_chart(const Chart& chart);

/// The colour of the k-th series, with the fallback where the page sets none; eight, then again.
/// The last one is grey.
inline constexpr std::size_t kSeriesColours = 8;
[[nodiscard]] std::string series_colour(std::size_t k);

/// Text for HTML and XML: & < > " ' escaped.
[[nodiscard]] std::string escape_html(std::string_view text);

}  // namespace scanfuse::report
