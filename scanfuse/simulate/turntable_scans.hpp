#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/simulate/turntable_scene.hpp"
#include "scanfuse/simulate/turntable_world.hpp"

namespace scanfuse::simulate {

/// A 2D lidar of the kind that [Liu2023, sec. 3.1] used.
struct TurntableScanOptions {
  double range_noise_m = 0.001;
  double range_bias_m = 0;
  double square_bias_m = 0;
  double range_step_m = 0.0001;
  double spot_m = 0.002;
  double divergence_rad = 0.001;
  double resolved_m = 0.15;
  double farthest_m = 13;
  int spot_rays = 7;

  static constexpr auto fields() {
    using O = TurntableScanOptions;
    return std::tuple{
        Field{"range_noise_m", &O::range_noise_m, 0.0, 1.0, "standard deviation of a range"},
        Field{"range_bias_m", &O::range_bias_m, -1.0, 1.0, "added to every range"},
        Field{"square_bias_m", &O::square_bias_m, -1.0, 1.0,
              "added to ranges on black squares more than on white ones"},
        Field{"range_step_m", &O::range_step_m, 0.0, 0.1, "ranges are multiples of it; 0: any"},
        Field{"spot_m", &O::spot_m, 0.0, 0.1, "diameter of the beam at the lidar"},
        Field{"divergence_rad", &O::divergence_rad, 0.0, 0.1, "how much it grows with distance"},
        Field{"resolved_m", &O::resolved_m, 0.0, 10.0,
              "echoes nearer together than this are one, between them: mixed edge points"},
        Field{"farthest_m", &O::farthest_m, 0.1, 1000.0, "beyond, nothing comes back"},
        Field{"spot_rays", &O::spot_rays, 1, 51, "rays across the beam, either way"}};
  }
};

/// One scan from the turntable at `turned_rad` (true angle): ascending in angle, NaN where nothing
/// came back. Each beam is a bundle of rays over its spot. What they meet is grouped into echoes,
/// whose range is the mean by light thrown back; the strongest echo is told, so a beam that an edge
/// cuts gives a point in the air where both sides lie within `resolved_m`. `stream` numbers the
/// scan; the same seed and number give the same scan.
[[nodiscard]] std::vector<BeamReturn> simulate_scan(const TurntableWorld& world,
                                                    const TurntableScene& scene,
                                                    const TurntableScanOptions& options,
                                                    double turned_rad, std::uint64_t seed,
                                                    std::uint64_t stream);

/// The scan of every position of the world, its boards standing. `turned_rad`: true angles; empty:
/// as commanded. The same for any number of threads.
[[nodiscard]] std::vector<std::vector<BeamReturn>> simulate_scans(
    const TurntableWorld& world, const TurntableScanOptions& options, std::uint64_t seed,
    const std::vector<double>& turned_rad = {}, int threads = 0);

/// A disc and the scans that sweep over it.
struct DiscSweep {
  WorldDisc disc;
  std::vector<double> turntable_rad;
  std::vector<std::vector<BeamReturn>> scans;
};

/// The measuring experiment of [Liu2023, sec. 3.2]: a disc of 140 mm about 1.5 m before the lidar,
/// placed and tilted anew each time (by up to 25 degrees), swept in steps of 0.05 degrees over an
/// arc that clears it on both sides by 10 mm or more.
[[nodiscard]] std::vector<DiscSweep> simulate_disc_sweeps(const TurntableWorld& world,
                                                          const TurntableScanOptions& options,
                                                          int placements, std::uint64_t seed,
                                                          int threads = 0);

}  // namespace scanfuse::simulate
