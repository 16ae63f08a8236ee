#include "scanfuse/calibrate/turntable.hpp"

#include <algorithm>

#include "scanfuse/calibrate/advice.hpp"
#include "scanfuse/calibrate/refine.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Residuals of one sample's stripes and returns against a rig.
struct SampleFit {
  std::array<double, 2> stripe_squares{};
  std::array<double, 2> lidar_squares{};
};

void describe(const TurntableFeatures& features, const TurntableCalibration& result,
              const Sample& sample, PositionResult& position, SampleFit& fit) {
  const Pose3 lidar = result.rig.pose(sample.turntable_rad + position.turntable_correction_rad);
  const Vector3d normal = lidar.rotation * Vector3d::UnitZ();
  const Plane scan_plane{normal, normal.dot(lidar.translation_m)};
  for (std::size_t b = 0; b < 2; ++b) {
    const Plane board = BoardPose{result.camera_from_board[b], 0}.plane();
    const StripeLine& stripe = sample.stripes[b];
    const Vector2d e = stripe_misfit(features.camera, stripe, scan_plane, board);
    fit.stripe_squares[b] =
        stripe.scatter + stripe.weight * e[0] * e[0] + stripe.moment * e[1] * e[1];
    position.stripe_offset_px[b] = e[0];
    position.stripe_px[b] = std::sqrt(fit.stripe_squares[b] / stripe.count);
    double sum = 0;
    const auto& returns = sample.returns.on_board[b];
    for (const auto& r : returns) {
      const Vector3d ray =
          lidar.rotation * Vector3d(std::cos(r.angle_rad), std::sin(r.angle_rad), 0);
      const Vector3d at = lidar.translation_m + (r.range_m - result.rig.range_bias_m) * ray;
      const double off = (board.normal.dot(at) - board.distance_m) / board.normal.dot(ray);
      sum += off;
      fit.lidar_squares[b] += off * off;
    }
    const auto count = static_cast<double>(returns.size());
    position.lidar_offset_m[b] = sum / count;
    position.lidar_m[b] = std::sqrt(fit.lidar_squares[b] / count);
    position.returns[b] = returns;
  }
  const Pose3 model = result.rig.pose(sample.turntable_rad);
  const Pose3& fixed = sample.pose.camera_from_lidar;
  const auto apart = [&](const Vector3d& axis) {
    const Vector3d a = model.rotation * axis, c = fixed.rotation * axis;
    return std::atan2(a.cross(c).norm(), a.dot(c));
  };
  position.fixed_pose = fixed;
  position.centre_m = (model.translation_m - fixed.translation_m).norm();
  position.z_axis_rad = apart(Vector3d::UnitZ());
  position.x_axis_rad = apart(Vector3d::UnitX());
}

void add(MeanMax& sum, double value, double count) {
  sum.mean += value / count;
  sum.max = std::max(sum.max, value);
}

double corner_squares(const TurntableFeatures& features, const TurntableCalibration& result,
                      const KeptCorners& corners, double& count) {
  double sum = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    for (const auto& c : corners[b]) {
      const Vector2d seen = features.camera.project(result.camera_from_board[b] * c.board_m);
      sum += (seen - c.seen_px).squaredNorm();
      count += 2;
    }
  }
  return sum;
}

/// Residuals of all positions, rms of all points, Table 1.
void measure(const TurntableFeatures& features, const std::vector<Sample>& samples,
             const KeptCorners& corners, TurntableCalibration& result) {
  double stripe = 0, stripes = 0, lidar = 0, returns = 0, corner_count = 0;
  const auto used = static_cast<double>(result.positions_used);
  for (const auto& sample : samples) {
    PositionResult& position = result.positions[sample.index];
    SampleFit fit;
    describe(features, result, sample, position, fit);
    if (!position.used) continue;
    for (std::size_t b = 0; b < 2; ++b) {
      stripe += fit.stripe_squares[b];
      stripes += sample.stripes[b].count;
      lidar += fit.lidar_squares[b];
      returns += static_cast<double>(sample.returns.on_board[b].size());
    }
    add(result.table1.centre_mm, 1e3 * position.centre_m, used);
    add(result.table1.z_axis_deg, degrees(position.z_axis_rad), used);
    add(result.table1.x_axis_deg, degrees(position.x_axis_rad), used);
  }
  const double corner = corner_squares(features, result, corners, corner_count);
  result.rms = {std::sqrt(corner / corner_count), std::sqrt(stripe / stripes),
                1e3 * std::sqrt(lidar / returns)};
}

