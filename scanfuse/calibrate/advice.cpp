#include "scanfuse/calibrate/advice.hpp"

#include <Eigen/Eigenvalues>
#include <array>

#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWeakAxis_rad = radians(0.02);
constexpr double kWeakPoint_m = 0.5e-3;

double arc_of(const Rig& rig) { return rig.last_turntable_rad - rig.first_turntable_rad; }

/// Which way a direction across the axis points, in terms of the arc.
std::string along_arc(const Rig& rig, const Vector3d& direction) {
  const double middle = (rig.first_turntable_rad + rig.last_turntable_rad) / 2;
  const Vector3d n = rig.axis_direction;
  Vector3d radius = rig.pose(middle).translation_m - rig.axis_point_m;
  radius -= n * n.dot(radius);
  if (radius.norm() < 1e-3) {
    return fmt::format("({:.2f}, {:.2f}, {:.2f}) of the camera frame", direction.x(), direction.y(),
                       direction.z());
  }
  const double share = std::abs(radius.normalized().dot(direction));
  return share > 0.85  ? "the arc's radius"
         : share < 0.5 ? "the arc's chord"
                       : "between the arc's chord and radius";
}

std::string remedy_of_arc(const Rig& rig, std::size_t positions) {
  const double arc = degrees(arc_of(rig));
  if (arc < 12) return fmt::format("turn further than {:.3g} degrees (12 or more)", arc);
  if (positions < 30) return "take more positions";
  return "turn further, or set up a larger V and turn it into the middle of the arc";
}

struct Weakest {
  double sigma = 0;
  Vector3d direction = Vector3d::UnitX();
};

Weakest weakest(const Rig& rig, const Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> solver(covariance);
  return {std::sqrt(std::max(0.0, solver.eigenvalues()[1])),
          axis_basis(rig.axis_direction) * solver.eigenvectors().col(1)};
}

void weak_directions(const Rig& rig, std::size_t positions, std::vector<std::string>& words) {
  const Weakest axis = weakest(rig, rig.covariance.block<2, 2>(0, 0));
  if (axis.sigma > kWeakAxis_rad) {
    words.push_back(fmt::format(
        "weak: the axis's tilt along {} is known to {:.3f} degrees only (1 sigma): {}",
        along_arc(rig, axis.direction), degrees(axis.sigma), remedy_of_arc(rig, positions)));
  }
  const Weakest point = weakest(rig, rig.covariance.block<2, 2>(2, 2));
  if (point.sigma > kWeakPoint_m) {
    words.push_back(fmt::format(
        "weak: the axis's place along {} is known to {:.2f} mm only (1 sigma): {}",
        along_arc(rig, point.direction), 1e3 * point.sigma, remedy_of_arc(rig, positions)));
  }
}

void two_covariances(const TurntableCalibration& result, std::vector<std::string>& words) {
  struct Group {
    const char* name;
    int first;
    int size;
    double unit;
    const char* unit_name;
  };
  constexpr std::array kGroups{Group{"axis direction", 0, 2, 180 / kPi, "degrees"},
                               Group{"axis position", 2, 2, 1e3, "mm"},
                               Group{"lidar's rotation", 4, 3, 180 / kPi, "degrees"},
                               Group{"lidar's centre", 7, 3, 1e3, "mm"}};
  for (const auto& g : kGroups) {
    const auto sigma = [&](const RigCovariance& c) {
      return g.unit * std::sqrt(c.block(g.first, g.first, g.size, g.size).trace());
    };
    const double by_model = sigma(result.covariance_hessian);
    const double by_blocks = sigma(result.covariance_jackknife);
    const double ratio = by_blocks / by_model;
    if (!(ratio > 2) && !(ratio < 0.5)) continue;
    words.push_back(fmt::format(
        "{}: 1 sigma is {:.3g} {} by the noise model but {:.3g} by leaving out parts of the arc: "
        "{}",
        g.name, by_model, g.unit_name, by_blocks,
        ratio > 2 ? "errors are shared by neighbouring positions; trust the larger, look for what "
                    "drifts (camera or boards that moved, warm-up of the lidar)"
                  : "few positions or blocks, or noise that was given too large"));
  }
}

