#pragma once

#include <array>
#include <tuple>
#include <utility>

#include "scanfuse/core/options.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::evaluate {

/// What to do with a scan that no truth frame belongs to.
enum class UnlistedFrames { kCount, kSkip };

constexpr auto choices(UnlistedFrames) {
  using enum UnlistedFrames;
  return std::array{std::pair{"count", kCount}, std::pair{"skip", kSkip}};
}

/// What makes a track similar to an object: the distance of their centres, or the overlap of their
/// boxes seen from above (0 where the truth tells no extent).
enum class SimilarityBy { kCentre, kBevIou };

constexpr auto choices(SimilarityBy) {
  using enum SimilarityBy;
  return std::array{std::pair{"centre", kCentre}, std::pair{"bev_iou", kBevIou}};
}

/// Distances are between centres in the plane. Similarity of a truth object and a track at distance
/// d is max(0, 1 - d / s), s the larger of `similarity_m` and `match_m`, or the IoU of their boxes.
struct EvaluateOptions {
  SimilarityBy similarity = SimilarityBy::kCentre;
  double match_m = 2;
  double similarity_m = 2;
  double match_similarity = 0.5;
  double gospa_c_m = 2;
  double gospa_p = 2;
  double gospa_alpha = 2;
  int ospa2_window_frames = 10;
  int amota_levels = 40;
  double ghost_speed_m_per_s = 0.3;
  double ghost_distance_m = 0.5;
  double ring_m = 10;
  int min_visible_points = 0;
  double region_x0_m = -1e9;
  double region_x1_m = 1e9;
  double region_y0_m = -1e9;
  double region_y1_m = 1e9;
  double view_half_angle_rad = kPi;
  double view_range_m = 1e9;
  UnlistedFrames unlisted_frames = UnlistedFrames::kCount;

  static constexpr auto fields() {
    using O = EvaluateOptions;
    return std::tuple{
        Field{"similarity", &O::similarity, "by distance of centres, or overlap from above"},
        Field{"match_m", &O::match_m, 1e-3, 1e6,
              "a track farther than this from an object is never its match"},
        Field{"similarity_m", &O::similarity_m, 1e-3, 1e6,
              "distance at which similarity reaches 0 (never less than match_m)"},
        Field{"match_similarity", &O::match_similarity, 0.0, 1.0,
              "CLEAR and identity metrics: least similarity of a match"},
        Field{"gospa_c_m", &O::gospa_c_m, 1e-3, 1e6, "cut-off distance of GOSPA and OSPA"},
        Field{"gospa_p", &O::gospa_p, 1.0, 10.0, "order of GOSPA and OSPA"},
        Field{"gospa_alpha", &O::gospa_alpha, 0.01, 2.0, "GOSPA: a miss costs c^p / alpha"},
        Field{"ospa2_window_frames", &O::ospa2_window_frames, 1, 10000,
              "OSPA(2) compares the tracks of this many latest frames"},
        Field{"amota_levels", &O::amota_levels, 0, 1000,
              "levels of recall that AMOTA averages over; 0: left out"},
        Field{"ghost_speed_m_per_s", &O::ghost_speed_m_per_s, 0.0, 100.0,
              "ghost movers are tracks faster than this"},
        Field{"ghost_distance_m", &O::ghost_distance_m, 0.0, 100.0,
              "and farther than this from every object"},
        Field{"ring_m", &O::ring_m, 0.1, 1000.0, "width of the rings of precision against range"},
        Field{"min_visible_points", &O::min_visible_points, 0, 1000000,
              "truth objects with fewer returns are ignored, and what tracks them"},
        Field{"region_x0_m", &O::region_x0_m, -1e9, 1e9, "only what is inside counts, truth frame"},
        Field{"region_x1_m", &O::region_x1_m, -1e9, 1e9, "see region_x0_m"},
        Field{"region_y0_m", &O::region_y0_m, -1e9, 1e9, "see region_x0_m"},
        Field{"region_y1_m", &O::region_y1_m, -1e9, 1e9, "see region_x0_m"},
        Field{"view_half_angle_rad", &O::view_half_angle_rad, 0.0, kPi,
              "only what lies this far left or right of the ego's x axis counts"},
        Field{"view_range_m", &O::view_range_m, 0.0, 1e9, "only what is nearer to the ego counts"},
        Field{"unlisted_frames", &O::unlisted_frames,
              "scans without truth: counted as empty road, or skipped"},
    };
  }
};

}  // namespace scanfuse::evaluate
