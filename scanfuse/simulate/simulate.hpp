#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/simulate/sensor_model.hpp"
#include "scanfuse/types/ego.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::simulate {

struct SimulateOptions {
  SensorPreset sensor = SensorPreset::kLux;
  int frames = 0;
  double range_noise_m = -1;
  double dropout = 0.005;
  double divergence = 1;
  double vibration = 1;
  double height_m = 0;

  static constexpr auto fields() {
    using O = SimulateOptions;
    return std::tuple{
        Field{"sensor", &O::sensor, "which lidar"},
        Field{"frames", &O::frames, 0, 1000000, "scans to make; 0: as long as the scenario is"},
        Field{"range_noise_m", &O::range_noise_m, -1.0, 10.0,
              "standard deviation of a range; negative: the sensor's own"},
        Field{"dropout", &O::dropout, 0.0, 1.0, "share of the beams that are lost for no reason"},
        Field{"divergence", &O::divergence, 0.0, 10.0,
              "beam width as a multiple of the sensor's own; 0: lines"},
        Field{"vibration", &O::vibration, 0.0, 20.0,
              "pitch, roll and heave of the ego car, as a multiple of the usual (about 0.25 deg)"},
        Field{"height_m", &O::height_m, 0.0, 10.0,
              "of the sensor above the ground; 0: where it usually is"},
    };
  }
};

/// What a return came from. A return whose light comes from several things, none with four fifths
/// of it, is mixed.
inline constexpr std::int32_t kBackground = 0;
inline constexpr std::int32_t kGround = -1;
inline constexpr std::int32_t kMixed = -2;

struct SimulatedFrame {
  Scan scan;
  TruthFrame truth;  ///< world frame, at the scan's stamp; `occluded` is the share of the centre
                     ///< rays through the object's box that something else stopped before it
  PoseSample ego;    ///< world_from_ego at the scan's stamp, as level odometry tells it
  std::vector<std::int32_t>
      label;  ///< per return: id of the truth object (> 0), or one of the above
};

/// A scenario, scan after scan. World frame: the ego frame (rear axle, on the ground) at time 0.
/// The stamp of a scan is that of its first beam; each beam meets the world, and leaves the sensor,
/// where they are when it is fired (`Return::time_offset_s`), nothing is de-skewed.
/// Same scenario, seed and options: same bytes.
class Simulation {
 public:
  /// An unknown scenario is an error that names the nearest known one.
  [[nodiscard]] static Result<Simulation> create(std::string_view scenario, std::uint64_t seed,
                                                 const SimulateOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  [[nodiscard]] std::optional<SimulatedFrame> next();
  /// As `next`, without measuring: no returns, and truth that does not say what is seen of it.
  [[nodiscard]] std::optional<SimulatedFrame> next_truth();
  [[nodiscard]] Pose3 ego_from_sensor() const;
  [[nodiscard]] int frames() const;
  [[nodiscard]] const SensorModel& sensor() const;

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

struct ScenarioInfo {
  std::string_view name;
  std::string_view doc;
};
[[nodiscard]] std::vector<ScenarioInfo> scenarios();

}  // namespace scanfuse::simulate
