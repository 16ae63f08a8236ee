#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {

/// From the doctype into <main>: title, style, a heading with a note under it. Texts are escaped.
[[nodiscard]] std::string html_opening(std::string_view title, std::string_view heading,
                                       std::string_view note);

/// A card of charts side by side.
[[nodiscard]] std::string html_charts(const std::vector<Chart>& charts);

}  // namespace scanfuse::report
