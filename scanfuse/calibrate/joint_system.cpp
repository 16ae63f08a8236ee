#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "scanfuse/calibrate/joint.hpp"

namespace scanfuse::calibrate {
namespace {

double point_variance(const JointRow& row, const JointNoise& noise) {
  return row.stripe ? noise.stripe_px2 : noise.range_m2;
}

double variance_of(const JointRow& row, const JointNoise& noise) {
  if (row.effect == LineEffect::kNone) return point_variance(row, noise);
  return point_variance(row, noise) +
         row.share * noise.effect[static_cast<std::size_t>(row.effect)];
}

double angle_variance(const JointNoise& noise) {
  return noise.turntable_rad2 + noise.effect[kEffects - 1];
}

/// Inverse over the unknowns, zero elsewhere. Directions that nothing observes get no variance at
/// all, and `definite` says so.
GlobalMatrix invert(GlobalMatrix N, const JointUnknowns& unknowns, bool& definite) {
  GlobalVector scale;
  for (int k = 0; k < kGlobal; ++k) {
    const bool active = unknowns.active(k) && N(k, k) > 0;
    if (unknowns.active(k) && !active) definite = false;
    scale[k] = active ? 1 / std::sqrt(N(k, k)) : 0;
  }
  N = scale.asDiagonal() * N * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(N);  // 25 x 25: compiled once
  GlobalVector inverse = GlobalVector::Zero();
  for (int k = 0; k < kGlobal; ++k) {
    const double value = solver.eigenvalues()[k];
    if (value > 1e-12) inverse[k] = 1 / value;
  }
  const auto unseen = (inverse.array() == 0).count();
  definite = definite && unseen == (scale.array() == 0).count();
  const GlobalMatrix V = solver.eigenvectors();
  const GlobalMatrix C = V * inverse.asDiagonal() * V.transpose();
  return scale.asDiagonal() * C * scale.asDiagonal();
}

/// One step for one variance: score over information, off-diagonal terms of the latter left out
/// (they change the step, not where it ends).
struct Score {
  double score = 0;
  double information = 0;
};

std::array<Score, kEffects> scores(const JointSystem& system, const JointNoise& noise,
                                   const JointSolution& solution) {
  std::array<Score, kEffects> all{};
  const auto fits = fit_rows(system, noise, solution);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    for (std::size_t k = 0; k < fits[i].size(); ++k) {
      const bool prior = k == system.samples[i].size();
      const auto effect = prior ? LineEffect::kTurntable : system.samples[i][k].effect;
      if (effect == LineEffect::kNone) continue;
      const RowFit& fit = fits[i][k];
      const double share = prior ? 1 : system.samples[i][k].share;
      const double part = share * (1 - fit.leverage) / fit.variance;
      Score& s = all[static_cast<std::size_t>(effect)];
      s.score += share * std::pow(fit.residual / fit.variance, 2) - part;
      s.information += part * part;
    }
  }
  return all;
}

}  // namespace

SampleInformation inform(const std::vector<JointRow>& rows, double correction_rad,
                         const JointNoise& noise) {
  SampleInformation out;
  out.angle_information = 1 / angle_variance(noise);
  out.angle_right = -correction_rad / angle_variance(noise);
  for (const auto& row : rows) {
    const double w = 1 / variance_of(row, noise);
    out.information.noalias() += w * row.a * row.a.transpose();
    out.right += w * row.y * row.a;
    out.coupling += w * row.angle * row.a;
    out.angle_information += w * row.angle * row.angle;
    out.angle_right += w * row.angle * row.y;
  }
  out.information -= out.coupling * out.coupling.transpose() / out.angle_information;
  out.right -= out.coupling * out.angle_right / out.angle_information;
  return out;
}

