#pragma once

#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/shape/line_fit.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::shape {

struct IepfOptions {
  double threshold_m = 0.3;
  double sigma_factor = 3;
  double range_factor = 0.004;
  double merge_angle_rad = 0.66;
  double merge_gap_m = 0.8;
  double min_length_m = 0.35;

  static constexpr auto fields() {
    using O = IepfOptions;
    return std::tuple{
        Field{"threshold_m", &O::threshold_m, 0.001, 10.0, "a point further from the chord splits"},
        Field{"sigma_factor", &O::sigma_factor, 0.0, 20.0,
              "the threshold is at least this many times the range noise"},
        Field{"range_factor", &O::range_factor, 0.0, 0.1,
              "the threshold is at least this share of the range"},
        Field{"merge_angle_rad", &O::merge_angle_rad, 0.0, 1.5,
              "neighbouring lines closer in direction are one: bumpers are round"},
        Field{"merge_gap_m", &O::merge_gap_m, 0.0, 10.0, "and with a smaller gap between them"},
        Field{"min_length_m", &O::min_length_m, 0.0, 10.0, "shorter lines are dropped"},
    };
  }
};

/// Iterative end point fit [Lu2018, eqs. 3-4; Borges2004]: cuts points in order of bearing into
/// straight runs where the farthest point from the chord is too far. The distance is a cross
/// product, so vertical lines and equal ends are no special case. Departing from the paper, the
/// threshold follows noise and range, lines are refitted by total least squares, and the pieces of
/// rounded corners are merged or dropped. Buffers are reused between calls: one object per thread.
class Iepf {
 public:
  explicit Iepf(const IepfOptions& options = {})
      : options_(options), merge_cos_(std::cos(options.merge_angle_rad)) {}

  /// Lines in order of the points (metres, origin at the sensor); at least one for any point at
  /// all. Valid until the next call.
  [[nodiscard]] std::span<const LineSegment> operator()(std::span<const Eigen::Vector2d> points,
                                                        double sigma_range_m);

 private:
  struct Run {
    std::size_t first = 0;
    std::size_t last = 0;  ///< inclusive; neighbours share a point
    LineSegment line;
  };
  void split(std::span<const Eigen::Vector2d> points, double threshold_m);
  void merge();
  void drop_stubs();

  IepfOptions options_;
  double merge_cos_;
  RunningSums sums_;
  std::vector<std::pair<std::size_t, std::size_t>> stack_;
  std::vector<Run> runs_;
  std::vector<LineSegment> lines_;
};

/// The method as printed: one fixed threshold, the chords are the lines, nothing is merged.
[[nodiscard]] std::vector<LineSegment> iepf_literal(std::span<const Eigen::Vector2d> points,
                                                    double threshold_m);

}  // namespace scanfuse::shape
