#include "scanfuse/report/turntable_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scanfuse/report/svg_plot.hpp"

namespace scanfuse::report {
namespace {

constexpr std::size_t kMostCloudPoints = 6000;
constexpr std::size_t kMostReturns = 4000;

/// Millimetres are enough to draw.
std::string point_json(const Eigen::Vector3d& p) {
  return fmt::format("[{:.4f},{:.4f},{:.4f}]", p.x(), p.y(), p.z());
}

/// The scene's parts as they are written.
class SceneWriter {
 public:
  void line(const std::vector<Eigen::Vector3d>& points, std::string_view colour, double width,
            std::string_view label = "") {
    add("lines", points, colour, width, label);
  }
  void dots(const std::vector<Eigen::Vector3d>& points, std::string_view colour, double width) {
    if (!points.empty()) add("dots", points, colour, width, "");
  }
  [[nodiscard]] std::string json() const { return "[" + text_ + "]"; }

 private:
  void add(std::string_view kind, const std::vector<Eigen::Vector3d>& points,
           std::string_view colour, double width, std::string_view label) {
    if (std::ranges::any_of(points, [](const auto& p) { return !p.allFinite(); })) return;
    std::string list;
    for (const auto& p : points) list += (list.empty() ? "" : ",") + point_json(p);
    text_ += fmt::format(R"({}{{"k":"{}","c":"{}","w":{},"l":"{}","p":[{}]}})",
                         text_.empty() ? "" : ",", kind, colour, width, label, list);
  }
  std::string text_;
};

void add_camera(const Camera& camera, SceneWriter& scene) {
  if (!(camera.fx_px > 0)) return;
  const double depth = 0.15;
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    corners.emplace_back((u * camera.width_px - camera.cx_px) / camera.fx_px * depth,
                         (v * camera.height_px - camera.cy_px) / camera.fy_px * depth, depth);
  }
  corners.push_back(corners.front());
  scene.line(corners, "--ink", 1);
  for (std::size_t k = 0; k < 4; ++k) {
    scene.line({Eigen::Vector3d::Zero(), corners[k]}, "--ink", 1, k == 0 ? "camera" : "");
  }
}

void add_board(const BoardSpec& board, const Pose3& pose, int number, SceneWriter& scene) {
  const double side = board.square_m;
  const auto at = [&](double column, double row) {
    return pose * Eigen::Vector3d(column * side, row * side, 0);
  };
  const double right = board.columns, low = board.rows;
  for (int r = -1; r <= board.rows; ++r) {
    const bool edge = r == -1 || r == board.rows;
    scene.line({at(-1, r), at(right, r)}, edge ? "--s0" : "--line", edge ? 1.5 : 0.6,
               r == -1 ? fmt::format("board {}", number) : "");
  }
  for (int c = -1; c <= board.columns; ++c) {
    const bool edge = c == -1 || c == board.columns;
    scene.line({at(c, -1), at(c, low)}, edge ? "--s0" : "--line", edge ? 1.5 : 0.6);
  }
}

void add_rig(const Rig& rig, SceneWriter& scene) {
  const Eigen::Vector3d centre = rig.camera_from_lidar.translation_m;
  const Eigen::Vector3d n = rig.axis_direction;
  const Eigen::Vector3d foot = rig.axis_point_m + n * n.dot(centre - rig.axis_point_m);
  scene.line({foot - 0.4 * n, foot + 0.4 * n}, "--s1", 2.5, "turntable axis");
  scene.line({foot, centre}, "--s1", 1);
  std::vector<Eigen::Vector3d> path;
  const double first = rig.first_turntable_rad, last = rig.last_turntable_rad;
  for (int k = 0; k <= 40; ++k) {
    path.push_back(rig.pose(first + (last - first) * k / 40).translation_m);
  }
  scene.line(path, "--s2", 2, "lidar centre over the arc");
  const Pose3 pose = rig.pose((first + last) / 2);
  for (int axis = 0; axis < 3; ++axis) {
    scene.line({pose.translation_m, pose * Eigen::Vector3d(0.15 * Eigen::Vector3d::Unit(axis))},
               axis == 0   ? "--s1"
               : axis == 1 ? "--s2"
                           : "--s0",
               2,
               axis == 0   ? "lidar x"
               : axis == 1 ? "y"
                           : "z");
  }
}

std::vector<Eigen::Vector3d> board_returns(const TurntableReport& report) {
  std::size_t all = 0;
  for (const auto& position : report.positions) {
    all += position.returns[0].size() + position.returns[1].size();
  }
  const std::size_t stride = all / kMostReturns + 1;
  std::vector<Eigen::Vector3d> points;
  std::size_t count = 0;
  for (const auto& position : report.positions) {
    if (!position.used) continue;
    const Pose3 pose = report.rig.pose(position.turntable_rad + position.correction_rad);
    for (const auto& returns : position.returns) {
      for (const BeamReturn& beam : returns) {
        if (count++ % stride != 0) continue;
        const double range = beam.range_m - report.rig.range_bias_m;
        points.push_back(pose * Eigen::Vector3d(range * std::cos(beam.angle_rad),
                                                range * std::sin(beam.angle_rad), 0));
      }
    }
  }
  return points;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      three = three << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const bool pad = k + i > bytes.size();
      text += pad ? '=' : kDigits[three >> (18 - 6 * i) & 63];
    }
  }
  return text;
}

