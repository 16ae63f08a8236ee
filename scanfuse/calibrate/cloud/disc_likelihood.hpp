#pragma once

#include <span>

#include "scanfuse/calibrate/cloud/disc_beams.hpp"

namespace scanfuse::calibrate {

/// A circle in a plane that explains which beams met a disc.
struct DiscEdge {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0;
  double spot_m = 0;  ///< half the width of the band in which beams are mixed
  /// Of centre, radius and spot; expected information, beams independent.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double log_likelihood = 0;
  int edge_beams = 0;         ///< within twice the band of the edge
  double unbacked_share = 0;  ///< of the edge beams with nothing behind the edge
  bool converged = false;
};

/// How far beyond the edge beams change from the target to what is behind it; edge_light.hpp.
struct EdgeShift {
  double backed_m = 0;
  double unbacked_m = 0;  ///< where nothing is behind
  double sigma_m = 0;
  double spot_m = 0;          ///< diameter of the spot as intensities show it; 0: they do not
  bool backed_known = false;  ///< from intensities
  bool unbacked_known = false;
};

/// The most likely circle given which beams met the disc, were mixed, or met the background. With
/// d the signed distance of a beam from the edge (negative inside), w the half width of the spot's
/// band and s the softness, d being less by the shift where one is given:
///
///   P(on) = F((-d - w) / s),  P(beyond) = F((d - w) / s),  P(mixed) = the rest      F: normal cdf
///
/// with w = 0 where nothing is behind the edge: a beam then counts as on the disc when its middle
/// is. Each gets one part in 10^4 of chance whatever the model says, so that a few beams that met
/// something else do not steer it. `start` gives centre and radius to a few millimetres;
/// `spacing_m` is the distance of neighbouring beams in the plane.
[[nodiscard]] DiscEdge fit_disc_edge(std::span<const EdgeBeam> beams, const DiscEdge& start,
                                     double spacing_m, const EdgeShift& shift = {});

}  // namespace scanfuse::calibrate
