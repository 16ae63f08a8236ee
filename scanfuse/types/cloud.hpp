#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scanfuse/types/turntable.hpp"

namespace scanfuse {

/// What the coordinates of a cloud refer to. `camera`: the camera that calibrated the rig. `axis`:
/// z along the turntable's axis, origin where the perpendicular from the lidar's centre meets it, y
/// along the scan plane's normal at turntable angle 0; an error of the camera's focal length moves
/// axis and lidar together and does not reach it. `unknown`: a cloud from elsewhere.
enum class CloudFrame { kUnknown, kCamera, kAxis };
constexpr auto choices(CloudFrame) {
  return std::array{std::pair{"unknown", CloudFrame::kUnknown},
                    std::pair{"camera", CloudFrame::kCamera}, std::pair{"axis", CloudFrame::kAxis}};
}

/// One scan of a cloud: where the lidar was.
struct CloudProfile {
  double turntable_rad = 0;
  Pose3 cloud_from_lidar;
};

/// Points assembled from the scans of a lidar on a turntable, with the profiles that they belong
/// to, so that every point can be traced to its beam. Clouds from elsewhere have no profiles.
struct Cloud {
  CloudFrame frame = CloudFrame::kUnknown;
  std::vector<CloudProfile> profiles;
  std::vector<CloudPoint> points;  ///< ascending by profile, then by beam, where there are profiles

  [[nodiscard]] bool has_profiles() const { return !profiles.empty(); }
};

}  // namespace scanfuse
