#pragma once

#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/types/turntable.hpp"

/// The rig of [Liu2023, sec. 3] as a world with known truth: what a feature simulator, an image
/// renderer and a scan simulator all look at. Camera frame, metres.
namespace scanfuse::simulate {

/// How the lidar sits on the turntable. Named mountings of interest: radius_m = 0 (the lidar's
/// centre on the axis), axis_tilt_rad = pi/2 (the axis along the scan plane's normal, so that the
/// stripe does not move), beam_zero_rad = pi/2 (x along the axis, where [Liu2023, eq. 25] has no
/// answer), lateral_m = 0 (the camera's centre close to the scan plane).
struct TurntableWorldOptions {
  double radius_m = 0.08;
  double lateral_m = 0.30;
  double scan_roll_rad = 0.03;
  double axis_tilt_rad = 0.03;
  double beam_zero_rad = 0;
  bool reversed = false;
  double first_turntable_rad = 0;
  double step_rad = radians(0.25);
  int positions = 87;
  double beam_step_rad = radians(0.0833);
  double field_of_view_rad = radians(70);

  static constexpr auto fields() {
    using O = TurntableWorldOptions;
    return std::tuple{
        Field{"radius_m", &O::radius_m, 0.0, 0.5, "from the axis to the lidar's centre"},
        Field{"lateral_m", &O::lateral_m, -0.6, 0.6, "of the lidar, to the right of the camera"},
        Field{"scan_roll_rad", &O::scan_roll_rad, -0.3, 0.3,
              "of the scan plane, out of the vertical"},
        Field{"axis_tilt_rad", &O::axis_tilt_rad, -kPi, kPi,
              "of the axis, out of the scan plane; pi/2: along its normal"},
        Field{"beam_zero_rad", &O::beam_zero_rad, -kPi, kPi,
              "angle that the lidar gives to the beam straight ahead"},
        Field{"reversed", &O::reversed, "the turntable turns the other way"},
        Field{"first_turntable_rad", &O::first_turntable_rad, -kPi, kPi,
              "angle of the first position"},
        Field{"step_rad", &O::step_rad, -0.2, 0.2, "from position to position"},
        Field{"positions", &O::positions, 1, 100000, "how many"},
        Field{"beam_step_rad", &O::beam_step_rad, 1e-5, 0.1, "from beam to beam"},
        Field{"field_of_view_rad", &O::field_of_view_rad, 0.05, kPi, "of the lidar"}};
  }
};

/// A piece of the plane z = 0 of a frame of its own: a board, a bar of its frame, a wall.
struct WorldRectangle {
  Pose3 camera_from_rectangle;
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_m = Eigen::Vector2d::Zero();
};

/// What stands in front of the camera.
struct TurntableWorld {
  Camera camera;
  std::array<BoardSpec, 2> boards;
  std::array<Pose3, 2> camera_from_board;  ///< board frame as BoardSpec says
  double margin_m = 0.01;                  ///< white, around the outer squares
  std::vector<WorldRectangle> surroundings;
  Rig rig;                            ///< truth; its covariance is zero
  std::vector<double> turntable_rad;  ///< commanded
  double first_beam_rad = 0;
  double beam_step_rad = 0;
  int beams = 0;

  /// Board `b` with its margin.
  [[nodiscard]] WorldRectangle board_rectangle(std::size_t b) const;
  /// Which square of a board a point of its plane lies on: 0 or 1, like the squares of a
  /// chessboard, the square between the first four corners being 1 (black); -1 off the squares.
  [[nodiscard]] int square_at(std::size_t b, const Eigen::Vector2d& point_board) const;
};

/// Distance along a unit ray to the front or back of a rectangle; NaN where it is missed.
[[nodiscard]] double distance_to(const WorldRectangle& rectangle, const Eigen::Vector3d& origin,
                                 const Eigen::Vector3d& ray);

/// The layout, which the paper does not state: camera of [Liu2023, sec. 3.1] (12 mm lens, 1624 x
/// 1234); two boards of 14 x 20 corners of 20 mm, one above the other, a V of 120 degrees whose
/// ridge lies 1.5 m before the camera; the lidar 0.65 m before the camera's centre and 0.3 m to its
/// right, its scan plane upright, 0.8 to 1 m from the boards; the axis upright behind it. Board 0
/// is the upper one and is met at the lower scan angles. Angles run over 87 positions of 0.25
/// degrees, in which both boards carry a stripe; a wall, bars and a post stand around them.
[[nodiscard]] TurntableWorld turntable_world(const TurntableWorldOptions& options = {});

}  // namespace scanfuse::simulate
