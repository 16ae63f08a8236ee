#include "scanfuse/simulate/turntable_world.hpp"

namespace scanfuse::simulate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRidgeDepth_m = 1.5;
constexpr double kRidgeGap_m = 0.03;  ///< from the ridge to the nearest corner of either board
constexpr double kHalfV_rad = radians(60);
constexpr double kYaw_rad = radians(10);  ///< of the V, towards the lidar

Camera camera_of_paper() {
  Camera camera;
  camera.width_px = 1624;
  camera.height_px = 1234;
  camera.fx_px = 2757.4;
  camera.fy_px = 2758.6;
  camera.cx_px = 831.6;
  camera.cy_px = 638.9;
  camera.k1 = -0.076;
  camera.k2 = 0.371;
  return camera;
}

Matrix3d axes(const Vector3d& x, const Vector3d& y) {
  Matrix3d R;
  R << x, y, x.cross(y);
  return R;
}

/// Camera from a frame whose x runs along the ridge and whose -z looks out of the V.
Pose3 camera_from_v() {
  return {Quaterniond(AngleAxisd(-kYaw_rad, Vector3d::UnitY())), {0, 0, kRidgeDepth_m}};
}

/// Boards as if seen upright: rows run to the right, columns downwards.
std::array<Pose3, 2> boards_in_v(const BoardSpec& board) {
  const double width = (board.columns - 1) * board.square_m;
  const double height = (board.rows - 1) * board.square_m;
  const double s = std::sin(kHalfV_rad), c = std::cos(kHalfV_rad);
  const Vector3d down_upper(0, s, c), down_lower(0, s, -c);  // rows of corners, from top to bottom
  const auto pose = [&](const Vector3d& down, double from_ridge) {
    return Pose3{Quaterniond(axes(Vector3d::UnitX(), down)),
                 Vector3d(-width / 2, 0, 0) + from_ridge * down};
  };
  return {pose(down_upper, -kRidgeGap_m - height), pose(down_lower, kRidgeGap_m)};
}

/// The lidar in the middle of its arc, looking at the middle of the V.
Pose3 middle_pose(const TurntableWorldOptions& options) {
  const Vector3d centre(options.lateral_m, 0.02, 0.62);
  const Vector3d ahead = (Vector3d(0.012, 0, kRidgeDepth_m - 0.07) - centre).normalized();
  const Vector3d side = ahead.cross(Vector3d::UnitY()).normalized();
  const Vector3d down = side.cross(ahead);
  const Vector3d y = AngleAxisd(options.scan_roll_rad, ahead) * down;
  const AngleAxisd zero(-options.beam_zero_rad, Vector3d::UnitZ());
  return {Quaterniond(axes(ahead, y) * zero), centre};
}

Rig rig_of(const TurntableWorldOptions& options) {
  const Pose3 middle = middle_pose(options);
  const AngleAxisd zero(options.beam_zero_rad, Vector3d::UnitZ());
  const Matrix3d scan = (middle.rotation * zero).toRotationMatrix();  // x ahead, y down, z normal
  Rig rig;
  rig.axis_direction = -(AngleAxisd(options.axis_tilt_rad, scan.col(0)) * scan.col(1)).normalized();
  if (options.reversed) rig.axis_direction *= -1;
  const Vector3d n = rig.axis_direction;
  Vector3d arm = AngleAxisd(0.35, n) * scan.col(0);
  arm -= n * n.dot(arm);
  const Vector3d on_axis = middle.translation_m - options.radius_m * arm.normalized();
  rig.axis_point_m = on_axis - n * n.dot(on_axis);
  const double half =
      options.first_turntable_rad + options.step_rad * (options.positions - 1) / 2.0;
  const Quaterniond back(AngleAxisd(-half, n));
  const Pose3 about_axis{back, rig.axis_point_m - back * rig.axis_point_m};
  rig.camera_from_lidar = about_axis * middle;
  rig.first_turntable_rad =
      std::min(options.first_turntable_rad, 2 * half - options.first_turntable_rad);
  rig.last_turntable_rad =
      std::max(options.first_turntable_rad, 2 * half - options.first_turntable_rad);
  return rig;
}

/// A wall behind, the bars of the frame that holds the boards, a post beside them.
std::vector<WorldRectangle> surroundings_of(const Pose3& v) {
  const Quaterniond level = v.rotation;
  return {
      {{Quaterniond::Identity(), {0, 0, 2.4}}, {-3, -2}, {3, 2}},
      {v * Pose3{Quaterniond::Identity(), {0, -0.36, 0.02}}, {-0.35, -0.02}, {0.35, 0.02}},
      {v * Pose3{Quaterniond::Identity(), {0, 0.36, 0.02}}, {-0.35, -0.02}, {0.35, 0.02}},
      {{level, {0.62, 0, 1.2}}, {-0.03, -1}, {0.03, 1}},
  };
}

}  // namespace

WorldRectangle TurntableWorld::board_rectangle(std::size_t b) const {
  const BoardSpec& board = boards[b];
  const double edge = board.square_m + margin_m;
  return {camera_from_board[b],
          Vector2d::Constant(-edge),
          {(board.columns - 1) * board.square_m + edge, (board.rows - 1) * board.square_m + edge}};
}

int TurntableWorld::square_at(std::size_t b, const Vector2d& point_board) const {
  const BoardSpec& board = boards[b];
  const auto column = static_cast<int>(std::floor(point_board.x() / board.square_m));
  const auto row = static_cast<int>(std::floor(point_board.y() / board.square_m));
  const bool outside = column < -1 || row < -1 || column >= board.columns || row >= board.rows;
  return outside ? -1 : 1 - ((column + row) & 1);
}

double distance_to(const WorldRectangle& rectangle, const Vector3d& origin, const Vector3d& ray) {
  const Quaterniond back = rectangle.camera_from_rectangle.rotation.conjugate();
  const Vector3d from = back * (origin - rectangle.camera_from_rectangle.translation_m);
  const Vector3d along = back * ray;
  const double distance = -from.z() / along.z();
  const Vector2d hit = (from + distance * along).head<2>();
  const bool inside = (hit.array() >= rectangle.low_m.array()).all() &&
                      (hit.array() <= rectangle.high_m.array()).all();
  return inside && distance > 0 ? distance : std::numeric_limits<double>::quiet_NaN();
}

TurntableWorld turntable_world(const TurntableWorldOptions& options) {
  TurntableWorld world;
  world.camera = camera_of_paper();
  world.boards.fill({.rows = 14, .columns = 20, .square_m = 0.02});
  const Pose3 v = camera_from_v();
  const auto in_v = boards_in_v(world.boards[0]);
  world.camera_from_board = {v * in_v[0], v * in_v[1]};
  world.surroundings = surroundings_of(v);
  world.rig = rig_of(options);
  for (int i = 0; i < options.positions; ++i) {
    world.turntable_rad.push_back(options.first_turntable_rad + options.step_rad * i);
  }
  const double half = options.field_of_view_rad / 2;
  world.beam_step_rad = options.beam_step_rad;
  world.beams = 1 + static_cast<int>(2 * half / options.beam_step_rad);
  world.first_beam_rad = options.beam_zero_rad - (world.beams - 1) / 2.0 * options.beam_step_rad;
  return world;
}

}  // namespace scanfuse::simulate
