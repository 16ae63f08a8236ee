#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scanfuse/simulate/caster.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::simulate {

/// The returns of one sweep, and what each beam met.
struct Sweep {
  std::vector<Return> returns;
  std::vector<std::int32_t> label;  ///< as SimulatedFrame::label
  std::vector<int> visible_points;  ///< per actor
  std::vector<double> occluded;     ///< per actor
};

/// Measures the world as a lidar does: several rays a beam, echoes from what they hit, noise.
class Scanner {
 public:
  Scanner(const World& world, const SensorModel& model, const SimulateOptions& options,
          std::uint64_t seed);
  [[nodiscard]] Sweep scan(std::int64_t frame);
  [[nodiscard]] const SensorModel& model() const { return model_; }
  [[nodiscard]] double stamp_s(std::int64_t frame) const {
    return static_cast<double>(frame) / model_.rate_hz;
  }

 private:
  struct Beam {
    int column = 0;
    int layer = 0;
  };
  void aim(double stamp_s);
  void receive(std::size_t beam, std::span<const Hit> hits, std::int64_t frame,
               RandomStream& random, Sweep& sweep) const;
  void judge_occlusion(std::span<const Hit> hits, double stamp_s, Sweep& sweep) const;

  const World* world_;
  SensorModel model_;
  SimulateOptions options_;
  std::uint64_t seed_;
  Vibration vibration_;
  std::optional<Caster> caster_;  ///< made at the first scan
  std::vector<Beam> beams_;
  std::vector<Ray> rays_;  ///< kRaysPerBeam for each beam
};

}  // namespace scanfuse::simulate
