#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/preprocess/beam_bearings.hpp"
#include "scanfuse/preprocess/ground_grid.hpp"
#include "scanfuse/preprocess/options.hpp"
#include "scanfuse/preprocess/range_keys.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::preprocess {

/// Flattens a scan of any number of layers to one point a bearing: levels it by the mounting, keeps
/// the region of interest, takes the ground away, and keeps of each bearing the nearest return that
/// another layer supports (or, where none has support, the nearest that is not ground). A row of
/// low points that one layer alone sees is ground when it is longer than a vehicle, or of fewer
/// than three. A point that then has neither support nor a neighbour is dropped. Every result is
/// ordered by bearing.
///
/// Bearings are binned by the beam pattern where the scan has one, else by `step_rad`, else by the
/// median step found in the data (0.1 to 1 deg; at least 0.2 deg for clouds).
/// The height of the mounting is z of `ego_from_sensor`; 0 means unknown, and is estimated from
/// clouds. Owns its working memory: after the first scans nothing is allocated.
class VirtualScanBuilder {
 public:
  explicit VirtualScanBuilder(PreprocessOptions options = {}) : options_(options) {}

  /// The result stays valid until the next call.
  const VirtualScan& operator()(const Scan& scan, const Pose3& ego_from_sensor = {});

 private:
  void project(const Scan& scan, const Eigen::Matrix3f& rotation);
  void find_layers(const Scan& scan);
  void find_bearings(const Scan& scan);
  [[nodiscard]] GroundMethod ground_method(const Scan& scan) const;
  void remove_ground(GroundMethod method, std::optional<double> sensor_height_m);
  void set_view();
  [[nodiscard]] double choose_step(const Scan& scan);
  void sort_into_columns(const Scan& scan);
  [[nodiscard]] std::uint32_t column_by_bearing(const Scan& scan, const LevelPoint& point) const;
  void pick_points(const Scan& scan, GroundMethod method);
  /// What agrees on the nearest return of a column.
  struct Support {
    int layers = 1;
    float z_low_m = 0, z_high_m = 0, depth_m = 0;
  };
  [[nodiscard]] Support support_of(std::span<const RangeKey> column) const;
  [[nodiscard]] static Support alone(const LevelPoint& point) {
    return {1, point.z_m, point.z_m, 0};
  }
  void pick_column(const Scan& scan, std::span<const RangeKey> column, GroundMethod method);
  [[nodiscard]] bool is_lonely_ground(const LevelPoint& point, GroundMethod method) const;
  void emit(const Scan& scan, const LevelPoint& point, const Support& support);
  [[nodiscard]] float height_m(float z_m) const;
  [[nodiscard]] bool may_be_ground(const PlanarPoint& point) const;
  [[nodiscard]] bool goes_on(const PlanarPoint& row, const PlanarPoint& next) const;
  void drop_low_rows(GroundMethod method);
  void order_by_bearing();
  void drop_lonely();

  PreprocessOptions options_;
  VirtualScan virtual_scan_;
  GroundGrid ground_;
  std::vector<LevelPoint> points_;
  BeamBearings beams_;
  ColumnLayout layout_;
  std::vector<float> steps_;
  std::vector<std::uint32_t> ends_;  ///< of each column in `order_`
  std::vector<RangeKey> order_;      ///< points by column, by range within
  std::vector<std::uint8_t> keep_;
  std::vector<std::size_t> row_;  ///< of points that may be ground
  std::int16_t lowest_layer_ = 0;
  bool layered_ = false;
  int most_per_bearing_ = 1;
  std::optional<double> sensor_height_m_;
};

}  // namespace scanfuse::preprocess
