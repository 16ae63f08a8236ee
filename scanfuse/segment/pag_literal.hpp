#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/gather.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

struct PagLiteralOptions {
  bool eight_neighbours = true;
  int min_points = 1;

  static constexpr auto fields() {
    using O = PagLiteralOptions;
    return std::tuple{
        Field{"eight_neighbours", &O::eight_neighbours,
              "cells touching at a corner are neighbours; the paper does not say"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// The density threshold of [Lu2018, eq. 2], computed as printed:
///
///   MinPts = (sum B_m / (N-1)) / (sum A_n / N) * C,   N = floor(sqrt(Max)), C = Num / Gridnum
///
/// A_n is an arithmetic progression and B_m its midpoints, so that the fraction is 1 for every Max
/// and MinPts is C, the mean count of an occupied cell. Where N < 2 the print gives 0/0: C is
/// taken.
[[nodiscard]] double pag_min_points(double points, double occupied_cells, double fullest_cell);

/// Grid-based clustering with automatic parameters as [Lu2018, eqs. 1-2] prints it, for comparison:
/// the bounding box in K x K cells, K = floor(sqrt(Num)); a cell with more than MinPts points is
/// dense; a low cell beside a dense one becomes dense (once, and may so bridge two clusters); the
/// points of the other low cells are outliers; adjacent dense cells are a cluster. No fidelity to
/// the method's original paper is claimed beyond these equations. One far point stretches all
/// cells: see Pag.
class PagLiteral {
 public:
  explicit PagLiteral(PagLiteralOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  void fill_cells(const VirtualScan& scan);
  void mark_cells();
  void join_cells();
  template <class Visit>
  void for_neighbours(std::int32_t cell, Visit visit) const;

  PagLiteralOptions options_;
  std::int32_t side_ = 1;
  std::vector<std::uint32_t> cell_of_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint8_t> dense_;
  std::vector<std::uint8_t> kept_;
  std::vector<std::uint32_t> labels_;
  DisjointSets sets_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
