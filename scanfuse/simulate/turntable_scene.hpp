#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "scanfuse/simulate/turntable_world.hpp"

namespace scanfuse::simulate {

/// A flat disc, the target of [Liu2023, sec. 3.2]: its plane is z = 0 of its frame.
struct WorldDisc {
  Pose3 camera_from_disc;
  double radius_m = 0.07;
  double albedo = 0.6;
};

/// How light the things of a turntable world are.
struct SceneAlbedo {
  double white = 0.85;
  double black = 0.06;
  double rest = 0.35;  ///< wall, bars, post
};

/// A turntable world as rays meet it. All of it is flat, so a ray is cut with a dozen planes in
/// closed form, exact to the last digit of a double, which what is measured in hundredths of a
/// pixel needs. With a disc, boards and bars are gone and only the first of the surroundings, the
/// wall, stands behind it.
class TurntableScene {
 public:
  explicit TurntableScene(const TurntableWorld& world, const SceneAlbedo& albedo = {},
                          const WorldDisc* disc = nullptr);

  struct Hit {
    double distance_m = 0;
    int surface = -1;  ///< 0 and 1: boards; -1: nothing
  };
  /// The nearest thing along a unit ray, camera frame.
  [[nodiscard]] Hit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) const;
  /// Whether nothing stands between two points, both of which may lie on surfaces.
  [[nodiscard]] bool sees(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Share of light that a point of a surface throws back; on boards the mean over a box of
  /// `spread_m` (half lengths along the board's x and y), so that borders are sharp but not jagged.
  [[nodiscard]] double albedo(int surface, const Eigen::Vector3d& point,
                              const Eigen::Vector2d& spread_m) const;
  [[nodiscard]] Eigen::Vector3d normal(int surface) const;

 private:
  struct Surface {
    Eigen::Vector3d origin, x, y, normal;  ///< of its frame
    Eigen::Vector2d low, high;
    double radius_m = 0;  ///< a disc where > 0
    double albedo = 0;
  };
  [[nodiscard]] double distance(const Surface& surface, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& ray) const;
  [[nodiscard]] static Surface surface_of(const WorldRectangle& rectangle, double albedo);

  std::array<BoardSpec, 2> boards_;
  SceneAlbedo albedo_;
  std::vector<Surface> surfaces_;
};

}  // namespace scanfuse::simulate
