#include "scanfuse/io/csv/track_rows.hpp"

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

using TrackCells = std::array<std::string, kTrackColumns.size()>;

std::string_view status_name(TrackStatus status) {
  for (const auto& [name, choice] : choices(status)) {
    if (choice == status) return name;
  }
  return "tentative";
}

TrackCells track_cells(const StepResult& step, const Track& track) {
  const auto number = [](double value) { return print_number(value); };
  const auto& P = track.state.covariance;  // of x, vx, y, vy
  return {print_seconds(step.stamp),
          std::to_string(step.frame),
          std::to_string(track.id),
          std::string(to_string(track.object_class)),
          number(track.class_probability),
          std::string(status_name(track.status)),
          number(track.box.centre_m.x()),
          number(track.box.centre_m.y()),
          number(track.z_m),
          number(track.box.heading_rad),
          number(track.state.mean(1)),
          number(track.state.mean(3)),
          number(track.speed_m_per_s),
          number(track.accel_m_per_s2),
          number(track.yaw_rate_rad_per_s),
          number(track.box.length_m),
          number(track.box.width_m),
          number(track.height_m),
          number(P(0, 0)),
          number(P(0, 2)),
          number(P(2, 2)),
          std::to_string(track.age_frames),
          std::to_string(track.missed_frames),
          number(track.moving_probability)};
}

bool is_text_column(std::string_view name) { return name == "class" || name == "status"; }

}  // namespace

std::string track_header() {
  return fmt::format("{}\n", fmt::join(kTrackColumns.begin(), kTrackColumns.end(), ","));
}

std::string track_csv_rows(const StepResult& step) {
  std::string rows;
  for (const Track& track : step.tracks) {
    const TrackCells cells = track_cells(step, track);
    rows += fmt::format("{}\n", fmt::join(cells.begin(), cells.end(), ","));
  }
  return rows;
}

std::string track_json_rows(const StepResult& step) {
  std::string rows;
  for (const Track& track : step.tracks) {
    const TrackCells cells = track_cells(step, track);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      rows += fmt::format("{}\"{}\":", k == 0 ? '{' : ',', kTrackColumns[k]);
      if (is_text_column(kTrackColumns[k])) {
        rows += fmt::format("\"{}\"", cells[k]);
      } else {
        rows += cells[k].empty() ? "null" : cells[k];
      }
    }
    rows += "}\n";
  }
  return rows;
}

}  // namespace scanfuse::io
