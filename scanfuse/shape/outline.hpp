#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/shape/face_fit.hpp"
#include "scanfuse/shape/iepf.hpp"
#include "scanfuse/shape/join.hpp"
#include "scanfuse/shape/line_fit.hpp"
#include "scanfuse/shape/occlusion.hpp"
#include "scanfuse/shape/rectangle_search.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/outline.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::shape {

/// Headings that are tried for a box: those of the lines found, or a full turn in equal steps.
enum class Search { kLines, kFull };

constexpr auto choices(Search) {
  return std::array{std::pair{"lines", Search::kLines}, std::pair{"full", Search::kFull}};
}

enum class LineMethod { kIepf, kIepfLiteral };

constexpr auto choices(LineMethod) {
  return std::array{std::pair{"iepf", LineMethod::kIepf},
                    std::pair{"iepf_literal", LineMethod::kIepfLiteral}};
}

struct OutlineOptions {
  LineMethod lines = LineMethod::kIepf;
  Search search = Search::kLines;
  Criterion criterion = Criterion::kCloseness;
  int search_steps = 18;
  int search_points = 32;
  double max_extent_m = 16;
  int max_lines = 3;
  double max_end_gap_m = 1.0;

  static constexpr auto fields() {
    using O = OutlineOptions;
    return std::tuple{
        Field{"lines", &O::lines, "how points are cut into lines"},
        Field{"search", &O::search, "headings tried: of the lines (fast), or all"},
        Field{"criterion", &O::criterion, "what the search for the heading maximises"},
        Field{"search_steps", &O::search_steps, 4, 360,
              "headings tried over 90 degrees by a full search"},
        Field{"search_points", &O::search_points, 4, 64, "bigger clusters are thinned to this"},
        Field{"max_extent_m", &O::max_extent_m, 0.1, 1000.0,
              "longer clusters are walls or hedges: one line, no box search"},
        Field{"max_lines", &O::max_lines, 1, 1000,
              "clusters of more lines are bushes: their box is fitted in one step"},
        Field{"max_end_gap_m", &O::max_end_gap_m, 0.0, 100.0,
              "most that a face may reach beyond its last point, between two beams"},
    };
  }
};

/// Everything the shape stage can be told.
struct ShapeOptions {
  OutlineOptions outline;
  IepfOptions iepf;
  FaceFitOptions faces;
  OcclusionOptions occlusion;
  JoinOptions join;
};

/// Lines and box of every cluster of a scan. Buffers are kept between scans, so that nothing is
/// allocated once they have grown; one object per thread. About 1 us for a car of 25 points
/// (bench/shape/outline_bench.cpp).
class OutlineExtractor {
 public:
  explicit OutlineExtractor(const ShapeOptions& options = {});

  /// One outline per cluster, in order, in the frame of the scan, after clusters that are pieces of
  /// one object were joined (see ClusterJoiner). `expected`: where tracks expect vehicles. Valid
  /// until the next call. Empty clusters give an outline without points.
  [[nodiscard]] std::span<const Outline> operator()(const VirtualScan& scan,
                                                    const Clusters& clusters,
                                                    std::span<const Expected> expected = {});

  /// The clusters that the last outlines are of. Valid as long as the clusters given.
  [[nodiscard]] const Clusters& clusters() const { return *clusters_; }

 private:
  void outline_of(const VirtualScan& scan, std::span<const std::uint32_t> indices,
                  Outline& outline);
  void gather(const VirtualScan& scan, std::span<const std::uint32_t> indices);
  void find_lines(const VirtualScan& scan, Outline& outline);
  void find_box(const VirtualScan& scan, Outline& outline);
  [[nodiscard]] double find_heading(const Outline& outline, double sigma_range_m);

  ShapeOptions options_;
  Iepf iepf_;
  ClusterJoiner join_;
  RectangleSearch search_;
  RunningSums sums_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<std::uint32_t> order_;
  std::vector<Outline> outlines_;
  const Clusters* clusters_ = nullptr;
};

}  // namespace scanfuse::shape
