#include "track_passive_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scanfuse::app {
namespace {

using report::PointTrack;
using report::PointTrackFrame;
using report::ReportTable;
using report::Series;
using triangulate::PassiveTrack;

constexpr std::size_t kShownScans = 600;
constexpr std::size_t kShownLines = 400;  ///< of a scan
constexpr std::size_t kRows = 200;

PointTrack::Status status_of(const PassiveTrack& track) {
  if (!track.confirmed) return PointTrack::Status::kTentative;
  return track.bearings.empty() ? PointTrack::Status::kCoasting : PointTrack::Status::kConfirmed;
}

PointTrack shown(const PassiveTrack& track) {
  PointTrack point;
  point.id = track.id;
  point.status = status_of(track);
  point.position_m = track.state.mean.head<3>();
  point.velocity_m_per_s = track.state.mean.tail<3>();
  point.covariance_m2 = track.state.covariance.topLeftCorner<3, 3>();
  point.existence_probability = track.existence_probability();
  return point;
}

PointTrackFrame frame_of(const BearingScan& scan, const PassiveScene& scene,
                         const triangulate::PassiveStep& step, double time_s) {
  PointTrackFrame frame;
  frame.scan = scan.scan;
  frame.time_s = time_s;
  const std::size_t stride = scan.bearings.size() / kShownLines + 1;
  const auto lines = triangulate::lines_of_sight(scan, scene);
  for (std::size_t i = 0; i < lines.size(); i += stride) {
    frame.sensor_of_line.push_back(scan.bearings[i].sensor);
    frame.lines.push_back({lines[i].origin_m, lines[i].direction, step.track_of_bearing[i]});
  }
  for (const PassiveTrack& track : step.tracks) frame.tracks.push_back(shown(track));
  return frame;
}

}  // namespace

PassiveTrackReport::PassiveTrackReport(const PassiveScene& scene, std::size_t scans)
    : scene_(scene),
      stride_(std::max<std::size_t>(1, (scans + kShownScans - 1) / kShownScans)),
      confirmed_{"confirmed", {}, Series::Style::kLine},
      tentative_{"not yet confirmed", {}, Series::Style::kDashed},
      bearings_{"bearings", {}, Series::Style::kLine},
      clutter_{"in no track", {}, Series::Style::kDashed} {}

void PassiveTrackReport::add(const BearingScan& scan, const triangulate::PassiveStep& step) {
  if (!first_) first_ = scan.stamp;
  const double time_s = to_seconds(scan.stamp - *first_);
  follow(scan, step, time_s);
  if (count_++ % stride_ != 0) return;
  frames_.push_back(frame_of(scan, scene_, step, time_s));
  const auto confirmed =
      static_cast<double>(std::ranges::count(step.tracks, true, &PassiveTrack::confirmed));
  const auto all = static_cast<double>(step.tracks.size());
  confirmed_.points.emplace_back(time_s, confirmed);
  tentative_.points.emplace_back(time_s, all - confirmed);
  bearings_.points.emplace_back(time_s, static_cast<double>(scan.bearings.size()));
  clutter_.points.emplace_back(time_s,
                               static_cast<double>(std::ranges::count(step.track_of_bearing, -1)));
}

void PassiveTrackReport::follow(const BearingScan& scan, const triangulate::PassiveStep& step,
                                double time_s) {
  for (const PassiveTrack& track : step.tracks) {
    const auto [at, fresh] = lives_.try_emplace(track.id);
    Life& life = at->second;
    if (fresh) {
      life.first_scan = scan.scan;
      life.first_s = time_s;
    }
    life.last_scan = scan.scan;
    life.last_s = time_s;
    life.scans_seen = track.scans_seen;
    life.bearings += std::ssize(track.bearings);
    life.sigma_m = std::sqrt(track.state.covariance.topLeftCorner<3, 3>().trace());
    life.confirmed = life.confirmed || track.confirmed;
  }
}

void PassiveTrackReport::show(std::span<const TruthFrame> truth) {
  std::map<std::int64_t, const TruthFrame*> by_scan;
  for (const TruthFrame& frame : truth) by_scan[frame.frame] = &frame;
  for (PointTrackFrame& frame : frames_) {
    const auto at = by_scan.find(frame.scan);
    if (at == by_scan.end()) continue;
    for (const TruthObject& object : at->second->objects) {
      frame.truth_m.emplace_back(object.position_m.x(), object.position_m.y(), object.z_m);
    }
  }
}

ReportTable PassiveTrackReport::lives() const {
  ReportTable table{"Confirmed tracks",
                    {"track", "first scan", "last scan", "from [s]", "to [s]", "scans seen",
                     "bearings", "sigma at the end [m]"},
                    {}};
  std::size_t all = 0;
  for (const auto& [id, life] : lives_) {
    if (!life.confirmed || ++all > kRows) continue;
    table.rows.push_back({fmt::format("{}", id), fmt::format("{}", life.first_scan),
                          fmt::format("{}", life.last_scan), fmt::format("{:.2f}", life.first_s),
                          fmt::format("{:.2f}", life.last_s), fmt::format("{}", life.scans_seen),
                          fmt::format("{}", life.bearings), fmt::format("{:.1f}", life.sigma_m)});
  }
  if (all > kRows) table.note = fmt::format("The first {} of {}.", kRows, all);
  return table;
}

std::string PassiveTrackReport::page(const std::string& title,
                                     const std::vector<ReportTable>& tables) const {
  const std::string note =
      fmt::format("Tracks of {} passive sensors. Scans: {}{}.", scene_.sensors.size(), count_,
                  stride_ > 1 ? fmt::format(", one in {} shown", stride_) : "");
  std::vector<ReportTable> all = tables;
  all.push_back(lives());
  return report::point_track_page(
      title, note, scene_.sensors, frames_, all,
      {{"Tracks", "time [s]", "tracks", {confirmed_, tentative_}},
       {"Bearings of a scan", "time [s]", "bearings", {bearings_, clutter_}}});
}

}  // namespace scanfuse::app
