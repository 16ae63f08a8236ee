#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scanfuse/types/scan.hpp"

namespace scanfuse::preprocess {

/// The bearing bins of a virtual scan: column 0 is the one that -pi falls in, so that columns grow
/// with bearing.
class ColumnLayout {
 public:
  ColumnLayout() = default;
  /// `origin_rad` is the middle of a column.
  ColumnLayout(double origin_rad, double step_rad);

  [[nodiscard]] std::uint32_t at(float bearing_rad) const;
  /// Columns are numbered 0 to `last()`.
  [[nodiscard]] std::uint32_t last() const { return last_; }
  [[nodiscard]] bool operator==(const ColumnLayout&) const = default;

 private:
  std::uint32_t last_ = 0;
  float per_step_ = 1;
  float before_first_rad_ = 0;  ///< what is taken from a bearing to reach the edge of column 1
};

/// Where the beams of a scan's pattern point in the levelled frame, and with that the bearings and
/// columns of its returns: where the beam is known, no arc tangent is needed.
class BeamBearings {
 public:
  static constexpr std::uint32_t kNoColumn = 0xffffffffU;

  /// `yaw_rad` of the mounting, `step_rad` of the columns or 0 for the pattern's. Nothing happens
  /// where all is as before. Patterns that make no sense count as none.
  void prepare(const Scan& scan, double yaw_rad, double step_rad);

  [[nodiscard]] bool empty() const { return beams_.empty(); }
  [[nodiscard]] double first_rad() const { return first_rad_; }
  [[nodiscard]] double last_rad() const {
    return first_rad_ + (static_cast<double>(beams_.size()) - 1) * step_rad_;
  }
  [[nodiscard]] double step_rad() const { return step_rad_; }
  /// Of the pattern; only where there is one.
  [[nodiscard]] const ColumnLayout& layout() const { return layout_; }

  /// In [-pi, pi), to 1e-5 rad for any mounting. `beam`: Return::beam.
  [[nodiscard]] float bearing_of(float x_m, float y_m, std::int32_t beam) const;

  /// layout().at(bearing_of(...)) for a point near the middle of its beam, else kNoColumn.
  [[nodiscard]] std::uint32_t column_of(float x_m, float y_m, std::int32_t beam) const {
    // A negative beam is a huge unsigned one.
    if (static_cast<std::uint32_t>(beam) >= beams_.size()) return kNoColumn;
    const Beam& b = beams_[static_cast<std::uint32_t>(beam)];
    const float along = b.cosine * x_m + b.sine * y_m, across = b.cosine * y_m - b.sine * x_m;
    return std::abs(across) < near_middle_ * along ? b.column : kNoColumn;
  }

 private:
  struct Beam {
    float cosine = 1;
    float sine = 0;
    float bearing_rad = 0;
    std::uint32_t column = kNoColumn;  ///< that all points near its middle fall in
  };
  [[nodiscard]] std::uint32_t column_around(double bearing_rad) const;

  std::vector<Beam> beams_;
  double first_rad_ = 0;
  double step_rad_ = 0;
  ColumnLayout layout_;
  float near_middle_ = 0;  ///< tangent of the angle to either side
};

}  // namespace scanfuse::preprocess
