#pragma once

#include <functional>
#include <vector>

#include "scanfuse/calibrate/cloud/beam_grid.hpp"
#include "scanfuse/calibrate/cloud/measure.hpp"

/// Steps that the measures share.
namespace scanfuse::calibrate {

/// A flat piece of a cloud: indices of its points, and its plane (whose inliers count in `points`).
struct FlatPart {
  std::vector<std::size_t> points;
  PlaneFit plane;
};

/// The plane of the points; an error where there are too few or none fits.
[[nodiscard]] Result<FlatPart> flat_part(const Cloud& cloud, std::vector<std::size_t> points,
                                         const MeasureOptions& options);

/// The same part in a cloud that moved a little: same points, plane fitted anew.
[[nodiscard]] std::optional<FlatPart> moved_part(const Cloud& moved, const FlatPart& part);

/// Connected surfaces among `points`: neighbouring beams or profiles whose ranges differ by less
/// than a step at 75 degrees of incidence. Largest first. Without profiles: all of them.
[[nodiscard]] std::vector<std::vector<std::size_t>> surfaces(
    const Cloud& cloud, const BeamGrid& grid, const std::vector<std::size_t>& points);

/// Numbers that a measure gives for a cloud; empty where it fails.
using MeasureOf = std::function<std::vector<double>(const Cloud&)>;

/// Standard deviations of the numbers from the rig's covariance: the cloud is assembled anew for
/// changes of one standard deviation along each principal direction, both ways. Zeros without a
/// rig. `values`: what the measure gives for the cloud itself.
[[nodiscard]] std::vector<double> rig_sigmas(const Cloud& cloud, const std::optional<Rig>& rig,
                                             const std::vector<double>& values,
                                             const MeasureOf& measure);

/// An error where a rig is given but the cloud cannot be traced back to it.
[[nodiscard]] Result<void> check_rig(const Cloud& cloud, const std::optional<Rig>& rig);

[[nodiscard]] PlaneMeasure plane_measure(const FlatPart& part);

}  // namespace scanfuse::calibrate
