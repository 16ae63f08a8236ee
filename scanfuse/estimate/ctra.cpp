#include "scanfuse/estimate/ctra.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "scanfuse/estimate/gauss_legendre.hpp"
#include "scanfuse/estimate/turn_moments.hpp"

namespace scanfuse::estimate {
namespace {

using namespace ctra;

/// int_0^t exp(-s / tau) ds
double reach(double t, double tau) { return std::isinf(tau) ? t : -tau * std::expm1(-t / tau); }
double remaining(double t, double tau) { return std::isinf(tau) ? 1 : std::exp(-t / tau); }

bool lasts(const Fade& fade) {
  return std::isinf(fade.yaw_rate_tau_s) && std::isinf(fade.accel_tau_s);
}

/// Panels within which heading turns, and what fades falls, by no more than half a unit or so.
int panels_for(const CtraVector& x, double dt_s, const Fade& fade) {
  const double units =
      std::max({std::abs(x(kYawRate)) * dt_s, dt_s / fade.yaw_rate_tau_s, dt_s / fade.accel_tau_s});
  return static_cast<int>(std::clamp(std::ceil(2 * units), 1.0, 1e4));
}

/// psi, v, a, w after t; where it is does not matter to what follows.
CtraVector moving_state(const CtraVector& x, double t, const Fade& fade) {
  CtraVector at = x;
  at(kHeading) += x(kYawRate) * reach(t, fade.yaw_rate_tau_s);
  at(kSpeed) += x(kAccel) * reach(t, fade.accel_tau_s);
  at(kAccel) *= remaining(t, fade.accel_tau_s);
  at(kYawRate) *= remaining(t, fade.yaw_rate_tau_s);
  return at;
}

/// The direct influences on psi, v, a, w; and that heading turns the way gone.
CtraMatrix slope_without_places(double dx, double dy, double dt_s, const Fade& fade) {
  CtraMatrix F = CtraMatrix::Identity();
  F(kX, kHeading) = -dy;
  F(kY, kHeading) = dx;
  F(kHeading, kYawRate) = reach(dt_s, fade.yaw_rate_tau_s);
  F(kSpeed, kAccel) = reach(dt_s, fade.accel_tau_s);
  F(kAccel, kAccel) = remaining(dt_s, fade.accel_tau_s);
  F(kYawRate, kYawRate) = remaining(dt_s, fade.yaw_rate_tau_s);
  return F;
}

/// Unit ways: what a unit of v, a and w adds to the place.
struct Ways {
  Eigen::Vector2d speed = Eigen::Vector2d::Zero();
  Eigen::Vector2d accel = Eigen::Vector2d::Zero();
  Eigen::Vector2d yaw_rate = Eigen::Vector2d::Zero();
};

Transition<6> assemble(const CtraVector& x, double dt_s, const Fade& fade, const Ways& ways) {
  Transition<6> f{moving_state(x, dt_s, fade), CtraMatrix()};
  const Eigen::Vector2d way = x(kSpeed) * ways.speed + x(kAccel) * ways.accel;
  f.mean.head<2>() = x.head<2>() + way;
  f.F = slope_without_places(way.x(), way.y(), dt_s, fade);
  f.F.block<2, 1>(kX, kSpeed) = ways.speed;
  f.F.block<2, 1>(kX, kAccel) = ways.accel;
  f.F.block<2, 1>(kX, kYawRate) = ways.yaw_rate;
  return f;
}

}  // namespace

Transition<6> ctra_transition(const CtraVector& x, double dt_s) {
  const TurnMoments m = turn_moments(x(kYawRate) * dt_s);
  const double c = std::cos(x(kHeading)), s = std::sin(x(kHeading));
  const double T = dt_s, v = x(kSpeed), a = x(kAccel);
  Ways ways;
  ways.speed = T * Eigen::Vector2d(c * m.A0 - s * m.B0, s * m.A0 + c * m.B0);
  ways.accel = T * T * Eigen::Vector2d(c * m.A1 - s * m.B1, s * m.A1 + c * m.B1);
  const Eigen::Vector2d second(c * m.A2 - s * m.B2, s * m.A2 + c * m.B2);
  const Eigen::Vector2d bent = v * ways.accel + a * T * T * T * second;
  ways.yaw_rate = {-bent.y(), bent.x()};
  return assemble(x, dt_s, {}, ways);
}

Transition<6> ctra_transition(const CtraVector& x, double dt_s, const Fade& fade) {
  if (lasts(fade)) return ctra_transition(x, dt_s);
  Ways ways;
  for_each_node(dt_s, panels_for(x, dt_s, fade), [&](double t, double weight) {
    const CtraVector at = moving_state(x, t, fade);
    const double c = weight * std::cos(at(kHeading)), s = weight * std::sin(at(kHeading));
    ways.speed += Eigen::Vector2d(c, s);
    ways.accel += reach(t, fade.accel_tau_s) * Eigen::Vector2d(c, s);
    ways.yaw_rate += reach(t, fade.yaw_rate_tau_s) * at(kSpeed) * Eigen::Vector2d(-s, c);
  });
  return assemble(x, dt_s, fade, ways);
}

CtraMatrix ctra_noise(const CtraVector& x, double dt_s, const CtraNoise& noise, const Fade& fade) {
  const Eigen::Vector4d sigma(noise.heading_rad, noise.speed_m_per_s, noise.accel_m_per_s2,
                              noise.yaw_rate_rad_per_s);
  CtraMatrix Q = CtraMatrix::Zero();
  for_each_node(dt_s, panels_for(x, dt_s, fade), [&](double t, double weight) {
    const CtraMatrix F = ctra_transition(moving_state(x, t, fade), dt_s - t, fade).F;
    const Eigen::Matrix<double, 6, 4> root =
        F.rightCols<4>() * (std::sqrt(weight) * sigma).asDiagonal();
    Q += root * root.transpose();
  });
  return Q;
}

Gaussian<6> predict_ctra(const Gaussian<6>& x, double dt_s, const CtraNoise& noise,
                         const Fade& fade) {
  return predict<6>(x, ctra_transition(x.mean, dt_s, fade), ctra_noise(x.mean, dt_s, noise, fade),
                    kAngles);
}

Gaussian<6> flip_heading(const Gaussian<6>& x) {
  const CtraVector sign = (CtraVector() << 1, 1, 1, -1, -1, 1).finished();
  Gaussian<6> flipped{sign.cwiseProduct(x.mean),
                      sign.asDiagonal() * x.covariance * sign.asDiagonal()};
  flipped.mean(kHeading) = wrap_pi(x.mean(kHeading) + kPi);
  return flipped;
}

Gaussian<6> settle_heading(const Gaussian<6>& x, double backward_m_per_s) {
  return x.mean(kSpeed) < -backward_m_per_s ? flip_heading(x) : x;
}

Eigen::Matrix<double, 2, 6> position_of_ctra() { return Eigen::Matrix<double, 2, 6>::Identity(); }

Eigen::Vector4d velocity_of_ctra(const CtraVector& x) {
  return {x(kX), x(kSpeed) * std::cos(x(kHeading)), x(kY), x(kSpeed) * std::sin(x(kHeading))};
}

Gaussian<4> velocity_of_ctra(const Gaussian<6>& x) {
  using Complex = std::complex<double>;
  constexpr Complex i(0, 1);
  const CtraMatrix& P = x.covariance;
  const double v = x.mean(kSpeed), share = P(kHeading, kSpeed);
  const Complex turn = std::exp(Complex(-P(kHeading, kHeading) / 2, x.mean(kHeading)));
  const Complex by_heading = i * (v + i * share) * turn;
  const Complex mean = (v + i * share) * turn;
  const Complex v2 = v + 2.0 * i * share;
  const Complex twice = (v2 * v2 + P(kSpeed, kSpeed)) * std::pow(std::abs(turn), 2) * turn * turn;
  const double square = v * v + P(kSpeed, kSpeed);

  Gaussian<4> out{{x.mean(kX), mean.real(), x.mean(kY), mean.imag()}, Eigen::Matrix4d()};
  const auto with_place = [&](int place) {
    return P(place, kSpeed) * turn + P(place, kHeading) * by_heading;
  };
  const Complex with_x = with_place(kX), with_y = with_place(kY);
  Eigen::Matrix4d& C = out.covariance;
  C(0, 0) = P(kX, kX);
  C(2, 2) = P(kY, kY);
  C(0, 2) = C(2, 0) = P(kX, kY);
  C(0, 1) = C(1, 0) = with_x.real();
  C(0, 3) = C(3, 0) = with_x.imag();
  C(1, 2) = C(2, 1) = with_y.real();
  C(2, 3) = C(3, 2) = with_y.imag();
  C(1, 1) = (square + twice.real()) / 2 - mean.real() * mean.real();
  C(3, 3) = (square - twice.real()) / 2 - mean.imag() * mean.imag();
  C(1, 3) = C(3, 1) = twice.imag() / 2 - mean.real() * mean.imag();
  return out;
}

namespace {

/// x, y, psi, v, w of x, y, psi, v, a, w.
const std::array<int, 5> kWithoutAccel = {kX, kY, kHeading, kSpeed, kYawRate};

CtraVector without_accel(const CtrvVector& x) {
  CtraVector full = CtraVector::Zero();
  full(kWithoutAccel) = x;
  return full;
}

}  // namespace

Transition<5> ctrv_transition(const CtrvVector& x, double dt_s) {
  const Transition<6> f = ctra_transition(without_accel(x), dt_s);
  return {f.mean(kWithoutAccel), f.F(kWithoutAccel, kWithoutAccel)};
}

CtrvMatrix ctrv_noise(const CtrvVector& x, double dt_s, CtraNoise noise) {
  noise.accel_m_per_s2 = 0;
  return ctra_noise(without_accel(x), dt_s, noise)(kWithoutAccel, kWithoutAccel);
}

}  // namespace scanfuse::estimate
