#pragma once

#include <cstdint>
#include <span>

#include "scanfuse/calibrate/cloud/mixed.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/cloud.hpp"

namespace scanfuse::calibrate {

struct AssembleOptions {
  CloudFrame frame = CloudFrame::kCamera;
  bool keep_mixed = false;
  MixedOptions mixed = {};
};

struct AssembledCloud {
  Cloud cloud;
  std::int64_t returns = 0;     ///< with a valid range
  std::int64_t mixed = 0;       ///< of them, found to be mixed
  std::int64_t beyond_arc = 0;  ///< scans outside the arc that was calibrated
  double range_noise_m = 0;     ///< as the scans show it
};

/// The scans of a rig as one cloud: P = R(psi) rho (cos theta, sin theta, 0)' + T(psi), the range
/// bias taken off [Liu2023, eq. 28]. Beams are numbered by their angle, so that beams without a
/// return, or removed as mixed, leave a gap in the numbers. An error where no scan has a return.
[[nodiscard]] Result<AssembledCloud> assemble(std::span<const TurntablePosition> scans,
                                              const Rig& rig, const AssembleOptions& options = {});

/// A cloud as another rig would have assembled it from the same scans: what an error of the
/// calibration does to every point. Needs profiles, and a frame that is not unknown.
[[nodiscard]] Cloud reassembled(const Cloud& cloud, const Rig& made_with, const Rig& rig);

}  // namespace scanfuse::calibrate