void systematic_errors(const Refined& refined, const TurntableCalibration& result,
                       std::vector<std::string>& words) {
  const auto sigma = [&](int k) { return std::sqrt(refined.solution.covariance(k, k)); };
  if (refined.unknowns.range_bias) {
    words.push_back(fmt::format(
        "ranges are {:.2f} +- {:.2f} mm too long; the rig corrects for it. The lidar's own "
        "calibration may tell it better",
        1e3 * result.rig.range_bias_m, 1e3 * sigma(10)));
  }
  if (refined.unknowns.square_bias) {
    words.push_back(fmt::format(
        "ranges on squares like the first are {:.2f} +- {:.2f} mm longer than on the others; the "
        "mean of both is taken as right",
        1e3 * result.square_bias_m, 1e3 * sigma(kSquareAt)));
  }
  if (refined.unknowns.range_bias) return;
  JointUnknowns with = refined.unknowns;
  with.range_bias = true;
  const auto C = solve(refined.system, refined.noise, with).covariance;
  const double bias = 2 * std::sqrt(C(10, 10));
  const double moved = 1e3 * bias * C.block<3, 1>(7, 10).norm() / C(10, 10);
  if (moved > 0.3) {
    words.push_back(fmt::format(
        "these data cannot exclude a range bias of up to {:.2f} mm, which would put the centre "
        "{:.2f} mm off: stand nearer to the boards, or take the bias from the lidar's data sheet",
        1e3 * bias, moved));
  }
}

void shared_errors(const Refined& refined, const TurntableCalibration& result,
                   std::vector<std::string>& words) {
  if (refined.line_chi2_per_dof > 2) {
    words.push_back(fmt::format(
        "whole lines scatter {:.1f} times as much as their points' noise explains; errors that all "
        "points of a line share are taken into account (stripe {:.3f} px, returns {:.2f} mm): "
        "check focus, exposure, intrinsics and flatness of the boards",
        std::sqrt(refined.line_chi2_per_dof), result.noise.stripe_offset_px,
        1e3 * result.noise.lidar_offset_m));
  }
  const double turned = std::sqrt(refined.noise.effect[kEffects - 1]);
  const double prior = std::sqrt(refined.noise.turntable_rad2);
  if (turned > 2 * prior) {
    words.push_back(
        fmt::format("the turntable's angles scatter by {:.4f} degrees, more than the {:.4f} that "
                    "turntable_sigma_rad says",
                    degrees(turned), degrees(prior)));
  }
}

}  // namespace

std::vector<std::string> advise(const TurntableFeatures& features, const Prepared& prepared,
                                const TurntableCalibration& result) {
  std::vector<std::string> words;
  const Rig& rig = result.rig;
  if (!prepared.decided) {
    words.emplace_back(
        "the motion does not tell which board the scan meets first; the first one is taken to have "
        "the lower scan angles. If the cloud is mirrored, set first_board = \"descending\"");
  }
  const std::size_t given = features.positions.size();
  const auto used = static_cast<std::size_t>(result.positions_used);
  if (5 * used < 4 * given) {
    words.push_back(fmt::format("{} of {} positions were left out", given - used, given));
  }
  if (used < 10) {
    words.push_back(
        fmt::format("only {} positions: the uncertainties themselves are uncertain", used));
  }
  const double ratio = prepared.motion.turn_ratio;
  const double unsure = 6 * prepared.motion.rotation_median_rad /
                        (arc_of(rig) * std::sqrt(static_cast<double>(used)));
  if (result.rig.angle_scale == 1 && std::abs(ratio - 1) > 0.002 + unsure) {
    words.push_back(fmt::format(
        "the lidar turned {:.4f} times as far as commanded: estimate angle_scale", ratio));
  }
  const Vector3d z = rig.camera_from_lidar.rotation * Vector3d::UnitZ();
  if (std::abs(z.dot(rig.axis_direction)) > std::cos(radians(3))) {
    words.emplace_back(
        "the axis runs along the scan plane's normal: the scan turns in its own plane, so that a "
        "cloud of it will be a plane");
  }
  const FixedPose& seen = prepared.samples[prepared.samples.size() / 2].pose;
  const double far = prepared.boards[0].camera_from_board.translation_m.norm();
  if (std::abs(seen.scan_plane.distance_m) < 0.03 * far) {
    words.emplace_back(
        "the camera stands nearly in the scan plane, where a stripe's image says little of its "
        "plane: move the camera sideways");
  }
  return words;
}

std::vector<std::string> advise_joint(const Refined& refined, const TurntableCalibration& result) {
  std::vector<std::string> words;
  if (!refined.converged) words.emplace_back("the refinement did not converge");
  if (!refined.solution.definite) {
    words.emplace_back("some direction is not observed at all; its uncertainty is not told");
  }
  weak_directions(result.rig, refined.samples.size(), words);
  two_covariances(result, words);
  systematic_errors(refined, result, words);
  shared_errors(refined, result, words);
  return words;
}

}  // namespace scanfuse::calibrate
