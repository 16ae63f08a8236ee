#pragma once

#include <cstdint>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/object_class.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::simulate {

/// Flat labelled scenes for segmentation: which points belong together is known.
struct SegmentationSceneOptions {
  int beams = 440;
  double field_of_view_rad = radians(110);
  double range_noise_m = 0.03;
  double max_range_m = 80;
  bool stray_return = false;

  static constexpr auto fields() {
    using O = SegmentationSceneOptions;
    return std::tuple{
        Field{"beams", &O::beams, 2, 1000000, "rays, evenly over the field of view"},
        Field{"field_of_view_rad", &O::field_of_view_rad, 0.01, 2 * kPi, "centred on x"},
        Field{"range_noise_m", &O::range_noise_m, 0.0, 1.0, "standard deviation of a range"},
        Field{"max_range_m", &O::max_range_m, 1.0, 1000.0, "farther returns are lost"},
        Field{"stray_return", &O::stray_return, false, true, "adds one lonely return at 195 m"},
    };
  }
};

struct SceneObject {
  ObjectClass object_class = ObjectClass::kVehicle;
  Box2 box;
  int points = 0;  ///< returns on it
};

struct SegmentationScene {
  VirtualScan scan;
  std::vector<std::int32_t> label;   ///< per point: index into `objects`, -1 for borders and strays
  std::vector<SceneObject> objects;  ///< also those nothing was seen of
};

/// Two barriers at y = +-8 m, up to 8 vehicles in lanes y = -3.4, 0.3, 3.8 m from 7 to 65 m (15 %
/// trucks), 6 pedestrians, 3 cyclists; what hides what comes from the rays. Vehicles do not
/// overlap.
[[nodiscard]] SegmentationScene segmentation_scene(std::uint64_t seed,
                                                   const SegmentationSceneOptions& options = {});

/// One car in a random lane, its centre `range_m` ahead, between the barriers: for how right it is
/// cut out against range.
[[nodiscard]] SegmentationScene range_ladder_scene(double range_m, std::uint64_t seed,
                                                   const SegmentationSceneOptions& options = {});

}  // namespace scanfuse::simulate
