#include "scanfuse/calibrate/refine.hpp"

#include <algorithm>

#include "scanfuse/calibrate/middle.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Vector3d;

constexpr double kOutlierChi2 = 40;  ///< of two degrees of freedom: one in 5e8 by chance

/// Corners within five deviations of their board's pose.
void keep_corners(const TurntableFeatures& features, const std::array<BoardPose, 2>& boards,
                  Refined& out) {
  const KeptCorners all = all_corners(features);
  for (std::size_t b = 0; b < 2; ++b) {
    std::vector<double> distances;
    for (const auto& corner : all[b]) {
      const Vector3d at = boards[b].camera_from_board * corner.board_m;
      distances.push_back((features.camera.project(at) - corner.seen_px).norm());
    }
    const double sigma = middle_of(distances) / 1.1774;  // of Rayleigh's distribution
    for (std::size_t i = 0; i < all[b].size(); ++i) {
      if (distances[i] <= 5.5 * sigma + 1e-6) {
        out.corners[b].push_back(all[b][i]);
      } else {
        ++out.corners_left_out;
      }
    }
  }
}

/// Noise of single points, from how they scatter about their own lines.
JointNoise point_noise(const JointSystem& system, const std::vector<Sample>& samples,
                       const TurntableOptions& options) {
  double stripe = 0, stripe_count = 0, range = 0, range_count = 0;
  for (const auto& sample : samples) {
    for (std::size_t b = 0; b < 2; ++b) {
      stripe += sample.stripes[b].scatter;
      stripe_count += sample.stripes[b].count - 2;
      range += sample.lines[b].scatter_m2;
      range_count += sample.lines[b].count - sample.lines[b].rank;
    }
  }
  const auto variance = [](double given, double squares, double count, double least) {
    if (given > 0) return given * given;
    return std::max(count > 0 ? squares / count : 0, least * least);
  };
  JointNoise noise;
  noise.corner_px2 =
      variance(options.corner_sigma_px, system.corner_squares, system.corner_rows - 12, 1e-3);
  noise.stripe_px2 = variance(options.stripe_sigma_px, stripe, stripe_count, 1e-3);
  noise.range_m2 = variance(options.range_sigma_m, range, range_count, 1e-6);
  noise.turntable_rad2 = options.turntable_sigma_rad * options.turntable_sigma_rad;
  return noise;
}

/// Effects from the middle of the rows' residuals: coarse, but blind to outliers.
void coarse_effects(const JointSystem& system, JointNoise& noise) {
  std::array<std::vector<double>, kEffects> excess;
  for (const auto& rows : system.samples) {
    for (const auto& row : rows) {
      if (row.effect == LineEffect::kNone) continue;
      const double points = row.stripe ? noise.stripe_px2 : noise.range_m2;
      // Quarter of the way up, so that up to half of the lines may be wrong.
      excess[static_cast<std::size_t>(row.effect)].push_back((row.y * row.y / 0.4549 - points) /
                                                             row.share);
    }
  }
  for (std::size_t k = 0; k + 1 < kEffects; ++k) {
    noise.effect[k] = excess[k].empty() ? 0 : std::max(0.0, middle_of(std::move(excess[k])));
  }
}

struct Worst {
  double chi2 = 0;
  std::string reason;
};

/// The line of a sample that fits worst, rows as they stand at the minimum.
Worst worst_line(const std::vector<JointRow>& rows, const JointNoise& noise) {
  Worst worst;
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const bool offset =
        rows[k].effect == LineEffect::kStripeOffset || rows[k].effect == LineEffect::kLidarOffset;
    if (!offset) continue;
    double chi2 = 0;
    for (std::size_t j = k; j < k + 2; ++j) {
      const double points = rows[j].stripe ? noise.stripe_px2 : noise.range_m2;
      chi2 += rows[j].y * rows[j].y /
              (points + rows[j].share * noise.effect[static_cast<std::size_t>(rows[j].effect)]);
    }
    if (chi2 <= worst.chi2) continue;
    const int board = rows[k].a.segment<6>(kBoardAt).isZero(0) ? 2 : 1;
    const double off = std::abs(rows[k].y) / std::sqrt(rows[k].share);
    worst = {chi2, rows[k].stripe
                       ? fmt::format("its stripe on board {} lies {:.2f} px from where all others "
                                     "put it, or is turned",
                                     board, off)
                       : fmt::format("its returns on board {} lie {:.2f} mm from where all others "
                                     "put them, or are turned",
                                     board, 1e3 * off)};
  }
  return worst;
}

