#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/report/svg_plot.hpp"
#include "scanfuse/report/table.hpp"
#include "scanfuse/types/bearing.hpp"

namespace scanfuse::report {

/// A line of sight and the target it went to, -1 for clutter. World frame.
struct SightLine {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  std::int64_t target = -1;
};

/// One scan as its map shows it. World frame.
struct PassiveView {
  std::vector<SightLine> lines;
  std::vector<Fix> fixes;
  std::vector<bool> ghosts;  ///< by fix: its bearings are not all of one target; empty: not known
  std::vector<Eigen::Vector3d> truth_m;
};

enum class ViewFrom { kAbove, kSide };  ///< x to the right, y or z up

/// An <svg> element: sensors, lines of sight, fixes with their 95 % ellipses, ghosts, truth. Both
/// axes have one scale. What it shows is bounded by sensors, fixes and truth; lines are cut there.
[[nodiscard]] std::string passive_map(const PassiveView& view,
                                      std::span<const PassiveSensor> sensors, ViewFrom from);

/// A scan's part of the page.
struct PassiveSection {
  std::string title;
  PassiveView view;
  std::vector<ReportTable> tables;
  std::vector<Chart> charts;
};

/// One HTML page that needs no other file; all texts are escaped.
[[nodiscard]] std::string passive_page(const std::string& title, const std::string& note,
                                       std::span<const PassiveSensor> sensors,
                                       const std::vector<ReportTable>& tables,
                                       const std::vector<PassiveSection>& sections);

}  // namespace scanfuse::report
