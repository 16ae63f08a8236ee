#include "scanfuse/triangulate/costs.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "scanfuse/triangulate/divergence.hpp"

namespace scanfuse::triangulate {
namespace {

const double kLog2Pi = std::log(2 * kPi);

/// Calls visit(place) for the sensors that look at the target and took no part.
template <class Visit>
void for_missing(const Hypothesis& h, const PassiveScene& scene, Visit&& visit) {
  std::size_t member = 0;
  for (std::size_t s = 0; s < scene.sensors.size(); ++s) {
    if (member < h.lines.size() && h.lines[member].sensor == static_cast<std::int32_t>(s)) {
      ++member;
    } else if (in_field_of_view(scene.sensors[s], h.location.position_m)) {
      visit(s);
    }
  }
}

/// sum ln(1 - PD) over them.
double log_misses(const Hypothesis& h, const PassiveScene& scene, const ScenePrior& prior) {
  double sum = 0;
  for_missing(h, scene, [&](std::size_t s) { sum += prior.sensors[s].log_missed; });
  return sum;
}

/// Whether no sensor that never misses (PD = 1) is among them.
bool certain_sensors_took_part(const Hypothesis& h, const PassiveScene& scene) {
  bool all = true;
  for_missing(h, scene,
              [&](std::size_t s) { all = all && scene.sensors[s].detection_probability < 1; });
  return all;
}

/// ln PD - ln lambda.
double log_detection(const LineOfSight& line, const ScenePrior& prior) {
  const SensorPrior& sensor = prior.sensors[static_cast<std::size_t>(line.sensor)];
  return sensor.log_detected - sensor.log_clutter;
}

/// ln of the chance that the target is in the volume, axis by axis.
double log_inside(const Location& at, const ScenePrior& prior) {
  constexpr double kLeast = -700;
  double sum = 0;
  for (int k = 0; k < (prior.flat ? 2 : 3); ++k) {
    const double sigma = std::sqrt(2 * at.covariance_m2(k, k));
    const auto& [low, high] = prior.volume_m[static_cast<std::size_t>(k)];
    const double a = (low - at.position_m[k]) / sigma, b = (high - at.position_m[k]) / sigma;
    // erfc of the nearer side keeps the small figures of a place far outside.
    const double share = a > 0   ? (std::erfc(a) - std::erfc(b)) / 2
                         : b < 0 ? (std::erfc(-b) - std::erfc(-a)) / 2
                                 : (std::erf(b) - std::erf(a)) / 2;
    sum += share > 0 ? std::log(share) : kLeast;
  }
  return std::max(sum, kLeast);
}

/// A measurement in its tangent plane, azimuth only: the second entry does not count.
struct Residual {
  Eigen::Vector2d off = Eigen::Vector2d::Zero();
  Eigen::Matrix2d noise = Eigen::Matrix2d::Identity();   ///< R
  Eigen::Matrix2d pseudo = Eigen::Matrix2d::Identity();  ///< J P J'
  int dimensions = 2;
};

std::optional<Residual> residual(const LineOfSight& line, const Eigen::Vector3d& position_m,
                                 const Eigen::Matrix3d& covariance_m2) {
  const auto seen = sight(line, position_m);
  if (!seen) return std::nullopt;
  Residual r;
  r.off = seen->offset_rad;
  r.dimensions = line.dimensions();
  r.noise(0, 0) = line.sigma_left_rad * line.sigma_left_rad;
  if (line.tells_elevation()) r.noise(1, 1) = line.sigma_up_rad * line.sigma_up_rad;
  r.pseudo = seen->jacobian_rad_per_m * covariance_m2 * seen->jacobian_rad_per_m.transpose();
  if (!line.tells_elevation()) r.pseudo(1, 1) = 1;  // alike in both: takes no part
  return r;
}

constexpr double kImpossible = -1e9;

/// sum over the members of ln PD - ln lambda - ln |2 pi R| / 2 - `distance(residual)` / 2.
template <class Distance>
double weigh(const Hypothesis& h, const ScenePrior& prior, const Eigen::Vector3d& position_m,
             const Eigen::Matrix3d& covariance_m2, Distance&& distance) {
  double sum = 0;
  for (const LineOfSight& line : h.lines) {
    const auto r = residual(line, position_m, covariance_m2);
    if (!r) return kImpossible;
    sum += log_detection(line, prior) - line.log_spread() - distance(*r) / 2;
  }
  return sum;
}

double squared_distance(const Residual& r) {
  return r.off.x() * r.off.x() / r.noise(0, 0) +
         (r.dimensions == 2 ? r.off.y() * r.off.y() / r.noise(1, 1) : 0);
}

}  // namespace

double EvidenceCost::operator()(const Hypothesis& h, const PassiveScene& scene,
                                const ScenePrior& prior) const {
  double w = prior.log_intensity + log_misses(h, scene, prior) - h.location.chi2 / 2 +
             1.5 * kLog2Pi + std::log(h.location.covariance_m2.determinant()) / 2 +
             log_inside(h.location, prior);
  if (prior.flat) {
    // The height's prior is a Gaussian and stands in chi2 and P: its density in place of 1 /
    // height.
    w += std::log(prior.volume_m[2][1] - prior.volume_m[2][0]) -
         (kLog2Pi + std::log(prior.place.covariance(2, 2))) / 2;
  }
  for (const LineOfSight& line : h.lines) w += log_detection(line, prior) - line.log_spread();
  return w;
}

double ClassicCost::operator()(const Hypothesis& h, const PassiveScene& scene,
                               const ScenePrior& prior) const {
  return log_misses(h, scene, prior) +
         weigh(h, prior, h.location.position_m, h.location.covariance_m2, squared_distance);
}

double RenyiCost::operator()(const Hypothesis& h, const PassiveScene& scene,
                             const ScenePrior& prior) const {
  const Eigen::Vector3d x = least_squares(h.lines);
  const auto divergence = [this](const auto& p, const auto& q) { return renyi(p, q, alpha); };
  return log_misses(h, scene, prior) +
         weigh(h, prior, x, covariance_corrected(h.lines, x), [&](const Residual& r) {
           return symmetric(divergence, Gaussian<2>{r.off, r.noise},
                            Gaussian<2>{Eigen::Vector2d::Zero(), r.pseudo});
         });
}

double RenyiLiteralCost::operator()(const Hypothesis& h, const PassiveScene& scene,
                                    const ScenePrior& prior) const {
  const Eigen::Vector3d x = least_squares(h.lines);
  const Eigen::Matrix3d covariance = covariance_literal(h.lines);
  const auto divergence = [this](const auto& p, const auto& q) {
    return renyi_literal(p, q, alpha);
  };
  double cost = 0;
  for (const LineOfSight& line : h.lines) {
    const auto r = residual(line, x, covariance);
    if (!r) return kImpossible;
    const double spread = r->dimensions == 2 ? r->noise.determinant() : r->noise(0, 0);
    cost += kLog2Pi / 2 + std::log(spread) -
            prior.sensors[static_cast<std::size_t>(line.sensor)].log_detected +
            symmetric(divergence, Gaussian<2>{r->off, r->noise},
                      Gaussian<2>{Eigen::Vector2d::Zero(), r->pseudo}) /
                2;
  }
  const bool allowed = certain_sensors_took_part(h, scene);
  return allowed && std::isfinite(cost) ? -cost : kImpossible;
}

double LeaveOneOutCost::operator()(const Hypothesis& h, const PassiveScene& scene,
                                   const ScenePrior& prior) const {
  if (h.lines.size() < 3) return ClassicCost{}(h, scene, prior);
  double sum = log_misses(h, scene, prior);
  std::vector<LineOfSight> others;
  for (std::size_t s = 0; s < h.lines.size(); ++s) {
    others.assign(h.lines.begin(), h.lines.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
    const auto at = most_likely(others, h.location.position_m, prior.height());
    const auto r = at ? residual(h.lines[s], at->position_m, at->covariance_m2) : std::nullopt;
    if (!r) return kImpossible;
    const Eigen::Matrix2d spread = r->noise + r->pseudo;
    const double distance = r->dimensions == 2 ? r->off.dot(spread.inverse() * r->off)
                                               : r->off.x() * r->off.x() / spread(0, 0);
    const double size = r->dimensions == 2 ? spread.determinant() : spread(0, 0);
    sum += log_detection(h.lines[s], prior) -
           (r->dimensions * kLog2Pi + std::log(size) + distance) / 2;
  }
  return sum;
}

Cost make_cost(CostMethod method, double alpha) {
  switch (method) {
    case CostMethod::kClassic:
      return ClassicCost{};
    case CostMethod::kRenyiLiteral:
      return RenyiLiteralCost{std::min(alpha, 0.999)};
    case CostMethod::kRenyi:
      return RenyiCost{alpha};
    case CostMethod::kKullbackLeibler:
      return RenyiCost{1};
    case CostMethod::kLeaveOneOut:
      return LeaveOneOutCost{};
    case CostMethod::kEvidence:
      break;
  }
  return EvidenceCost{};
}

}  // namespace scanfuse::triangulate