/// Takes out the samples whose worst line contradicts the rest by more than the noise allows. True
/// where there were any.
bool drop_outliers(const JointNoise& noise, Refined& out) {
  std::vector<Sample> kept;
  JointState state = out.state;
  state.correction_rad.clear();
  for (std::size_t i = 0; i < out.samples.size(); ++i) {
    const Worst worst = worst_line(out.system.samples[i], noise);
    if (worst.chi2 > kOutlierChi2) {
      out.left_out.emplace_back(out.samples[i].index, worst.reason);
    } else {
      kept.push_back(std::move(out.samples[i]));
      state.correction_rad.push_back(out.state.correction_rad[i]);
    }
  }
  const bool any = kept.size() < out.samples.size();
  out.samples = std::move(kept);
  out.state = std::move(state);
  return any;
}

void step(const Camera& camera, bool robust, Refined& out) {
  const JointInput input{camera, out.samples, out.corners};
  JointRun run = minimise(input, out.state, out.noise, out.unknowns, robust);
  out.state = std::move(run.state);
  out.iterations += run.iterations;
  out.converged = run.converged;
  out.system = linearise(input, out.state);
}

/// A systematic error is an unknown where the data show it by four standard deviations; where they
/// do not, it is taken for nothing, whatever an earlier round made of it.
void choose_unknowns(const TurntableOptions& options, Refined& out) {
  const auto decide = [&](Systematic wish, bool JointUnknowns::* which, int parameter,
                          double& value, double nothing) {
    if (wish != Systematic::kSignificant) return;
    JointUnknowns with = out.unknowns;
    with.*which = true;
    const JointNoise noise =
        options.line_effects ? estimate_effects(out.system, out.noise, with) : out.noise;
    const JointSolution trial = solve(out.system, noise, with);
    const double sigma = std::sqrt(trial.covariance(parameter, parameter));
    const double off = value - nothing + trial.change[parameter];
    out.unknowns.*which = sigma > 0 && std::abs(off) > 4 * sigma;
    if (!(out.unknowns.*which)) value = nothing;
  };
  Rig& rig = out.state.rig;
  decide(options.range_bias, &JointUnknowns::range_bias, 10, rig.range_bias_m, 0);
  decide(options.square_bias, &JointUnknowns::square_bias, kSquareAt, out.state.square_bias_m, 0);
  decide(options.angle_scale, &JointUnknowns::angle_scale, 11, rig.angle_scale, 1);
}

void judge(Refined& out) {
  double squares = out.system.corner_squares / out.noise.corner_px2;
  double count = out.system.corner_rows;
  for (const auto& sample : out.samples) {
    for (std::size_t b = 0; b < 2; ++b) {
      squares += sample.stripes[b].scatter / out.noise.stripe_px2 +
                 sample.lines[b].scatter_m2 / out.noise.range_m2;
      count += sample.stripes[b].count - 2 + sample.lines[b].count - sample.lines[b].rank;
    }
  }
  JointNoise white = out.noise;
  white.effect.fill(0);
  const JointSolution plain = solve(out.system, white, out.unknowns);
  const auto fits = fit_rows(out.system, white, plain);
  double lines = 0, free = 0;
  for (const auto& rows : fits) {
    for (const auto& fit : rows) {
      lines += fit.residual * fit.residual / fit.variance;
      free += 1 - fit.leverage;
    }
  }
  out.line_chi2_per_dof = lines / std::max(free, 1.0);
  out.chi2_per_dof = (squares + lines) / (count - 12 + free);
}

}  // namespace

KeptCorners all_corners(const TurntableFeatures& features) {
  KeptCorners corners;
  for (std::size_t b = 0; b < 2; ++b) {
    const auto columns = static_cast<std::size_t>(features.boards[b].columns);
    for (std::size_t i = 0; i < features.corners_px[b].size(); ++i) {
      corners[b].push_back(
          {Vector3d(static_cast<double>(i % columns), static_cast<double>(i / columns), 0) *
               features.boards[b].square_m,
           features.corners_px[b][i]});
    }
  }
  return corners;
}

