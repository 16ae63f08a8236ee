#include "scanfuse/calibrate/cloud/disc_likelihood.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::calibrate {
namespace {

constexpr double kStray = 1e-4;
constexpr std::array<double, 4> kSoftness{1.0, 0.5, 0.3, 0.2};  // shares of the beams' spacing
constexpr int kMostSteps = 60;
/// The spot's band is at most a few beams wide; keeps it in bounds where no edge is backed.
constexpr double kSpotPrior = 2;

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }
double normal_pdf(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * kPi); }

/// Chances of one beam and their slopes along d and w.
struct Chances {
  double on = 0, beyond = 0, mixed = 0;
  double on_d = 0, beyond_d = 0;
  double on_w = 0, beyond_w = 0;
};

Chances chances_at(double d, double w, double s) {
  const double z1 = (-d - w) / s, z2 = (d - w) / s;
  Chances c;
  c.on = normal_cdf(z1);
  c.beyond = normal_cdf(z2);
  c.mixed = std::max(1 - c.on - c.beyond, 0.0);
  c.on_d = -normal_pdf(z1) / s;
  c.beyond_d = normal_pdf(z2) / s;
  c.on_w = -normal_pdf(z1) / s;
  c.beyond_w = -normal_pdf(z2) / s;
  return c;
}

/// Sum over beams: log-likelihood, its gradient, and the information (expected).
struct Likelihood {
  double value = 0;
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
};

struct Outcome {
  double chance, d, w;
};

double out_of(const EdgeBeam& beam, const DiscEdge& edge, const EdgeShift& shift) {
  const double distance = std::max((beam.place_m - edge.centre_m).norm(), 1e-9);
  return distance - edge.radius_m - (beam.backed ? shift.backed_m : shift.unbacked_m);
}

void add_beam(Likelihood& sum, const EdgeBeam& beam, const DiscEdge& edge, double s,
              const EdgeShift& shift) {
  const Eigen::Vector2d from = beam.place_m - edge.centre_m;
  const double distance = std::max(from.norm(), 1e-9);
  const double d = out_of(beam, edge, shift), w = beam.backed ? edge.spot_m : 0;
  if (std::abs(d) > w + 8 * s && (d > 0) != (beam.state == BeamState::kOn)) return;
  const Chances c = chances_at(d, w, s);
  const double with_w = beam.backed ? 1 : 0;
  const std::array<Outcome, 3> outcomes{
      {{c.on, c.on_d, c.on_w * with_w},
       {c.mixed, -c.on_d - c.beyond_d, -(c.on_w + c.beyond_w) * with_w},
       {c.beyond, c.beyond_d, c.beyond_w * with_w}}};
  const std::size_t seen = beam.state == BeamState::kOn      ? 0
                           : beam.state == BeamState::kMixed ? 1
                                                             : 2;
  const Eigen::Vector3d slope(-from.x() / distance, -from.y() / distance, -1);
  for (std::size_t k = 0; k < 3; ++k) {
    const Outcome& o = outcomes[k];
    const double chance = kStray + (1 - 3 * kStray) * std::max(o.chance, 0.0);
    Eigen::Vector4d g;
    g << slope * o.d, o.w;
    sum.information += g * g.transpose() / chance;
    if (k != seen) continue;
    sum.value += std::log(chance);
    sum.gradient += g / chance;
  }
}

Likelihood likelihood_of(std::span<const EdgeBeam> beams, const DiscEdge& edge, double s,
                         double spacing_m, const EdgeShift& shift) {
  Likelihood sum;
  for (const EdgeBeam& beam : beams) add_beam(sum, beam, edge, s, shift);
  const double sigma = kSpotPrior * spacing_m;
  sum.value -= 0.5 * edge.spot_m * edge.spot_m / (sigma * sigma);
  sum.gradient[3] -= edge.spot_m / (sigma * sigma);
  sum.information(3, 3) += 1 / (sigma * sigma);
  return sum;
}

DiscEdge moved(const DiscEdge& edge, const Eigen::Vector4d& step) {
  DiscEdge next = edge;
  next.centre_m += step.head<2>();
  next.radius_m += step[2];
  next.spot_m = std::max(next.spot_m + step[3], 0.0);
  return next;
}

/// Fisher scoring with damping at one softness.
void climb(std::span<const EdgeBeam> beams, DiscEdge& edge, double s, double spacing_m,
           const EdgeShift& shift) {
  Likelihood at = likelihood_of(beams, edge, s, spacing_m, shift);
  double damping = 1e-3;
  edge.converged = false;
  for (int k = 0; k < kMostSteps; ++k) {
    Eigen::Matrix4d damped = at.information;
    damped.diagonal() *= 1 + damping;
    damped.diagonal().array() += 1e-6 / (spacing_m * spacing_m);
    Eigen::Vector4d step = damped.ldlt().solve(at.gradient);
    step *= std::min(1.0, spacing_m / std::max(step.norm(), 1e-12));
    const DiscEdge next = moved(edge, step);
    const Likelihood there = likelihood_of(beams, next, s, spacing_m, shift);
    if (there.value >= at.value) {
      edge = next;
      at = there;
      damping = std::max(damping * 0.3, 1e-9);
      edge.converged = step.norm() < 1e-5 * spacing_m;
      if (edge.converged) break;
    } else {
      damping *= 10;
      edge.converged = damping > 1e8;
      if (edge.converged) break;
    }
  }
  edge.log_likelihood = at.value;
  edge.covariance = at.information.inverse();
}

}  // namespace

DiscEdge fit_disc_edge(std::span<const EdgeBeam> beams, const DiscEdge& start, double spacing_m,
                       const EdgeShift& shift) {
  DiscEdge edge = start;
  for (const double share : kSoftness) climb(beams, edge, share * spacing_m, spacing_m, shift);
  int unbacked = 0;
  edge.edge_beams = 0;
  for (const EdgeBeam& beam : beams) {
    if (std::abs(out_of(beam, edge, shift)) > 2 * edge.spot_m + spacing_m) continue;
    ++edge.edge_beams;
    unbacked += beam.backed ? 0 : 1;
  }
  edge.unbacked_share = edge.edge_beams > 0 ? static_cast<double>(unbacked) / edge.edge_beams : 0;
  return edge;
}

}  // namespace scanfuse::calibrate
