#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/preprocess/options.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::preprocess {

/// The returns of a scan by beam column and layer, to look neighbours up in.
class BeamGrid {
 public:
  struct Cell {
    int column = 0;
    int layer = 0;
  };
  /// Columns by Return::beam where the pattern has that beam, else by bearing: the pattern's step,
  /// or 0.25 deg around the full circle. Keeps its memory.
  void fill(const Scan& scan);
  void clear() { columns_ = 0; }
  [[nodiscard]] bool empty() const { return columns_ == 0; }
  [[nodiscard]] Cell cell_of(const Return& r) const;
  [[nodiscard]] Cell cell_at(float x_m, float y_m, int layer) const;
  /// Calls visit(range_m, index) for the returns within +-1 layer, +-2 columns, those of its own
  /// layer first, until it answers false; `own_cell` false leaves out the cell itself.
  template <class Visit>
  void for_neighbours(Cell cell, bool own_cell, Visit&& visit) const;

 private:
  template <class Visit>
  bool visit_cell(int layer, int column, Visit& visit) const;
  struct Entry {
    float range_m = 0;
    std::int32_t next = -1;
  };
  std::vector<std::int32_t> heads_;  ///< of each cell, layer by layer
  std::vector<Entry> entries_;       ///< one a return
  /// Where a cell's list starts in `heads_`.
  [[nodiscard]] std::size_t place_of(int layer, int column) const {
    return static_cast<std::size_t>(layer) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_ = 0;
  int layers_ = 0;
  bool full_circle_ = false;
  bool has_pattern_ = false;
  float first_rad_ = 0;
  float per_step_ = 1;
};

/// The spatio-temporal median filter of [Guo]: the print says only that a median over space and
/// time takes outliers away. Neighbours are +-1 layer, +-2 beams.
///
/// `median_replace`: each return's range becomes the median over its neighbours, itself, and the
/// same window of the scan before, as a median filter does. It smears: what moves against its
/// background takes ranges of the scan before, edges those of what stands behind, grazing flanks
/// are bent. For comparison.
///
/// `supported`: the median's idea as a test, never as a value. A return is kept with two supporters
/// among its neighbours (|r_i - r_j| <= support_m + support_per_m r), or one there and one, moved
/// by the ego's motion, in the scan before; farther than relaxed_m one is enough, of either scan. A
/// straight face at grazing incidence supports itself: the two nearest beams of one layer on either
/// side, or to both sides, that lie on one line with the return (1 / r is linear in bearing) count
/// as two.
///
/// Keeps the last scan of each sensor (of up to 16); one older than half a second counts as none.
/// Owns its working memory: after the first scans nothing is allocated.
class SpatioTemporalFilter {
 public:
  explicit SpatioTemporalFilter(const PreprocessOptions& options = {}) : options_(options) {}

  /// The scan without outliers; `scan` itself with method `none`. Valid until the next call and as
  /// long as `scan`. Returns keep their order.
  const Scan& operator()(const Scan& scan, const Pose3& world_from_sensor);

 private:
  struct Before {
    std::string sensor;
    Time stamp;
    Pose3 world_from_sensor;
    Scan scan;
    BeamGrid grid;
  };
  Before& before(const Scan& scan);
  void remember(Before& before, const Scan& scan, const Pose3& world_from_sensor);
  void keep_supported(const Scan& scan, const Before& before, const Pose3& world_from_sensor);
  void replace_by_median(const Scan& scan, Before& before, const Pose3& world_from_sensor);
  [[nodiscard]] bool lies_on_line(const Scan& scan, std::size_t i) const;

  PreprocessOptions options_;
  std::vector<Before> before_;
  std::size_t next_ = 0;  ///< to be replaced where there are too many sensors
  BeamGrid grid_;
  BeamGrid moved_grid_;
  Scan moved_;
  Scan clean_;
  std::vector<float> window_;
};

}  // namespace scanfuse::preprocess
