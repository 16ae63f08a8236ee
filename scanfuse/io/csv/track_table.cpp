#include <map>

#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"
#include "scanfuse/io/csv/track_rows.hpp"

namespace scanfuse::io {
namespace {

enum TrackColumn : std::size_t {
  kTrackFrame,
  kTrackTime,
  kTrackId,
  kTrackX,
  kTrackY,
  kTrackClass,
  kTrackProbability,
  kTrackStatus,
  kTrackZ,
  kTrackHeading,
  kTrackVx,
  kTrackVy,
  kTrackSpeed,
  kTrackAccel,
  kTrackYawRate,
  kTrackLength,
  kTrackWidth,
  kTrackHeight,
  kTrackVarX,
  kTrackCovXY,
  kTrackVarY,
  kTrackAge,
  kTrackMissed,
  kTrackMoving
};

const CsvColumns& track_columns() {
  static const CsvColumns columns{
      "tracks",
      {"frame", "time_s", "track_id", "x_m", "y_m"},
      {"class", "class_probability", "status", "z_m", "heading_rad", "vx_m_per_s", "vy_m_per_s",
       "speed_m_per_s", "accel_m_per_s2", "yaw_rate_rad_per_s", "length_m", "width_m", "height_m",
       "var_x_m2", "cov_xy_m2", "var_y_m2", "age_frames", "missed_frames", "moving_probability"}};
  return columns;
}

TrackStatus read_status(CsvTable& table) {
  if (table.empty(kTrackStatus)) return TrackStatus::kConfirmed;
  for (const auto& [name, status] : choices(TrackStatus{})) {
    if (table.text(kTrackStatus) == name) return status;
  }
  table.reject(kTrackStatus, "is none of tentative, confirmed, coasting");
  return TrackStatus::kTentative;
}

int read_count(CsvTable& table, std::size_t column) {
  const std::int64_t value = table.whole(column);
  if (value < 0 || value > INT32_MAX) table.reject(column, "is no count");
  return static_cast<int>(value);
}

double read_probability(CsvTable& table, std::size_t column, double unknown) {
  const double value = table.number(column, unknown);
  if (!(value >= 0 && value <= 1)) table.reject(column, "is no probability");
  return value;
}

void read_track_state(CsvTable& table, Track& track) {
  track.state.mean << track.box.centre_m.x(), table.metres(kTrackVx), track.box.centre_m.y(),
      table.metres(kTrackVy);
  const double var_x = table.number(kTrackVarX, 1), var_y = table.number(kTrackVarY, 1);
  const double cov_xy = table.number(kTrackCovXY);
  if (!(var_x >= 0)) table.reject(kTrackVarX, "is no variance");
  if (!(var_y >= 0)) table.reject(kTrackVarY, "is no variance");
  if (cov_xy * cov_xy > var_x * var_y * (1 + 1e-9)) table.reject(kTrackCovXY, "is no covariance");
  track.state.covariance(0, 0) = var_x;
  track.state.covariance(2, 2) = var_y;
  track.state.covariance(0, 2) = track.state.covariance(2, 0) = cov_xy;
  const double speed = std::hypot(track.state.mean(1), track.state.mean(3));
  track.speed_m_per_s = table.metres(kTrackSpeed, speed);
  track.accel_m_per_s2 = table.metres(kTrackAccel);
  track.yaw_rate_rad_per_s = table.metres(kTrackYawRate);
}

Track read_track(CsvTable& table, Diagnostics& diagnostics) {
  Track track;
  track.id = table.whole(kTrackId);
  track.object_class = class_of(table.text(kTrackClass), table.where(), diagnostics);
  track.class_probability = table.number(kTrackProbability, 1);
  track.status = read_status(table);
  track.box = {{table.metres(kTrackX), table.metres(kTrackY)},
               table.number(kTrackHeading),
               table.metres(kTrackLength),
               table.metres(kTrackWidth)};
  track.z_m = table.metres(kTrackZ);
  track.height_m = table.metres(kTrackHeight);
  read_track_state(table, track);
  track.age_frames = read_count(table, kTrackAge);
  track.missed_frames = read_count(table, kTrackMissed);
  track.moving_probability = read_probability(table, kTrackMoving, 0.5);
  return track;
}

}  // namespace

ObjectClass class_of(std::string_view text, const std::string& where, Diagnostics& diagnostics) {
  if (text.empty()) return ObjectClass::kUnknown;
  if (const auto known = object_class_from(text)) return *known;
  diagnostics.note("unknown class taken as 'other'", fmt::format("{}: '{:.40}'", where, text));
  return ObjectClass::kOther;
}

Result<std::vector<StepResult>> read_track_table(LineReader lines, Diagnostics& diagnostics) {
  auto table = CsvTable::open(std::move(lines), track_columns(), diagnostics);
  if (!table) return tl::unexpected(table.error());
  std::map<std::pair<std::int64_t, Time>, StepResult> steps;
  while (table->next_row(diagnostics)) {
    const std::int64_t frame = table->whole(kTrackFrame);
    const Time stamp = table->time(kTrackTime);
    Track track = read_track(*table, diagnostics);
    if (!table->row_is_good(diagnostics)) continue;
    StepResult& step = steps[{frame, stamp}];
    step.frame = frame;
    step.stamp = stamp;
    step.tracks.push_back(std::move(track));
  }
  // A run that confirmed nothing is a table without rows, and no fault.
  if (steps.empty() && !table->first_fault().empty()) return table->nothing_found("tracks");
  std::vector<StepResult> in_order;
  in_order.reserve(steps.size());
  for (auto& [key, step] : steps) in_order.push_back(std::move(step));
  return in_order;
}

}  // namespace scanfuse::io