void take_positions(const TurntableFeatures& features, const Prepared& prepared,
                    TurntableCalibration& result) {
  for (std::size_t i = 0; i < features.positions.size(); ++i) {
    PositionResult position;
    position.name = features.positions[i].name;
    position.turntable_rad = features.positions[i].turntable_rad;
    position.used = prepared.reasons[i].empty();
    position.reason = prepared.reasons[i];
    result.positions.push_back(std::move(position));
  }
}

void count_positions(TurntableCalibration& result) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& position : result.positions) {
    if (!position.used) {
      result.diagnostics.note("position left out",
                              fmt::format("{}: {}", position.name, position.reason));
      continue;
    }
    ++result.positions_used;
    low = std::min(low, position.turntable_rad);
    high = std::max(high, position.turntable_rad);
  }
  result.rig.first_turntable_rad = low;
  result.rig.last_turntable_rad = high;
}

TurntableNoiseModel model_of(const JointNoise& noise) {
  const auto root = [&](LineEffect e) {
    return std::sqrt(noise.effect[static_cast<std::size_t>(e)]);
  };
  using enum LineEffect;
  return {std::sqrt(noise.corner_px2),
          std::sqrt(noise.stripe_px2),
          std::sqrt(noise.range_m2),
          std::sqrt(noise.turntable_rad2 + noise.effect[kEffects - 1]),
          root(kStripeOffset),
          root(kStripeTilt),
          root(kLidarOffset),
          root(kLidarTilt),
          root(kLidarBow)};
}

void take_joint(const Refined& refined, const TurntableOptions& options,
                TurntableCalibration& result) {
  result.rig = refined.state.rig;
  result.camera_from_board = refined.state.camera_from_board;
  result.square_bias_m = refined.state.square_bias_m;
  for (const auto& [index, reason] : refined.left_out) {
    result.positions[index].used = false;
    result.positions[index].reason = reason;
  }
  std::vector<double> angles;
  for (std::size_t i = 0; i < refined.samples.size(); ++i) {
    result.positions[refined.samples[i].index].turntable_correction_rad =
        refined.state.correction_rad[i];
    angles.push_back(refined.samples[i].turntable_rad);
  }
  const GlobalMatrix& C = refined.solution.covariance;
  result.covariance_hessian = C.topLeftCorner<Rig::kParameters, Rig::kParameters>();
  result.covariance_jackknife =
      jackknife(refined.system, refined.noise, refined.unknowns, angles, options.jackknife_blocks)
          .topLeftCorner<Rig::kParameters, Rig::kParameters>();
  result.rig.covariance = result.covariance_hessian;
  result.square_bias_sigma_m = std::sqrt(C(kSquareAt, kSquareAt));
  result.noise = model_of(refined.noise);
  result.chi2_per_dof = refined.chi2_per_dof;
  result.line_chi2_per_dof = refined.line_chi2_per_dof;
  result.iterations = refined.iterations;
  result.converged = refined.converged;
  if (refined.corners_left_out > 0) {
    result.diagnostics.note("corner left out", "far from its board's pose",
                            refined.corners_left_out);
  }
}

}  // namespace

Result<TurntableCalibration> calibrate_turntable(const TurntableFeatures& features,
                                                 const TurntableOptions& options) {
  const auto prepared = prepare(features, options);
  if (!prepared) return tl::unexpected(prepared.error());
  TurntableCalibration result;
  result.method = options.method;
  result.first_board_ascending = prepared->ascending;
  result.first_board_decided = prepared->decided;
  take_positions(features, *prepared, result);
  for (std::size_t b = 0; b < 2; ++b) {
    result.camera_from_board[b] = prepared->boards[b].camera_from_board;
  }
  KeptCorners corners = all_corners(features);
  std::optional<Refined> refined;
  if (options.method == TurntableMethod::kJoint) {
    auto joint = refine(features, *prepared, options);
    if (!joint) return tl::unexpected(joint.error());
    refined = std::move(*joint);
    take_joint(*refined, options, result);
    corners = refined->corners;
  } else if (options.method == TurntableMethod::kClosedForm) {
    result.rig = prepared->motion.rig;
    result.converged = true;
  } else {
    const auto paper = rig_liu2023(poses_of(prepared->samples));
    if (!paper) return tl::unexpected(paper.error());
    result.rig = paper->rig;
    result.converged = true;
    if (paper->contradiction) {
      result.warnings.emplace_back("the paper's axes p_L and p_Z contradict each other");
    }
  }
  count_positions(result);
  measure(features, prepared->samples, corners, result);
  for (auto& words : advise(features, *prepared, result)) {
    result.warnings.push_back(std::move(words));
  }
  if (refined) {
    for (auto& words : advise_joint(*refined, result)) result.warnings.push_back(std::move(words));
  }
  return result;
}

}  // namespace scanfuse::calibrate
