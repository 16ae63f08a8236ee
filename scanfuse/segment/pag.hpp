#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/cell_table.hpp"
#include "scanfuse/segment/gather.hpp"
#include "scanfuse/segment/notch.hpp"
#include "scanfuse/segment/ring_cells.hpp"
#include "scanfuse/segment/ring_grid.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

/// The shape of Pag's cells.
enum class PagCells {
  kGrowing,  ///< rings around the sensor; a cell is about as wide as it is deep and grows with
             ///< range
  kSquare,   ///< min(sqrt(area) / K, cap) on the box of the inner 98 % of the points
};

constexpr auto choices(PagCells) {
  return std::array{std::pair{"growing", PagCells::kGrowing},
                    std::pair{"square", PagCells::kSquare}};
}

struct PagOptions {
  PagCells cells = PagCells::kGrowing;
  double range_max_m = 120;
  double cell_m = 0.12;
  double growth = 0.009;
  double depth = 5;
  double square_cap_m = 0.5;
  double density = 0.35;
  double notch_m = 0;
  int min_points = 3;

  static constexpr auto fields() {
    using O = PagOptions;
    return std::tuple{
        Field{"cells", &O::cells, "growing with range, or square as printed"},
        Field{"range_max_m", &O::range_max_m, 1.0, 1000.0, "the region of interest"},
        Field{"cell_m", &O::cell_m, 0.01, 10.0, "growing: width of the nearest cells"},
        Field{"growth", &O::growth, 0.0, 0.2,
              "growing: width of a cell over range; never less than two beam steps"},
        Field{"depth", &O::depth, 0.2, 10.0, "growing: depth of a cell over its width"},
        Field{"square_cap_m", &O::square_cap_m, 0.05, 10.0, "square: the largest cell"},
        Field{"density", &O::density, 0.0, 10.0, "multiple of MinPts that a dense cell exceeds"},
        Field{"notch_m", &O::notch_m, 0.0, 10.0,
              "an outline dented by more than this and noise is cut there; 0: never"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// Grid-based clustering after [Lu2018, eqs. 1-2], made robust. What differs from the print, and
/// why:
///  - a region of interest and the points' inner 98 % instead of their bounding box: one return at
///  195 m
///    must not stretch the cells; points outside the region are noise;
///  - cells that grow with range (or square ones with a cap, whose counts are weighted by
///    clip(r / 15, 0.3, 5)): one global threshold on equal cells deletes far cars. Growing cells
///    are deeper than wide: returns from a car's flank are far apart along the line of sight, while
///    what stands beside it is told apart across it;
///  - dense means more than MinPts = C (see pag_min_points) times `density`; where no cell exceeds
///  it,
///    reaching it is enough;
///  - a low cell goes to the densest of its dense neighbours and never bridges two clusters;
///  - with `notch_m` clusters are cut where two things touch, see NotchCutter: off by default.
/// Time and memory follow the number of points, whatever the area. Points come in order of bearing.
class Pag {
 public:
  explicit Pag(PagOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  void fill_rings(const VirtualScan& scan);
  void fill_squares(const VirtualScan& scan);
  void place(std::size_t point, std::uint32_t cell, float weight);
  [[nodiscard]] double square_size(const VirtualScan& scan);
  void mark_dense();
  void join_dense();
  void absorb_low();
  void offer(std::uint32_t low, std::uint32_t dense);
  void relate(std::uint32_t a, std::uint32_t b);
  template <class Visit>
  void for_square_neighbours(Visit visit) const;

  PagOptions options_;
  RingGrid rings_;
  RingCells ring_cells_;
  CellTable table_;                     ///< of square cells
  std::vector<std::uint32_t> cell_of_;  ///< of each point
  std::vector<float> weights_;          ///< of each cell
  std::vector<std::uint8_t> dense_;
  std::vector<std::uint32_t> owners_;  ///< the dense cell each cell belongs to, then its label
  std::vector<float> sorted_;
  std::vector<std::uint32_t> labels_;
  DisjointSets sets_;
  Gatherer gather_;
  NotchCutter cut_;
};

}  // namespace scanfuse::segment
