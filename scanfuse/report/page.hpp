#pragma once

#include <string>

#include "scanfuse/report/track_report.hpp"

namespace scanfuse::report {

/// The page around what a TrackReport collected.
[[nodiscard]] std::string track_report_page(const TrackReport& report,
                                            const TrackReportHeader& header);

/// The collected frames as JSON for the page's script; no `<` in it, so that it can stand in HTML.
[[nodiscard]] std::string track_report_data(const TrackReport& report);

/// Position curves of the longest tracks, and the table beside [Lu2018, table 2].
[[nodiscard]] std::string track_curves(const TrackReport& report);
[[nodiscard]] std::string difference_table(const TrackReport& report);

}  // namespace scanfuse::report
