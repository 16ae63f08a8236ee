#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/truth.hpp"

/// Detections without a lidar: what trackers alone are measured on.
namespace scanfuse::simulate {

/// A box that moves in the plane. World frame, m and m/s.
struct Mover {
  Eigen::Vector2d start_m;
  Eigen::Vector2d velocity_m_per_s;
  ObjectClass object_class = ObjectClass::kVehicle;
  double length_m = 4.4;
  double width_m = 1.8;
  /// Acceleration at a time after the start, m/s^2.
  std::function<Eigen::Vector2d(double)> accel = [](double) { return Eigen::Vector2d(0, 0); };
};

struct SceneOptions {
  int frames = 100;
  double dt_s = 0.08;
  double sigma_m = 0.15;
  double detection_probability = 0.95;
  double clutter_per_frame = 0.3;  ///< detections of nothing, uniform over the field, mean number
  double half_field_m = 30;
};

struct SceneFrame {
  Time stamp;
  std::vector<Eigen::Vector4d> truth;  ///< x, vx, y, vy of each mover
  std::vector<Detection> detections;   ///< in random order
};

/// A detection of the whole box, placed to `sigma_m`.
[[nodiscard]] Detection box_detection(const Eigen::Vector2d& centre, double heading_rad,
                                      const Mover& mover, double sigma_m);

/// A detection of the truth object itself, without an error; nothing when truth lacks its box.
[[nodiscard]] std::optional<Detection> perfect_detection(const TruthObject& object);

/// The same movers, options and seed: the same frames.
[[nodiscard]] std::vector<SceneFrame> play(const std::vector<Mover>& movers,
                                           const SceneOptions& options, std::uint64_t seed);

/// A situation that tempts a tracker to change identities.
struct SetPiece {
  const char* name;
  std::vector<Mover> movers;
  double allowed;  ///< identity changes a run
};

/// Two cars side by side 3 m apart, two crossing at 90 degrees, opposed pedestrians and two
/// walking 0.7 m apart, an overtaking, five cars in line.
[[nodiscard]] std::vector<SetPiece> set_pieces();

}  // namespace scanfuse::simulate