void mark_squares(const std::array<BoardSpec, 2>& specs, const JointState& state,
                  std::vector<Sample>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Pose3 lidar = state.rig.pose(samples[i].turntable_rad + state.correction_rad[i]);
    for (std::size_t b = 0; b < 2; ++b) {
      const Pose3 board_from_lidar = state.camera_from_board[b].inverse() * lidar;
      std::vector<double> marks;
      for (const auto& r : samples[i].returns.on_board[b]) {
        // Where the ray meets the board: an error of the range would move the place along the line.
        const Vector3d ray =
            board_from_lidar.rotation * Vector3d(std::cos(r.angle_rad), std::sin(r.angle_rad), 0);
        const Vector3d& from = board_from_lidar.translation_m;
        const Vector3d at = from - from.z() / ray.z() * ray;
        const double column = std::floor(at.x() / specs[b].square_m);
        const double row = std::floor(at.y() / specs[b].square_m);
        const bool outside =
            column < -1 || row < -1 || column >= specs[b].columns || row >= specs[b].rows;
        const bool like_first = std::fmod(std::abs(column + row), 2) < 0.5;
        marks.push_back(outside ? 0 : like_first ? 0.5 : -0.5);
      }
      const auto line = fit_returns(samples[i].returns.on_board[b], marks);
      if (line) samples[i].lines[b] = *line;
    }
  }
}

Result<Refined> refine(const TurntableFeatures& features, const Prepared& prepared,
                       const TurntableOptions& options) {
  Refined out;
  keep_corners(features, prepared.boards, out);
  out.samples = prepared.samples;
  out.state.rig = prepared.motion.rig;
  for (std::size_t b = 0; b < 2; ++b) {
    out.state.camera_from_board[b] = prepared.boards[b].camera_from_board;
  }
  out.state.correction_rad.assign(out.samples.size(), 0);
  mark_squares(features.boards, out.state, out.samples);
  out.unknowns.range_bias = options.range_bias == Systematic::kOn;
  out.unknowns.square_bias = options.square_bias == Systematic::kOn;
  out.unknowns.angle_scale = options.angle_scale == Systematic::kOn;

  const auto measure = [&] {
    const auto effect = out.noise.effect;
    out.system = linearise({features.camera, out.samples, out.corners}, out.state);
    out.noise = point_noise(out.system, out.samples, options);
    out.noise.effect = effect;
  };
  // Roughly right in spite of bad frames, which then are left out.
  for (int round = 0; round < 4; ++round) {
    measure();
    coarse_effects(out.system, out.noise);
    step(features.camera, true, out);
    coarse_effects(out.system, out.noise);
    if (!drop_outliers(out.noise, out)) break;
    if (out.samples.size() < 3) break;
  }
  // Then at the noise that the data show.
  for (int round = 0; round < 4 && out.samples.size() >= 3; ++round) {
    mark_squares(features.boards, out.state, out.samples);  // where they stand by now
    measure();
    choose_unknowns(options, out);
    // At the values just decided on; the minimum itself follows.
    out.system = linearise({features.camera, out.samples, out.corners}, out.state);
    out.noise.effect.fill(0);
    if (options.line_effects) {
      out.noise = estimate_effects(out.system, out.noise, out.unknowns);
    }
    step(features.camera, false, out);
    JointNoise wide = out.noise;  // what lines share is no outlier, even where it is not modelled
    if (!options.line_effects) coarse_effects(out.system, wide);
    if (round > 0 && !drop_outliers(wide, out)) break;
  }
  if (out.samples.size() < 3) {
    return fail(Error::Code::kOutOfRange,
                "only {} positions agree with each other and 3 are needed; {}: {}",
                out.samples.size(), features.positions[out.left_out.front().first].name,
                out.left_out.front().second);
  }
  out.solution = solve(out.system, out.noise, out.unknowns);
  judge(out);
  return out;
}

}  // namespace scanfuse::calibrate
