#pragma once

#include <string>
#include <vector>

#include "scanfuse/calibrate/refine.hpp"
#include "scanfuse/calibrate/turntable.hpp"

/// What a user should know of a result, in words: weak directions and remedies.
namespace scanfuse::calibrate {

/// Of any method: few positions, the order of the boards, turns that differ from what was
/// commanded, mountings that see little.
[[nodiscard]] std::vector<std::string> advise(const TurntableFeatures& features,
                                              const Prepared& prepared,
                                              const TurntableCalibration& result);

/// Of the joint method: what its covariance and its noise say.
[[nodiscard]] std::vector<std::string> advise_joint(const Refined& refined,
                                                    const TurntableCalibration& result);

}  // namespace scanfuse::calibrate
