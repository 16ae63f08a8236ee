#pragma once

#include <map>
#include <vector>

#include "scanfuse/evaluate/per_class.hpp"
#include "scanfuse/report/track_report.hpp"

namespace scanfuse::app {

/// Each class against truth, for the report: detection, tracking, errors; and by range.
void add_class_figures(const std::map<ObjectClass, evaluate::ClassEvaluation>& by_class,
                       report::TrackReportHeader& header);

}  // namespace scanfuse::app
