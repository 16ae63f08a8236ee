#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/report/passive_report.hpp"
#include "scanfuse/report/svg_plot.hpp"
#include "scanfuse/report/table.hpp"

namespace scanfuse::report {

/// A track as its page shows it. World frame.
struct PointTrack {
  enum class Status : std::uint8_t { kTentative, kConfirmed, kCoasting };
  std::int64_t id = 0;
  Status status = Status::kTentative;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Identity();  ///< of the position
  double existence_probability = 0;
};

/// One scan: `SightLine::target` is a track's id, -1 for clutter.
struct PointTrackFrame {
  std::int64_t scan = 0;
  double time_s = 0;  ///< since the first scan
  std::vector<std::int32_t> sensor_of_line;
  std::vector<SightLine> lines;
  std::vector<PointTrack> tracks;
  std::vector<Eigen::Vector3d> truth_m;
};

/// One HTML page that needs no other file: a map with a slider over the frames, charts, tables. All
/// texts are escaped; figures that are not finite are drawn nowhere.
[[nodiscard]] std::string point_track_page(const std::string& title, const std::string& note,
                                           std::span<const PassiveSensor> sensors,
                                           std::span<const PointTrackFrame> frames,
                                           const std::vector<ReportTable>& tables,
                                           const std::vector<Chart>& charts);

}  // namespace scanfuse::report
