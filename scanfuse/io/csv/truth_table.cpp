#include <map>

#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"

namespace scanfuse::io {
namespace {

enum TruthColumn : std::size_t {
  kTruthFrame,
  kTruthTime,
  kTruthId,
  kTruthClass,
  kTruthX,
  kTruthY,
  kTruthZ,
  kTruthHeading,
  kTruthVx,
  kTruthVy,
  kTruthLength,
  kTruthWidth,
  kTruthHeight,
  kTruthVisible,
  kTruthOccluded
};

const CsvColumns& truth_columns() {
  static const CsvColumns columns{"truth",
                                  {"frame", "time_s", "object_id", "class", "x_m", "y_m"},
                                  {"z_m", "heading_rad", "vx_m_per_s", "vy_m_per_s", "length_m",
                                   "width_m", "height_m", "visible_points", "occluded"}};
  return columns;
}

std::optional<double> optional_metres(CsvTable& table, std::size_t column) {
  if (table.empty(column)) return std::nullopt;
  return table.metres(column);
}

TruthObject read_truth_object(CsvTable& table, Diagnostics& diagnostics) {
  TruthObject object;
  object.id = table.whole(kTruthId);
  object.object_class = class_of(table.text(kTruthClass), table.where(), diagnostics);
  object.position_m = {table.metres(kTruthX), table.metres(kTruthY)};
  object.z_m = table.metres(kTruthZ);
  object.heading_rad = optional_metres(table, kTruthHeading);
  const auto vx = optional_metres(table, kTruthVx), vy = optional_metres(table, kTruthVy);
  if (vx && vy) object.velocity_m_per_s = Eigen::Vector2d(*vx, *vy);
  object.length_m = optional_metres(table, kTruthLength);
  object.width_m = optional_metres(table, kTruthWidth);
  object.height_m = optional_metres(table, kTruthHeight);
  if (!table.empty(kTruthVisible)) {
    const std::int64_t points = table.whole(kTruthVisible);
    if (points < 0 || points > INT32_MAX) table.reject(kTruthVisible, "is no count");
    object.visible_points = static_cast<int>(points);
  }
  object.occluded = optional_metres(table, kTruthOccluded);
  return object;
}

std::string truth_cell(const std::optional<double>& value) {
  return value ? print_number(*value) : std::string{};
}

}  // namespace

Result<std::vector<TruthFrame>> read_truth_table(LineReader lines, Diagnostics& diagnostics) {
  auto table = CsvTable::open(std::move(lines), truth_columns(), diagnostics);
  if (!table) return tl::unexpected(table.error());
  std::map<std::int64_t, TruthFrame> frames;
  while (table->next_row(diagnostics)) {
    const std::int64_t number = table->whole(kTruthFrame);
    const Time stamp = table->time(kTruthTime);
    TruthObject object = read_truth_object(*table, diagnostics);
    if (!table->row_is_good(diagnostics)) continue;
    auto [place, fresh] = frames.try_emplace(number);
    TruthFrame& frame = place->second;
    if (fresh) {
      frame.stamp = stamp;
      frame.frame = number;
    } else if (frame.stamp != stamp) {
      diagnostics.note("times differ within a frame, the first counts", table->where());
    }
    frame.objects.push_back(std::move(object));
  }
  if (frames.empty()) return table->nothing_found("truth");
  std::vector<TruthFrame> in_order;
  in_order.reserve(frames.size());
  for (auto& [number, frame] : frames) in_order.push_back(std::move(frame));
  return in_order;
}

std::string truth_header() {
  return "frame,time_s,object_id,class,x_m,y_m,z_m,heading_rad,vx_m_per_s,vy_m_per_s,length_m,"
         "width_m,height_m,visible_points,occluded\n";
}

std::string truth_rows(const TruthFrame& frame) {
  std::string rows;
  for (const TruthObject& o : frame.objects) {
    const auto& v = o.velocity_m_per_s;
    rows += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", frame.frame, print_seconds(frame.stamp),
        o.id, to_string(o.object_class), print_number(o.position_m.x()),
        print_number(o.position_m.y()), print_number(o.z_m), truth_cell(o.heading_rad),
        v ? print_number(v->x()) : "", v ? print_number(v->y()) : "", truth_cell(o.length_m),
        truth_cell(o.width_m), truth_cell(o.height_m),
        o.visible_points ? std::to_string(*o.visible_points) : "", truth_cell(o.occluded));
  }
  return rows;
}

}  // namespace scanfuse::io
