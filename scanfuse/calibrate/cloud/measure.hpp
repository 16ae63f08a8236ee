#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/cloud.hpp"

/// Measures in an assembled cloud. Each has an uncertainty of two parts: what the points scatter
/// (statistical), and what the calibration leaves open (of the rig), which all points share and no
/// number of them averages away.
namespace scanfuse::calibrate {

struct Measured {
  double value = 0;
  double sigma_points = 0;
  double sigma_rig = 0;  ///< 0 where no rig was given

  [[nodiscard]] double sigma() const { return std::hypot(sigma_points, sigma_rig); }
};

/// A box along the axes of the cloud's frame, metres.
struct CropBox {
  Eigen::Vector3d low_m = Eigen::Vector3d::Constant(-1e9);
  Eigen::Vector3d high_m = Eigen::Vector3d::Constant(1e9);

  [[nodiscard]] bool holds(const Eigen::Vector3d& p) const {
    return (p.array() >= low_m.array()).all() && (p.array() <= high_m.array()).all();
  }
};

/// Indices of the points within; ascending.
[[nodiscard]] std::vector<std::size_t> cropped(const Cloud& cloud, const CropBox& box);

struct MeasureOptions {
  double spot_m = 0;
  double thickness_m = 0.005;
  int min_points = 30;

  static constexpr auto fields() {
    using O = MeasureOptions;
    return std::tuple{
        Field{"spot_m", &O::spot_m, 0.0, 1.0,
              "diameter of the laser's spot on the target, where it is known; it counts where "
              "intensities do not show it"},
        Field{"thickness_m", &O::thickness_m, 1e-5, 1.0,
              "points within this of a plane are its first guess"},
        Field{"min_points", &O::min_points, 8, 1000000, "fewer points are not measured"},
    };
  }
};

struct PlaneMeasure {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the lidar
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Measured distance_m;  ///< from the frame's origin
  Measured tilt_rad;    ///< of the normal out of its value; the value is 0, only sigma counts
  double rms_m = 0;     ///< of the points, along the rays where profiles are known
  std::size_t points = 0;
  std::size_t left_out = 0;  ///< of those in the crop
};

struct DiscMeasure {
  PlaneMeasure plane;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Measured diameter_m;
  double centre_sigma_m = 0;  ///< in the plane, each way, from the points
  double spot_m = 0;          ///< diameter of the spot by intensities, or width of the mixed band
  double edge_shift_m = 0;    ///< beyond the edge, where beams change sides; taken off
  double outermost_diameter_m = 0;  ///< circle through the outermost points, for comparison only
  double area_diameter_m = 0;       ///< from the number of points, for comparison
  int edge_beams = 0;
  double unbacked_share = 0;  ///< of the edge with nothing behind it
  bool by_area = false;       ///< the cloud has no profiles: area_diameter_m is the result
};

struct DistanceMeasure {
  PlaneMeasure from;
  Measured perpendicular_m;  ///< from the first part's plane to the second part's centre
  Measured centres_m;        ///< from centre to centre
};

struct SizeMeasure {
  PlaneMeasure plane;
  Measured length_m;  ///< the longer side of the rectangle
  Measured width_m;
  Eigen::Vector3d length_axis = Eigen::Vector3d::UnitX();
};

/// A plane through the crop's points.
[[nodiscard]] Result<PlaneMeasure> measure_plane(const Cloud& cloud, const CropBox& box,
                                                 const MeasureOptions& options,
                                                 const std::optional<Rig>& rig);

/// A round flat target. Of several surfaces in the crop the roundest flat one is taken. The edge
/// lies between the last beam on the disc and the first beyond it; the circle is the most likely
/// one given which beams met what (disc_likelihood.hpp), so that it does not shrink with the beams'
/// spacing as the circle through the outermost points does. Without profiles, the diameter comes
/// from how many points lie on the disc against how dense they lie in its middle.
[[nodiscard]] Result<DiscMeasure> measure_disc(const Cloud& cloud, const CropBox& box,
                                               const MeasureOptions& options,
                                               const std::optional<Rig>& rig);

/// From the plane of one part to another part.
[[nodiscard]] Result<DistanceMeasure> measure_distance(const Cloud& cloud, const CropBox& from,
                                                       const CropBox& to,
                                                       const MeasureOptions& options,
                                                       const std::optional<Rig>& rig);

/// Sides of a flat rectangle: edges midway between the last beam on it and the first that met what
/// is behind, along profiles and across them. Needs profiles.
[[nodiscard]] Result<SizeMeasure> measure_size(const Cloud& cloud, const CropBox& box,
                                               const MeasureOptions& options,
                                               const std::optional<Rig>& rig);

}  // namespace scanfuse::calibrate
