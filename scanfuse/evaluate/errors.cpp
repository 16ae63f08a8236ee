#include "scanfuse/evaluate/errors.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace scanfuse::evaluate {
namespace {

// 2.5 and 97.5 % points of the chi-square distribution with 4 degrees of freedom.
constexpr double kNeesLow = 0.4844185570879299;
constexpr double kNeesHigh = 11.143286781877796;

/// A mean of squares that leaves out what is not finite.
struct SquareMean {
  double sum = 0;
  std::int64_t count = 0;

  void add(double error) {
    if (!std::isfinite(error)) return;
    sum += error * error;
    ++count;
  }
  [[nodiscard]] std::optional<double> root() const {
    if (count == 0) return std::nullopt;
    return std::sqrt(sum / static_cast<double>(count));
  }
};

struct ErrorSums {
  SquareMean position, velocity, heading, heading_mod_pi, length, width;
  std::int64_t reversed = 0;

  void add(const Track& track, const TruthObject& truth) {
    position.add((track.box.centre_m - truth.position_m).norm());
    if (truth.velocity_m_per_s) {
      const Eigen::Vector2d v(track.state.mean[1], track.state.mean[3]);
      velocity.add((v - *truth.velocity_m_per_s).norm());
    }
    if (truth.length_m) length.add(track.box.length_m - *truth.length_m);
    if (truth.width_m) width.add(track.box.width_m - *truth.width_m);
    const double turn = truth.heading_rad ? track.box.heading_rad - *truth.heading_rad : NAN;
    if (!std::isfinite(turn)) return;
    heading.add(wrap_pi(turn));
    heading_mod_pi.add(wrap_half_pi(turn));
    reversed += std::abs(wrap_pi(turn)) > kPi / 2 ? 1 : 0;
  }
};

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::vector<double> innovations(const Sequence& sequence) {
  std::vector<double> values;
  for (const auto& frame : sequence.frames) {
    for (const auto& track : frame.tracks) {
      if (track.detection >= 0 && std::isfinite(track.nis)) values.push_back(track.nis);
    }
  }
  return values;
}

}  // namespace

std::optional<double> nees(const Track& track, const TruthObject& truth) {
  if (!truth.velocity_m_per_s) return std::nullopt;
  const Eigen::Vector2d p = truth.position_m, v = *truth.velocity_m_per_s;
  const Eigen::Vector4d error = track.state.mean - Eigen::Vector4d(p.x(), v.x(), p.y(), v.y());
  if (!error.allFinite() || !track.state.covariance.allFinite()) return std::nullopt;
  const Eigen::LLT<Eigen::Matrix4d> root(track.state.covariance);
  if (root.info() != Eigen::Success) return std::nullopt;
  const double value = root.matrixL().solve(error).squaredNorm();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

RmseMetrics rmse_metrics(const Sequence& sequence,
                         const std::vector<std::vector<MatchedPair>>& matches) {
  ErrorSums sums;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    for (const auto& pair : matches[k]) sums.add(frame.tracks[pair.track], frame.truth[pair.truth]);
  }
  RmseMetrics rmse;
  rmse.position_m = sums.position.root();
  rmse.velocity_m_per_s = sums.velocity.root();
  rmse.heading_rad = sums.heading.root();
  rmse.heading_mod_pi_rad = sums.heading_mod_pi.root();
  rmse.length_m = sums.length.root();
  rmse.width_m = sums.width.root();
  rmse.pairs = sums.position.count;
  if (sums.heading.count > 0) {
    rmse.heading_reversed_share =
        static_cast<double>(sums.reversed) / static_cast<double>(sums.heading.count);
  }
  return rmse;
}

ConsistencyMetrics consistency_metrics(const Sequence& sequence,
                                       const std::vector<std::vector<MatchedPair>>& matches) {
  std::vector<double> values;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    for (const auto& pair : matches[k]) {
      const auto value = nees(frame.tracks[pair.track], frame.truth[pair.truth]);
      if (value) values.push_back(*value);
    }
  }
  const auto nis = innovations(sequence);
  ConsistencyMetrics result;
  result.anees = mean_of(values);
  result.nees_median = median_of(values);
  result.anis = mean_of(nis);
  result.nees_samples = static_cast<std::int64_t>(values.size());
  result.nis_samples = static_cast<std::int64_t>(nis.size());
  if (!values.empty()) {
    const auto inside = std::count_if(values.begin(), values.end(), [](double value) {
      return value >= kNeesLow && value <= kNeesHigh;
    });
    result.nees_inside_95 = static_cast<double>(inside) / static_cast<double>(values.size());
  }
  return result;
}

}  // namespace scanfuse::evaluate
