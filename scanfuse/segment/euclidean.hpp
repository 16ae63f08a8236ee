#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/cell_table.hpp"
#include "scanfuse/segment/disjoint_sets.hpp"
#include "scanfuse/segment/gather.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

struct EuclideanOptions {
  double radius_m = 0.8;
  int min_points = 3;

  static constexpr auto fields() {
    using O = EuclideanOptions;
    return std::tuple{
        Field{"radius_m", &O::radius_m, 0.01, 10.0, "two points closer than this are neighbours"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// Connected components of "not farther apart than the radius", exact and independent of the order
/// of the points. Cells have the radius as their diagonal, so that the points of one cell need no
/// test; cells that are already joined are not compared again.
class Euclidean {
 public:
  explicit Euclidean(EuclideanOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  void sort_into_cells(const VirtualScan& scan);
  [[nodiscard]] bool near(const VirtualScan& scan, std::uint32_t a, std::uint32_t b) const;

  EuclideanOptions options_;
  CellTable table_;
  std::vector<std::uint32_t> cell_of_;
  std::vector<std::uint32_t> ends_;   ///< of each cell in `order_`
  std::vector<std::uint32_t> order_;  ///< points by cell
  std::vector<std::uint32_t> labels_;
  DisjointSets sets_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
