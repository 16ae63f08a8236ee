#pragma once

#include <array>
#include <span>
#include <vector>

#include "scanfuse/triangulate/lines_by_sensor.hpp"
#include "scanfuse/triangulate/prior.hpp"

/// What a predicted target says of the bearings of a scan: prior evidence for their association.
namespace scanfuse::triangulate {

/// Bearings that could all be of a target, at most one of each sensor.
struct TrackColumn {
  std::vector<std::int32_t> bearings;  ///< places in the scan, ascending by sensor; may be empty
  double log_ratio = 0;  ///< ln of how much likelier they are as the target's than as false alarms
};

/// All columns within the gate, the first one empty: the target was missed by all sensors.
///
///   log_ratio = sum (ln PD - ln lambda + ln N(d; 0, J P J' + R)) + sum_missed ln(1 - PD)
///
/// sensor after sensor, each bearing taken narrows the place for the next. Sensors without a
/// bearing in the scan did not look, nor do those that have the target outside their field of view.
/// Of more than `most` columns the heaviest so far are kept at each sensor, and the empty one.
/// `limits`: the chi-square quantiles of one and of two degrees of freedom.
[[nodiscard]] std::vector<TrackColumn> columns_of_track(
    const Gaussian<3>& place_m, std::span<const LinesOfSensor> sensors, const PassiveScene& scene,
    const ScenePrior& prior, const std::array<double, 2>& limits, int most);

}  // namespace scanfuse::triangulate
