#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanfuse/report/page.hpp"
#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {
namespace {

constexpr std::size_t kCurvedTracks = 4;
constexpr std::size_t kTabledTracks = 12;
constexpr double kTruthReach_m = 2;
constexpr int kChartWidth_px = 400;  // three fit beside one another, unscaled
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

/// Confirmed tracks, the longest first; the smaller id where they tie.
std::vector<std::int64_t> longest_tracks(const TrackReport& report, std::size_t count) {
  std::vector<std::int64_t> ids;
  for (const auto& [id, life] : report.lives()) {
    if (life.confirmed) ids.push_back(id);
  }
  std::stable_sort(ids.begin(), ids.end(), [&](auto a, auto b) {
    return report.lives().at(a).measured > report.lives().at(b).measured;
  });
  ids.resize(std::min(ids.size(), count));
  return ids;
}

/// As the paper has it: x lateral (to the right), y forward, seen from the ego vehicle.
Eigen::Vector2d paper_axes(const Pose2& world_from_ego, const Eigen::Vector2d& world_m) {
  const Eigen::Vector2d ego = world_from_ego.inverse() * world_m;
  return {-ego.y(), ego.x()};
}

/// Centre of the truth object nearest to the track, in the world, within reach.
std::optional<Eigen::Vector2d> nearest_truth(const TrackReport& report, const ReportedFrame& frame,
                                             const Eigen::Vector2d& position_m) {
  const auto found = report.truth().find(frame.frame);
  if (found == report.truth().end()) return std::nullopt;
  const bool in_ego = found->second.coordinate_frame == "ego";
  std::optional<Eigen::Vector2d> best;
  for (const auto& object : found->second.objects) {
    const Eigen::Vector2d p = in_ego ? frame.world_from_ego * object.position_m : object.position_m;
    const double d = (p - position_m).norm();
    if (d <= kTruthReach_m && (!best || d < (*best - position_m).norm())) best = p;
  }
  return best;
}

/// What the charts of one track show, in the paper's axes, frame by frame.
struct TrackCurve {
  std::vector<double> frame;
  std::vector<Eigen::Vector2d> estimate, measured, truth;  ///< not finite: none
};

TrackCurve curve_of(const TrackReport& report, std::int64_t id) {
  const Eigen::Vector2d none(kGap, kGap);
  TrackCurve curve;
  for (const auto& frame : report.frames()) {
    for (const auto& track : frame.tracks) {
      if (track.id != id) continue;
      const auto truth = nearest_truth(report, frame, track.box.centre_m);
      curve.frame.push_back(static_cast<double>(frame.frame));
      curve.estimate.push_back(paper_axes(frame.world_from_ego, track.box.centre_m));
      curve.measured.push_back(track.measured ? paper_axes(frame.world_from_ego, track.measured_m)
                                              : none);
      curve.truth.push_back(truth ? paper_axes(frame.world_from_ego, *truth) : none);
    }
  }
  return curve;
}

Series axis_series(std::string name, const std::vector<double>& frames,
                   const std::vector<Eigen::Vector2d>& values, int axis, Series::Style style) {
  Series series{std::move(name), {}, style};
  bool any = false;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    series.points.emplace_back(frames[i], values[i][axis]);
    any = any || std::isfinite(values[i][axis]);
  }
  if (!any) series.points.clear();
  return series;
}

Series missed_series(const TrackCurve& curve) {
  Series series{"missed", {}, Series::Style::kMarks};
  for (std::size_t i = 0; i < curve.frame.size(); ++i) {
    if (!curve.measured[i].allFinite()) series.points.emplace_back(curve.frame[i], 0);
  }
  return series;
}

Chart position_chart(const TrackCurve& curve, std::int64_t id, int axis) {
  using enum Series::Style;
  const std::string name = axis == 0 ? "x, lateral" : "y, forward";
  return {fmt::format("Track {}: {}", id, name),
          "frame",
          name + " [m]",
          {axis_series("estimated", curve.frame, curve.estimate, axis, kLine),
           axis_series("measured", curve.frame, curve.measured, axis, kDots),
           axis_series("truth", curve.frame, curve.truth, axis, kDashed), missed_series(curve)},
          kChartWidth_px};
}

Chart difference_chart(const TrackCurve& curve, std::int64_t id) {
  std::vector<Eigen::Vector2d> difference;
  difference.reserve(curve.frame.size());
  for (std::size_t i = 0; i < curve.frame.size(); ++i) {
    difference.push_back(curve.estimate[i] - curve.measured[i]);
  }
  using enum Series::Style;
  return {fmt::format("Track {}: estimate minus measurement", id),
          "frame",
          "difference [m]",
          {axis_series("x, lateral", curve.frame, difference, 0, kLine),
           axis_series("y, forward", curve.frame, difference, 1, kLine),
           {},
           missed_series(curve)},
          kChartWidth_px};
}

/// RMS of estimate minus truth over the shown frames, lateral and forward; empty without truth.
std::string truth_cells(const TrackReport& report, std::int64_t id) {
  const TrackCurve curve = curve_of(report, id);
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  int count = 0;
  for (std::size_t i = 0; i < curve.frame.size(); ++i) {
    const Eigen::Vector2d d = curve.estimate[i] - curve.truth[i];
    if (!d.allFinite()) continue;
    sum += d.array().square();
    ++count;
  }
  if (count == 0) return "<td>-</td><td>-</td>";
  const Eigen::Array2d rms = (sum / count).sqrt();
  return fmt::format("<td>{:.4f}</td><td>{:.4f}</td>", rms[0], rms[1]);
}

}  // namespace

std::string track_curves(const TrackReport& report) {
  std::string html;
  for (const std::int64_t id : longest_tracks(report, kCurvedTracks)) {
    const TrackCurve curve = curve_of(report, id);
    html += fmt::format(
        "<div class=\"charts\">{}{}{}</div>\n", line_chart(position_chart(curve, id, 0)),
        line_chart(position_chart(curve, id, 1)), line_chart(difference_chart(curve, id)));
  }
  return html.empty() ? "<p>No track was confirmed.</p>" : html;
}

std::string difference_table(const TrackReport& report) {
  std::string rows;
  for (const std::int64_t id : longest_tracks(report, kTabledTracks)) {
    const TrackLife& life = report.lives().at(id);
    const auto n = static_cast<double>(std::max<std::int64_t>(life.measured, 1));
    const Eigen::Array2d rms = (life.square_difference_m2 / n).sqrt();
    rows += fmt::format(
        "<tr data-track=\"{}\"><th>track {}, {}</th><td>{}</td><td>{:.4f}</td><td>{:.4f}</td>{}"
        "</tr>\n",
        id, id, to_string(life.object_class), life.measured, rms[0], rms[1],
        truth_cells(report, id));
  }
  return "<table class=\"wide\"><thead><tr><th></th><th>measured frames</th>"
         "<th>RMS x, lateral [m]</th><th>RMS y, forward [m]</th>"
         "<th>to truth x [m]</th><th>to truth y [m]</th></tr></thead><tbody>\n" +
         rows +
         "<tr class=\"paper\"><th>[Lu2018], vehicle 1</th><td></td><td>0.0856</td><td>0.1304</td>"
         "<td></td><td></td></tr>\n"
         "<tr class=\"paper\"><th>[Lu2018], vehicle 2</th><td></td><td>0.0694</td><td>0.1670</td>"
         "<td></td><td></td></tr></tbody></table>\n";
}

}  // namespace scanfuse::report