/// A picture under the points that were found in it.
std::string picture_svg(const ReportPicture& picture,
                        const std::array<std::vector<Eigen::Vector2d>, 2>& points,
                        std::size_t stride, double radius) {
  if (picture.png.empty()) return "<div class=\"blank\">no image</div>";
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {} {}\"><image width=\"100%\" height=\"100%\" "
      "href=\"data:image/png;base64,{}\"/>",
      picture.width_px, picture.height_px, base64(picture.png));
  for (std::size_t b = 0; b < 2; ++b) {
    svg += fmt::format("<path class=\"found{}\" stroke-width=\"{}\" d=\"", b, radius);
    for (std::size_t k = 0; k < points[b].size(); k += stride) {
      svg += fmt::format("M{:.1f} {:.1f}h0", points[b][k].x() / picture.scale,
                         points[b][k].y() / picture.scale);
    }
    svg += "\"/>";
  }
  return svg + "</svg>";
}

}  // namespace

std::string turntable_scene_json(const TurntableReport& report) {
  SceneWriter scene;
  add_camera(report.features.camera, scene);
  for (std::size_t b = 0; b < 2; ++b) {
    const BoardSpec& board = report.features.boards[b];
    if (board.rows <= 200 && board.columns <= 200) {
      add_board(board, report.camera_from_board[b], static_cast<int>(b), scene);
    }
  }
  scene.dots(board_returns(report), "--s3", 1.5);
  std::vector<Eigen::Vector3d> cloud;
  const std::size_t stride = report.cloud.points.size() / kMostCloudPoints + 1;
  for (std::size_t k = 0; k < report.cloud.points.size(); k += stride) {
    cloud.push_back(report.cloud.points[k].position_m);
  }
  scene.dots(cloud, "--s4", 1.5);
  add_rig(report.rig, scene);
  return scene.json();
}

std::string position_pictures(const TurntableReport& report) {
  std::string html;
  if (!report.board.png.empty()) {
    html += "<figure class=\"wide\">" +
            picture_svg(report.board, report.features.corners_px, 1, 3) +
            "<figcaption>boards and their corners</figcaption></figure>\n";
  }
  for (std::size_t k = 0; k < report.positions.size(); ++k) {
    const ReportedPosition& position = report.positions[k];
    if (position.picture.png.empty() && position.used) continue;
    html += fmt::format("<figure{}>", position.used ? "" : " class=\"bad\"");
    html += picture_svg(position.picture, report.features.positions[k].stripe_px, 8, 2);
    html += fmt::format("<figcaption>{} &middot; {:.2f}&deg;<br>{}</figcaption></figure>\n",
                        escape_html(position.name), degrees(position.turntable_rad),
                        position.used ? fmt::format("{:.2f}, {:.2f} px", position.stripe_px[0],
                                                    position.stripe_px[1])
                                      : "left out: " + escape_html(position.reason));
  }
  return html;
}

}  // namespace scanfuse::report
