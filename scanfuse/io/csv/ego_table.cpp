#include <algorithm>

#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"

namespace scanfuse::io {
namespace {

enum EgoColumn : std::size_t { kEgoTime, kEgoX, kEgoY, kEgoHeading, kEgoZ, kEgoSpeed, kEgoYawRate };

const CsvColumns& ego_columns() {
  static const CsvColumns columns{"ego motion",
                                  {"time_s", "x_m", "y_m", "heading_rad"},
                                  {"z_m", "speed_m_per_s", "yaw_rate_rad_per_s"}};
  return columns;
}

PoseSample read_ego_row(CsvTable& table) {
  PoseSample sample;
  sample.stamp = table.time(kEgoTime);
  sample.frame_id = "world";
  sample.child_frame_id = "ego";
  sample.pose = Pose3::from_planar(
      {table.metres(kEgoX), table.metres(kEgoY), table.metres(kEgoHeading)}, table.metres(kEgoZ));
  if (!table.empty(kEgoSpeed)) sample.speed_m_per_s = table.metres(kEgoSpeed);
  if (!table.empty(kEgoYawRate)) sample.yaw_rate_rad_per_s = table.metres(kEgoYawRate);
  return sample;
}

}  // namespace

Result<std::vector<PoseSample>> read_ego_table(LineReader lines, Diagnostics& diagnostics) {
  auto table = CsvTable::open(std::move(lines), ego_columns(), diagnostics);
  if (!table) return tl::unexpected(table.error());
  std::vector<PoseSample> poses;
  while (table->next_row(diagnostics)) {
    PoseSample sample = read_ego_row(*table);
    if (!table->row_is_good(diagnostics)) continue;
    if (!poses.empty() && sample.stamp < poses.back().stamp) {
      diagnostics.note("ego motion out of order, sorted", table->where());
    }
    poses.push_back(std::move(sample));
  }
  if (poses.empty()) return table->nothing_found("ego motion");
  std::stable_sort(poses.begin(), poses.end(),
                   [](const PoseSample& a, const PoseSample& b) { return a.stamp < b.stamp; });
  return poses;
}

std::string ego_header() {
  return "time_s,x_m,y_m,heading_rad,z_m,speed_m_per_s,yaw_rate_rad_per_s\n";
}

std::string ego_row(const PoseSample& sample) {
  const Pose2 planar = sample.pose.planar();
  const auto cell = [](const std::optional<double>& value) {
    return value ? print_number(*value) : std::string{};
  };
  return fmt::format("{},{},{},{},{},{},{}\n", print_seconds(sample.stamp),
                     print_number(planar.x_m), print_number(planar.y_m),
                     print_number(planar.heading_rad), print_number(sample.pose.translation_m.z()),
                     cell(sample.speed_m_per_s), cell(sample.yaw_rate_rad_per_s));
}

}  // namespace scanfuse::io
