#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/cell_table.hpp"
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
/// test; cells that are already joined are not compared again. Crowded cells that may not touch are
/// compared by boxes around halves of halves of their points, so that no crowd costs all pairs.
class Euclidean {
 public:
  explicit Euclidean(EuclideanOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  void sort_into_cells(const VirtualScan& scan);
  /// A box around order_[begin, end); `left` and the node after it are its halves, once asked for.
  struct Node {
    float x_low, x_high, y_low, y_high;
    std::uint32_t begin, end;
    std::uint32_t left;

    [[nodiscard]] std::uint32_t size() const { return end - begin; }
    [[nodiscard]] float reach() const { return std::max(x_high - x_low, y_high - y_low); }
  };
  [[nodiscard]] bool near(const VirtualScan& scan, std::uint32_t a, std::uint32_t b);
  [[nodiscard]] bool near_by_boxes(const VirtualScan& scan, std::uint32_t a, std::uint32_t b);
  [[nodiscard]] bool any_near(const VirtualScan& scan, const Node& a, const Node& b) const;
  std::uint32_t root_of(const VirtualScan& scan, std::uint32_t cell);
  std::uint32_t add_node(const VirtualScan& scan, std::uint32_t begin, std::uint32_t end);
  std::uint32_t halves_of(const VirtualScan& scan, std::uint32_t node);
  [[nodiscard]] Node cell_node(std::uint32_t cell) const;

  EuclideanOptions options_;
  CellTable table_;
  std::vector<std::uint32_t> cell_of_;
  std::vector<std::uint32_t> ends_;   ///< of each cell in `order_`
  std::vector<std::uint32_t> order_;  ///< points by cell
  std::vector<Node> nodes_;           ///< of crowded cells that had to be compared
  std::vector<std::uint32_t> roots_;  ///< node of each cell, or CellTable::kNone
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open_;  ///< pairs of nodes to compare
  std::vector<std::uint32_t> labels_;
  DisjointSets sets_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
