#pragma once

#include <array>
#include <tuple>
#include <utility>

#include "scanfuse/core/options.hpp"

namespace scanfuse::preprocess {

/// How ground returns are told from objects.
enum class GroundMethod {
  kAuto,    ///< none for one layer, layers for 2 to 8, grid for more and for clouds without layers
  kNone,    ///< every return is an object
  kBand,    ///< by height alone: between z_low_m and z_high_m above flat ground
  kLayers,  ///< a return that no second layer confirms and that is of the lowest layer, or low, is
            ///< ground
  kGrid,    ///< ground height estimated per bearing sector and range ring
};

constexpr auto choices(GroundMethod) {
  using enum GroundMethod;
  return std::array{std::pair{"auto", kAuto}, std::pair{"none", kNone}, std::pair{"band", kBand},
                    std::pair{"layers", kLayers}, std::pair{"grid", kGrid}};
}

/// How returns that belong to nothing are told by their neighbours in space and time.
enum class OutlierMethod {
  kNone,
  kSupported,      ///< a return without supporters is dropped
  kMedianReplace,  ///< each range becomes the median around it, as printed
};

constexpr auto choices(OutlierMethod) {
  using enum OutlierMethod;
  return std::array{std::pair{"none", kNone}, std::pair{"supported", kSupported},
                    std::pair{"median_replace", kMedianReplace}};
}

struct PreprocessOptions {
  OutlierMethod outliers = OutlierMethod::kNone;
  double outlier_support_m = 0.2;
  double outlier_support_per_m = 0.01;
  double outlier_relaxed_m = 20;
  bool median_compensated = false;
  GroundMethod ground = GroundMethod::kAuto;
  double range_min_m = 0.05;
  double range_max_m = 250;
  double x_min_m = -1000;
  double x_max_m = 1000;
  double y_min_m = -1000;
  double y_max_m = 1000;
  double z_low_m = 0.2;
  double z_high_m = 2.5;
  double step_rad = 0;
  double support_m = 0.4;
  int points_per_bearing = 0;
  double separation_m = 1.5;
  double lonely_m = 0.5;
  double lonely_per_m = 0.03;
  double sigma_range_m = 0.03;

  static constexpr auto fields() {
    using O = PreprocessOptions;
    return std::tuple{
        Field{"outliers", &O::outliers, "how returns that belong to nothing are taken away"},
        Field{"outlier_support_m", &O::outlier_support_m, 0.0, 10.0,
              "supported: neighbours within this + outlier_support_per_m * range are supporters"},
        Field{"outlier_support_per_m", &O::outlier_support_per_m, 0.0, 1.0,
              "see outlier_support_m"},
        Field{"outlier_relaxed_m", &O::outlier_relaxed_m, 0.0, 10000.0,
              "supported: farther than this one supporter is enough, nearer two are needed"},
        Field{"median_compensated", &O::median_compensated,
              "median_replace: move the scan before by the ego's motion"},
        Field{"ground", &O::ground, "how ground returns are told from objects"},
        Field{"range_min_m", &O::range_min_m, 0.0, 1000.0, "nearer returns are dropped"},
        Field{"range_max_m", &O::range_max_m, 0.1, 10000.0, "farther returns are dropped"},
        Field{"x_min_m", &O::x_min_m, -10000.0, 10000.0, "region of interest, levelled frame"},
        Field{"x_max_m", &O::x_max_m, -10000.0, 10000.0, "region of interest, levelled frame"},
        Field{"y_min_m", &O::y_min_m, -10000.0, 10000.0, "region of interest, levelled frame"},
        Field{"y_max_m", &O::y_max_m, -10000.0, 10000.0, "region of interest, levelled frame"},
        Field{"z_low_m", &O::z_low_m, -10.0, 10.0, "objects stand out of the ground by this"},
        Field{"z_high_m", &O::z_high_m, 0.0, 100.0, "what is higher above ground is passed under"},
        Field{"step_rad", &O::step_rad, 0.0, 0.2,
              "bearing bin; 0: the beam pattern's, else found from the data"},
        Field{"support_m", &O::support_m, 0.0, 10.0,
              "returns of one bearing within this range support each other"},
        Field{"points_per_bearing", &O::points_per_bearing, 0, 16,
              "most points kept of one bearing; 0: 3 for clouds and where the beam pattern is "
              "unknown, else 1"},
        Field{"separation_m", &O::separation_m, 0.1, 100.0,
              "a gap in range after which another object may follow on the same bearing"},
        Field{"lonely_m", &O::lonely_m, 0.0, 10.0,
              "a point without support or neighbour within this + lonely_per_m * range is dropped; "
              "0 keeps all"},
        Field{"lonely_per_m", &O::lonely_per_m, 0.0, 1.0, "see lonely_m"},
        Field{"sigma_range_m", &O::sigma_range_m, 0.0, 1.0, "range noise of the sensor"},
    };
  }
};

}  // namespace scanfuse::preprocess
