#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "scanfuse/types/cloud.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::report {

/// A small picture of an image of the session.
struct ReportPicture {
  std::string png;  ///< bytes of a PNG file; empty: none
  int width_px = 0;
  int height_px = 0;
  double scale = 1;  ///< pixels of the image in one of the picture's
};

/// One position of a session, used or not.
struct ReportedPosition {
  std::string name;
  double turntable_rad = 0;
  bool used = false;
  std::string reason;                 ///< why it was left out
  std::array<double, 2> stripe_px{};  ///< rms of each board
  std::array<double, 2> lidar_m{};
  double correction_rad = 0;  ///< of the turntable's angle
  std::array<std::vector<BeamReturn>, 2> returns;
  ReportPicture picture;
};

/// What the page of a turntable calibration shows.
struct TurntableReport {
  std::string title;
  std::string method;
  Rig rig;
  TurntableFeatures features;
  std::array<Pose3, 2> camera_from_board;
  std::vector<ReportedPosition> positions;  ///< one for each of features.positions
  std::array<double, 3> rms{};              ///< corners px, stripe px, lidar mm
  /// Mean and greatest residual of lidar centre (mm), z axis and x axis (degrees) of single
  /// positions against the rig: what the paper's Table 1 lists.
  std::array<std::array<double, 2>, 3> table1{};
  double chi2_per_dof = 0;
  std::vector<std::string> warnings;
  ReportPicture board;
  /// Standard deviation of a point at a range, at an angle of the turntable; may be empty.
  std::function<double(double turntable_rad, double range_m)> point_sigma;
  Cloud cloud;  ///< in the camera frame; may be empty
};

/// One self-contained page of HTML: a verdict in a line, the paper's Table 1 and ours, the error of
/// a point over the turntable's angle, residuals of each position, what was found in its image, and
/// a view of the rig in space.
[[nodiscard]] std::string turntable_page(const TurntableReport& report);

}  // namespace scanfuse::report
