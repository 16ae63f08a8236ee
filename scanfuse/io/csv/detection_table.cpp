#include <array>
#include <map>

#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"

namespace scanfuse::io {
namespace {

enum DetectionColumn : std::size_t {
  kDetFrame,
  kDetTime,
  kDetClass,
  kDetX,
  kDetY,
  kDetScore,
  kDetZ,
  kDetHeading,
  kDetLength,
  kDetWidth,
  kDetHeight,
  kDetVarX,
  kDetCovXY,
  kDetVarY,
  kDetCovXHeading,
  kDetCovYHeading,
  kDetVarHeading,
  kDetVarLength,
  kDetVarWidth,
  kDetLengthSeen,
  kDetWidthSeen,
  kDetFaces,
  kDetLeftOccluded,
  kDetRightOccluded,
  kDetPoints,
  kDetFromX,
  kDetFromY,
  kDetMiddleX,
  kDetMiddleY,
  kDetSensor
};

const CsvColumns& detection_columns() {
  static const CsvColumns columns{"detections",
                                  {"frame", "time_s", "class", "x_m", "y_m"},
                                  {"score",
                                   "z_m",
                                   "heading_rad",
                                   "length_m",
                                   "width_m",
                                   "height_m",
                                   "var_x_m2",
                                   "cov_xy_m2",
                                   "var_y_m2",
                                   "cov_x_heading_m_rad",
                                   "cov_y_heading_m_rad",
                                   "var_heading_rad2",
                                   "var_length_m2",
                                   "var_width_m2",
                                   "length_seen",
                                   "width_seen",
                                   "faces_seen",
                                   "left_end_occluded",
                                   "right_end_occluded",
                                   "points",
                                   "seen_from_x_m",
                                   "seen_from_y_m",
                                   "visible_middle_x_m",
                                   "visible_middle_y_m",
                                   "sensor"}};
  return columns;
}

bool read_flag(CsvTable& table, std::size_t column) {
  const std::int64_t value = table.whole(column);
  if (value != 0 && value != 1) table.reject(column, "is neither 0 nor 1");
  return value == 1;
}

double read_variance(CsvTable& table, std::size_t column, double fallback) {
  const double value = table.metres(column, fallback);
  if (!(value >= 0)) table.reject(column, "is no variance");
  return value;
}

void read_covariance(CsvTable& table, Detection& detection) {
  auto& P = detection.covariance;
  const double sigma_heading = table.empty(kDetHeading) ? 1.8 : 0.2;
  P.setZero();
  P(0, 0) = read_variance(table, kDetVarX, 0.09);
  P(1, 1) = read_variance(table, kDetVarY, 0.09);
  P(2, 2) = read_variance(table, kDetVarHeading, sigma_heading * sigma_heading);
  P(0, 1) = P(1, 0) = table.metres(kDetCovXY);
  P(0, 2) = P(2, 0) = table.metres(kDetCovXHeading);
  P(1, 2) = P(2, 1) = table.metres(kDetCovYHeading);
  const double slack = 1e-9 * P(0, 0) * P(1, 1) * P(2, 2);
  if (P(0, 1) * P(0, 1) > P(0, 0) * P(1, 1) || P.determinant() < -slack) {
    table.reject(kDetCovXY, "makes no covariance with the variances");
  }
}

Detection read_detection(CsvTable& table, Diagnostics& diagnostics) {
  Detection detection;
  detection.object_class = class_of(table.text(kDetClass), table.where(), diagnostics);
  detection.score = table.number(kDetScore, 1);
  if (!(detection.score >= 0 && detection.score <= 1)) table.reject(kDetScore, "is outside 0 .. 1");
  detection.box = {{table.metres(kDetX), table.metres(kDetY)},
                   table.metres(kDetHeading),
                   table.metres(kDetLength),
                   table.metres(kDetWidth)};
  if (detection.box.length_m < 0) table.reject(kDetLength, "is negative");
  if (detection.box.width_m < 0) table.reject(kDetWidth, "is negative");
  detection.z_m = table.metres(kDetZ);
  detection.height_m = table.metres(kDetHeight);
  read_covariance(table, detection);
  detection.var_length_m2 = read_variance(table, kDetVarLength, 1);
  detection.var_width_m2 = read_variance(table, kDetVarWidth, 1);
  detection.length_seen = read_flag(table, kDetLengthSeen);
  detection.width_seen = read_flag(table, kDetWidthSeen);
  detection.faces_seen = static_cast<int>(table.whole(kDetFaces));
  if (detection.faces_seen < 0 || detection.faces_seen > 2) table.reject(kDetFaces, "is not 0..2");
  detection.left_end_occluded = read_flag(table, kDetLeftOccluded);
  detection.right_end_occluded = read_flag(table, kDetRightOccluded);
  const std::int64_t points = table.whole(kDetPoints);
  if (points < 0 || points > INT32_MAX) table.reject(kDetPoints, "is no count");
  detection.points = static_cast<int>(points);
  detection.seen_from_m = {table.metres(kDetFromX), table.metres(kDetFromY)};
  detection.visible_middle_m = {table.metres(kDetMiddleX, detection.box.centre_m.x()),
                                table.metres(kDetMiddleY, detection.box.centre_m.y())};
  return detection;
}

std::string detection_row(const DetectionFrame& frame, const Detection& d) {
  const auto& P = d.covariance;
  const std::array numbers = {d.score,
                              d.box.centre_m.x(),
                              d.box.centre_m.y(),
                              d.z_m,
                              d.box.heading_rad,
                              d.box.length_m,
                              d.box.width_m,
                              d.height_m,
                              P(0, 0),
                              P(0, 1),
                              P(1, 1),
                              P(0, 2),
                              P(1, 2),
                              P(2, 2),
                              d.var_length_m2,
                              d.var_width_m2,
                              d.seen_from_m.x(),
                              d.seen_from_m.y(),
                              d.visible_middle_m.x(),
                              d.visible_middle_m.y()};
  std::string row = fmt::format("{},{},{},{}", frame.frame, print_seconds(frame.stamp),
                                frame.sensor, to_string(d.object_class));
  for (const double number : numbers) row += "," + print_number(number);
  return row + fmt::format(",{},{},{},{},{},{}\n", d.length_seen ? 1 : 0, d.width_seen ? 1 : 0,
                           d.faces_seen, d.left_end_occluded ? 1 : 0, d.right_end_occluded ? 1 : 0,
                           d.points);
}

}  // namespace

Result<std::vector<DetectionFrame>> read_detection_table(LineReader lines,
                                                         Diagnostics& diagnostics) {
  auto table = CsvTable::open(std::move(lines), detection_columns(), diagnostics);
  if (!table) return tl::unexpected(table.error());
  std::map<std::tuple<std::int64_t, Time, std::string>, DetectionFrame> frames;
  while (table->next_row(diagnostics)) {
    const std::int64_t number = table->whole(kDetFrame);
    const Time stamp = table->time(kDetTime);
    const bool nothing_seen = table->empty(kDetX) && table->empty(kDetY);
    const Detection detection = nothing_seen ? Detection{} : read_detection(*table, diagnostics);
    if (!table->row_is_good(diagnostics)) continue;
    const std::string sensor(table->text(kDetSensor));
    DetectionFrame& frame = frames[{number, stamp, sensor}];
    frame.stamp = stamp;
    frame.frame = number;
    frame.sensor = sensor;
    if (!nothing_seen) frame.detections.push_back(detection);
  }
  if (frames.empty()) return table->nothing_found("detections");
  std::vector<DetectionFrame> in_order;
  in_order.reserve(frames.size());
  for (auto& [key, frame] : frames) in_order.push_back(std::move(frame));
  return in_order;
}

std::string detection_header() {
  return "frame,time_s,sensor,class,score,x_m,y_m,z_m,heading_rad,length_m,width_m,height_m,"
         "var_x_m2,cov_xy_m2,var_y_m2,cov_x_heading_m_rad,cov_y_heading_m_rad,var_heading_rad2,"
         "var_length_m2,var_width_m2,seen_from_x_m,seen_from_y_m,visible_middle_x_m,"
         "visible_middle_y_m,length_seen,width_seen,faces_seen,left_end_occluded,"
         "right_end_occluded,points\n";
}

std::string detection_rows(const DetectionFrame& frame) {
  if (frame.detections.empty()) {
    return fmt::format("{},{},{},{}\n", frame.frame, print_seconds(frame.stamp), frame.sensor,
                       std::string(26, ','));
  }
  std::string rows;
  for (const Detection& detection : frame.detections) rows += detection_row(frame, detection);
  return rows;
}

}  // namespace scanfuse::io
