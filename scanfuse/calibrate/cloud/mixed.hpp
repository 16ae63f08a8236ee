#pragma once

#include <tuple>
#include <vector>

#include "scanfuse/calibrate/cloud/range_image.hpp"
#include "scanfuse/core/options.hpp"

namespace scanfuse::calibrate {

struct MixedOptions {
  double tolerance_sigmas = 4;
  double least_noise_m = 2e-4;

  static constexpr auto fields() {
    using O = MixedOptions;
    return std::tuple{
        Field{
            "tolerance_sigmas", &O::tolerance_sigmas, 1.0, 100.0,
            "a return further from where a surface would go on, in standard deviations, is off it"},
        Field{"least_noise_m", &O::least_noise_m, 0.0, 0.1,
              "range noise is taken to be no less than this"},
    };
  }
};

/// Which returns are mixed: a beam whose spot falls on the edge of one thing and on what is behind
/// gives a range between the two, which is nobody's.
///
/// A return is mixed where, along its profile or across profiles, it lies off the surfaces of both
/// sides, behind the one and before the other. The surface of a side is the line through the
/// nearest three returns in a row there that lie on one line, up to three returns away, so that two
/// mixed returns side by side do not hide each other. Lines and corners of thin things, which lie
/// before the surfaces of both sides, are kept; so is what has no surface on one side.
/// A value for each cell of the image.
[[nodiscard]] std::vector<bool> find_mixed(const RangeImage& image,
                                           const MixedOptions& options = {});

}  // namespace scanfuse::calibrate
