#include "scanfuse/track/motion.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/estimate/constant_velocity.hpp"
#include "scanfuse/estimate/imm.hpp"
#include "scanfuse/estimate/kalman.hpp"
#include "scanfuse/estimate/turn_moments.hpp"
#include "scanfuse/track/extent.hpp"
#include "scanfuse/track/heading.hpp"

namespace scanfuse::track {
namespace {

using Weights = Eigen::Matrix<double, kModes, 1>;
using Switching = Eigen::Matrix<double, kModes, kModes>;

/// Share of `sigma_accel` that each mode has.
constexpr std::array<double, kModes> kAccelShare{0, 0.4, 2.0};
constexpr double kWander_m = 0.05;            ///< of the place at rest, in one second
constexpr double kStillSpeed_m_per_s = 0.05;  ///< what "at rest" allows
constexpr double kOnsetSpeed_m_per_s = 1.5;   ///< of something that starts to move
constexpr double kAtRest_m_per_s = 0.1;
constexpr double kMovingMemory_s = 0.4;
constexpr double kRest_s = 1;
constexpr double kDepartedProbability = 0.6;
constexpr double kLeastWander_m = 0.04;
constexpr double kDeparted = 3;  ///< deviations
constexpr double kLeaving_m_per_s = 0.2;
constexpr double kFastestTurn_rad_per_s = 1.5;  ///< boxes that jump turn faster, vehicles do not
constexpr double kStraight_rad_per_s = 0.02;
constexpr double kTurning_rad_per_s = 0.3;

/// What a velocity is weighed with.
struct MotionPrior {
  double speed_m_per_s;  ///< of what moves, by axis
  /// Errors of a velocity last: what a side that comes into view does to it is not in its
  /// covariance, which is taken so many times as large. Who is slim has no such sides.
  double lasting_errors;
};

MotionPrior motion_prior(ObjectClass kind) {
  if (kind == ObjectClass::kPedestrian) return {1, 1};
  return {3, 4};
}

/// Modes are left so often, 1/s.
Switching switching_rates() {
  Switching rates;
  rates << 0, 0.05, 0.15, 0.05, 0, 0.4, 0.2, 1.0, 0;
  return rates;
}

Eigen::Matrix2d turned(double c, double s) {
  Eigen::Matrix2d R;
  R << c, -s, s, c;
  return R;
}

Eigen::Vector2d velocity_of(const StateVector& x) { return {x(kVx), x(kVy)}; }

void set_velocity_to_velocity(StateMatrix& F, const Eigen::Matrix2d& R) {
  F(kVx, kVx) = R(0, 0);
  F(kVx, kVy) = R(0, 1);
  F(kVy, kVx) = R(1, 0);
  F(kVy, kVy) = R(1, 1);
}

void set_velocity_to_place(StateMatrix& F, const Eigen::Matrix2d& A) {
  F(kX, kVx) = A(0, 0);
  F(kX, kVy) = A(0, 1);
  F(kY, kVx) = A(1, 0);
  F(kY, kVy) = A(1, 1);
}

Gaussian<kStates> with_velocity(Gaussian<kStates> x, double sigma_m_per_s) {
  for (const int v : {kVx, kVy}) {
    x.mean(v) = 0;
    x.covariance.row(v).setZero();
    x.covariance.col(v).setZero();
    x.covariance(v, v) = sigma_m_per_s * sigma_m_per_s;
  }
  return x;
}

/// Rests for the step, whatever it was taken for before.
Gaussian<kStates> rest(const Gaussian<kStates>& x, double dt_s) {
  Gaussian<kStates> still = with_velocity(x, kStillSpeed_m_per_s);
  still.covariance(kX, kX) += kWander_m * kWander_m * dt_s;
  still.covariance(kY, kY) += kWander_m * kWander_m * dt_s;
  return still;
}

Gaussian<kStates> mixed(const Target& target, const Weights& weights) {
  return estimate::moment_match<kStates, kModes>(target.modes, weights);
}

/// ln N(v; 0, P + sigma^2 I), without the constant.
double log_density(const Eigen::Vector2d& v, const Eigen::Matrix2d& P, double sigma) {
  const Eigen::Matrix2d S = P + sigma * sigma * Eigen::Matrix2d::Identity();
  return -0.5 * (v.dot(S.inverse() * v) + std::log(S.determinant()));
}

/// Whether it leaves the place where it has been of late, farther than it used to wander there, and
/// goes on to leave it. Tells sooner than the velocity that a car starts, and knows hedges by now.
bool departs(Target& target, double dt_s) {
  const double share = 1 - std::exp(-dt_s / kRest_s);
  const Eigen::Vector2d off = target.position_m() - target.rest_m;
  target.rest_m += share * off;
  const double usual = target.wander_m2 + kLeastWander_m * kLeastWander_m;
  const double outward = off.dot(target.velocity_m_per_s());
  if (target.moving < 0.5) {
    target.wander_m2 += share * (off.squaredNorm() / 2 - target.wander_m2);
  }
  return off.squaredNorm() > kDeparted * kDeparted * usual &&
         outward > kLeaving_m_per_s * off.norm();
}

/// Mean of a turn rate of which the estimate is w with variance P, where half of what drives goes
/// straight: w times the posterior of "it turns".
double believed_turn(double w, double P) {
  const auto log_density = [&](double sigma) {
    const double S = P + sigma * sigma;
    return -0.5 * (w * w / S + std::log(S));
  };
  const double odds_straight = log_density(kStraight_rad_per_s) - log_density(kTurning_rad_per_s);
  return w / (1 + std::exp(odds_straight));
}

Weights reweighed(const Weights& prior, const Weights& log_likelihood) {
  const double largest = log_likelihood.maxCoeff();
  const Weights logs = (log_likelihood.array() - largest).exp() * prior.array();
  const double sum = logs.sum();
  return std::isfinite(sum) && sum > 0 ? Weights(logs / sum) : prior;
}

}  // namespace

Step step_along_arc(const StateVector& from, double dt_s, double yaw_rate_rad_per_s,
                    double accel_m_per_s2) {
  const double turn = yaw_rate_rad_per_s * dt_s;
  const auto m = estimate::turn_moments(turn);
  const Eigen::Matrix2d R = turned(std::cos(turn), std::sin(turn));
  Step step;
  set_velocity_to_velocity(step.F, R);
  set_velocity_to_place(step.F, dt_s * turned(m.A0, m.B0));
  const Eigen::Vector2d v = velocity_of(from);
  const double speed = v.norm();
  if (accel_m_per_s2 == 0 || speed <= 0) return step;
  // Braking ends at rest: it does not drive backwards.
  const double a = std::max(accel_m_per_s2, -speed / std::max(dt_s, 1e-9));
  const Eigen::Vector2d push = a * v / speed;
  const Eigen::Vector2d way = dt_s * dt_s * turned(m.A1, m.B1) * push, gain = dt_s * R * push;
  step.shift << way.x(), gain.x(), way.y(), gain.y(), 0, 0;
  return step;
}

Manoeuvre manoeuvre_of(const Target& target, const TrackerOptions& options) {
  if (options.motion == Motion::kCv || follows_its_course(target)) return {};
  if (!course_of(target.state).reliable) return {};
  Manoeuvre m;
  m.yaw_rate_rad_per_s = believed_turn(
      std::clamp(target.heading.mean(1), -kFastestTurn_rad_per_s, kFastestTurn_rad_per_s),
      target.heading.covariance(1, 1));
  if (options.motion == Motion::kCtra) m.accel_m_per_s2 = target.accel_m_per_s2;
  return m;
}

void update_moving(Target& target, double dt_s, const TrackerOptions& options) {
  if (options.motion == Motion::kImm) {
    target.moving = 1 - target.mode_probability(kStill);
    return;
  }
  const auto& C = target.state.covariance;
  Eigen::Matrix2d P;
  P << C(kVx, kVx), C(kVx, kVy), C(kVy, kVx), C(kVy, kVy);
  const MotionPrior prior = motion_prior(user_class_of(target));
  P *= prior.lasting_errors;
  const Eigen::Vector2d v = target.velocity_m_per_s();
  const double odds = log_density(v, P, kAtRest_m_per_s) - log_density(v, P, prior.speed_m_per_s);
  const double now = 1 / (1 + std::exp(odds));
  target.moving += (1 - std::exp(-dt_s / kMovingMemory_s)) * (now - target.moving);
  if (departs(target, dt_s)) target.moving = std::max(target.moving, kDepartedProbability);
}

void start_modes(Target& target) {
  target.modes.fill(target.state);
  target.modes[kStill] = with_velocity(target.state, kStillSpeed_m_per_s);
  target.mode_probability << 0.4, 0.3, 0.3;
}

void predict_modes(Target& target, double dt_s, const TrackerOptions& options) {
  const auto pi = estimate::switching<kModes>(switching_rates(), dt_s);
  const Weights reached = pi.transpose() * target.mode_probability;
  const Manoeuvre arc = manoeuvre_of(target, options);
  const Gaussian<kStates> still = target.modes[kStill];
  std::array<Gaussian<kStates>, kModes> moved;
  for (int j = 0; j < kModes; ++j) {
    const Weights from = pi.col(j).cwiseProduct(target.mode_probability) / reached(j);
    target.modes[kStill] = j == kStill ? still : with_velocity(still, kOnsetSpeed_m_per_s);
    moved[j] = mixed(target, from);
    if (j == kStill) {
      moved[j] = rest(moved[j], dt_s);
      continue;
    }
    const Step step = step_along_arc(moved[j].mean, dt_s, arc.yaw_rate_rad_per_s, 0);
    StateMatrix Q = StateMatrix::Zero();
    Q.topLeftCorner<4, 4>() =
        estimate::constant_velocity_noise(dt_s, kAccelShare[j] * options.sigma_accel);
    moved[j] = estimate::predict(moved[j], step.F, Q);
  }
  target.modes = moved;
  target.mode_probability = reached / reached.sum();
  target.state = mixed(target, target.mode_probability);
}

void update_modes(Target& target, const Measurement& measurement) {
  Weights log_likelihood;
  for (int j = 0; j < kModes; ++j) {
    Gaussian<kStates>& mode = target.modes[j];
    log_likelihood(j) =
        estimate::innovation(mode, measurement.position, measurement.H).log_likelihood();
    mode = estimate::update_considering(mode, measurement.position, measurement.H, kLength);
    update_extent(mode, measurement);
  }
  target.mode_probability = reweighed(target.mode_probability, log_likelihood);
  target.state = mixed(target, target.mode_probability);
}

}  // namespace scanfuse::track