JointSolution solve(const JointSystem& system, const JointNoise& noise,
                    const JointUnknowns& unknowns) {
  JointSolution out;
  GlobalMatrix N = system.corner_information / noise.corner_px2;
  GlobalVector right = system.corner_right / noise.corner_px2;
  for (std::size_t i = 0; i < system.samples.size(); ++i) {
    out.parts.push_back(inform(system.samples[i], system.correction_rad[i], noise));
    N += out.parts.back().information;
    right += out.parts.back().right;
  }
  out.covariance = invert(N, unknowns, out.definite);
  out.change = out.covariance * right;
  for (const auto& part : out.parts) {
    out.angle_change_rad.push_back((part.angle_right - part.coupling.dot(out.change)) /
                                   part.angle_information);
  }
  return out;
}

std::vector<std::vector<RowFit>> fit_rows(const JointSystem& system, const JointNoise& noise,
                                          const JointSolution& solution) {
  std::vector<std::vector<RowFit>> fits(system.samples.size());
  for (std::size_t i = 0; i < system.samples.size(); ++i) {
    const SampleInformation& part = solution.parts[i];
    const GlobalVector with_angle = -solution.covariance * part.coupling / part.angle_information;
    const double angle_variance_now =
        1 / part.angle_information - part.coupling.dot(with_angle) / part.angle_information;
    const double change = solution.angle_change_rad[i];
    for (const auto& row : system.samples[i]) {
      const double variance = variance_of(row, noise);
      const double fitted = row.a.dot(solution.covariance * row.a) +
                            2 * row.angle * row.a.dot(with_angle) +
                            row.angle * row.angle * angle_variance_now;
      fits[i].push_back(
          {row.y - row.a.dot(solution.change) - row.angle * change, variance, fitted / variance});
    }
    const double variance = angle_variance(noise);
    fits[i].push_back(
        {-system.correction_rad[i] - change, variance, angle_variance_now / variance});
  }
  return fits;
}

JointNoise estimate_effects(const JointSystem& system, JointNoise noise,
                            const JointUnknowns& unknowns) {
  for (int round = 0; round < 60; ++round) {
    const auto step = scores(system, noise, solve(system, noise, unknowns));
    double moved = 0;
    for (std::size_t k = 0; k < kEffects; ++k) {
      if (!(step[k].information > 0)) continue;
      const double before = noise.effect[k];
      const double after = std::max(0.0, before + step[k].score / step[k].information);
      noise.effect[k] = after;
      const double deviation = std::sqrt(2 / step[k].information);  // of the estimate itself
      moved = std::max(moved, std::abs(after - before) / deviation);
    }
    if (moved < 1e-3) break;
  }
  return noise;
}

GlobalMatrix jackknife(const JointSystem& system, const JointNoise& noise,
                       const JointUnknowns& unknowns, const std::vector<double>& turntable_rad,
                       int blocks) {
  const JointSolution all = solve(system, noise, unknowns);
  std::vector<std::size_t> order(system.samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return turntable_rad[a] < turntable_rad[b];
  });
  GlobalMatrix total = system.corner_information / noise.corner_px2;
  GlobalVector total_right = system.corner_right / noise.corner_px2;
  for (const auto& part : all.parts) {
    total += part.information;
    total_right += part.right;
  }
  const std::size_t count = std::min(order.size(), static_cast<std::size_t>(blocks));
  GlobalMatrix sum = GlobalMatrix::Zero();
  std::vector<GlobalVector> without;
  GlobalVector mean = GlobalVector::Zero();
  for (std::size_t block = 0; block < count; ++block) {
    GlobalMatrix N = total;
    GlobalVector right = total_right;
    const std::size_t first = block * order.size() / count;
    const std::size_t last = (block + 1) * order.size() / count;
    for (std::size_t i = first; i < last; ++i) {
      N -= all.parts[order[i]].information;
      right -= all.parts[order[i]].right;
    }
    bool definite = true;
    without.emplace_back(invert(N, unknowns, definite) * right);
    mean += without.back() / static_cast<double>(count);
  }
  for (const auto& x : without) sum += (x - mean) * (x - mean).transpose();
  const double n = static_cast<double>(count);
  const GlobalMatrix corners =
      all.covariance * (system.corner_information / noise.corner_px2) * all.covariance;
  return (n - 1) / n * sum + corners;
}

}  // namespace scanfuse::calibrate
