#include "scanfuse/triangulate/growth.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "scanfuse/estimate/consistency.hpp"

namespace scanfuse::triangulate {

Gate::Gate(double probability, std::size_t sensors) : limits_(2 * sensors + 2, 0) {
  for (std::size_t dof = 1; dof < limits_.size(); ++dof) {
    limits_[dof] = estimate::chi_square_quantile(probability, static_cast<std::int64_t>(dof));
  }
}

bool nearly_parallel(const LineOfSight& a, const LineOfSight& b) {
  constexpr double kLeastParallax = 1.5;
  const double blur = a.sigma_left_rad + b.sigma_left_rad + a.sigma_up_rad + b.sigma_up_rad;
  return a.direction.cross(b.direction).norm() < kLeastParallax * blur;
}

std::optional<ClosestPoints> meeting(const LineOfSight& a, const LineOfSight& b, double sigmas) {
  if (nearly_parallel(a, b)) return std::nullopt;
  auto met = closest_points(a, b);
  if (met && met->sigmas_apart > kSlack * sigmas) met.reset();
  return met;
}

std::optional<Agreement> agreement_of(const LineOfSight& line, const Location& at) {
  const auto seen = sight(line, at.position_m);
  if (!seen) return std::nullopt;
  Eigen::Matrix2d spread =
      seen->jacobian_rad_per_m * at.covariance_m2 * seen->jacobian_rad_per_m.transpose();
  spread(0, 0) += line.sigma_left_rad * line.sigma_left_rad;
  spread(1, 1) += line.tells_elevation() ? line.sigma_up_rad * line.sigma_up_rad : 1;
  const Eigen::Vector2d& d = seen->offset_rad;
  const double determinant = spread.determinant();
  return Agreement{(d.x() * d.x() * spread(1, 1) - 2 * d.x() * d.y() * spread(0, 1) +
                    d.y() * d.y() * spread(0, 0)) /
                       determinant,
                   determinant};
}

int degrees_of_freedom(std::span<const LineOfSight> lines, const ScenePrior& prior) {
  int measured = prior.flat ? 1 : 0;
  for (const LineOfSight& line : lines) measured += line.dimensions();
  return std::max(measured - 3, 1);
}

double weight_of(const Cost& cost, const Hypothesis& h, const PassiveScene& scene,
                 const ScenePrior& prior) {
  return std::visit([&](const auto& policy) { return policy(h, scene, prior); }, cost);
}

}  // namespace scanfuse::triangulate
