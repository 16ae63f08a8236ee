#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "scanfuse/associate/gate.hpp"
#include "scanfuse/associate/position_grid.hpp"
#include "scanfuse/estimate/constant_velocity.hpp"
#include "scanfuse/estimate/kalman.hpp"
#include "scanfuse/track/extent.hpp"
#include "scanfuse/track/heading.hpp"
#include "scanfuse/track/motion.hpp"
#include "scanfuse/track/steps.hpp"

namespace scanfuse::track {
namespace {

constexpr double kAccelMemory_s = 0.5;
/// ctra: corrections of the speed add up to an acceleration, which is forgotten when they cease.
constexpr double kAccelRise_s = 0.7;
constexpr double kAccelDecay_s = 1.5;
constexpr double kUnsureSpeedDecay_s = 0.5;
/// Who has so many hits among the last eight scans, and hardly a miss, is an object, and may be
/// looked for where it hides.
constexpr std::uint32_t kRecentScans = 0xff;
constexpr int kSteadyHits = 4;
constexpr int kSteadyMisses = 1;
/// Distance of a detection's centre from its seen end is not bounded by the gate: search farther.
constexpr double kLongestHalf_m = 4;

/// Whether the innovation may be within the gate's distance, wherever in both boxes is measured.
bool may_be_near(const Target& target, const Detection& detection, const TrackerOptions& options) {
  if (options.measurement == MeasuredAs::kVisibleMiddle) return true;
  const Eigen::Vector2d apart = detection.box.centre_m - target.position_m() -
                                detection.time_offset_s * target.velocity_m_per_s();
  // Half diagonals are at most half of both sides together.
  const double halves_m = 0.5 * (detection.box.length_m + detection.box.width_m +
                                 target.state.mean.tail<2>().lpNorm<1>());
  const double reach_m = options.gate_distance_m + halves_m + 1e-6;
  return apart.squaredNorm() < reach_m * reach_m;
}

/// Cost of the pair, or nothing outside the gate.
std::optional<double> gated_cost(const Target& target, const Detection& detection, double gate,
                                 const TrackerOptions& options) {
  if (!may_be_near(target, detection, options)) return std::nullopt;
  const Measurement m = measure(detection, target, options);
  const auto nu = estimate::innovation(target.state, m.position, m.H);
  const double squared_distance = nu.residual.squaredNorm();
  if (squared_distance >= options.gate_distance_m * options.gate_distance_m) return std::nullopt;
  if (options.distance == Distance::kEuclidean) return std::sqrt(squared_distance);
  const double nis = nu.nis();
  if (!(nis < gate)) return std::nullopt;
  return nis + nu.log_det() + (are_alike(target, detection) ? 0.0 : options.class_mismatch_cost);
}

/// Unseen, and what is believed of its speed may be noise: a parked car must not drift away.
bool may_stand(const Target& target, const TrackerOptions& options) {
  return target.missed_frames > 0 && options.sigma_accel > 0 && !course_of(target.state).reliable;
}

/// `speed_before` as predicted: with ctra what was foreseen already is no part of the correction.
void update_acceleration(Target& target, double speed_before, double dt_s,
                         const TrackerOptions& options) {
  if (dt_s <= 0 || target.age_frames < 3) return;
  const double raw = (target.velocity_m_per_s().norm() - speed_before) / dt_s;
  if (options.motion == Motion::kCtra) {
    const double known = target.accel_m_per_s2 * std::exp(-dt_s / kAccelDecay_s);
    target.accel_m_per_s2 = known + (1 - std::exp(-dt_s / kAccelRise_s)) * raw;
    return;
  }
  target.accel_m_per_s2 += (1 - std::exp(-dt_s / kAccelMemory_s)) * (raw - target.accel_m_per_s2);
}

void predict_state(Target& target, double dt_s, const StateMatrix& Q,
                   const TrackerOptions& options) {
  const Manoeuvre arc = manoeuvre_of(target, options);
  Step step = step_along_arc(target.state.mean, dt_s, arc.yaw_rate_rad_per_s, arc.accel_m_per_s2);
  if (may_stand(target, options)) {
    const double keep = std::exp(-dt_s / kUnsureSpeedDecay_s);
    step.F(kVx, kVx) = step.F(kVy, kVy) = keep;
  }
  target.state = estimate::predict(target.state, step.F, Q);
  target.state.mean += step.shift;
}

void update_state(Target& target, const Measurement& m, const TrackerOptions& options) {
  if (options.motion == Motion::kImm) return update_modes(target, m);
  // The extent is not learned from positions: H turns with a noisy heading, and regression on a
  // noisy H pulls the extent to zero.
  target.state = estimate::update_considering(target.state, m.position, m.H, kLength);
  update_extent(target.state, m);
}

}  // namespace

void predict(std::vector<Target>& targets, double dt_s, const TrackerOptions& options) {
  if (dt_s <= 0) return;
  StateMatrix Q = StateMatrix::Zero();
  Q.topLeftCorner<4, 4>() = estimate::constant_velocity_noise(dt_s, options.sigma_accel);
  for (Target& target : targets) {
    if (options.motion == Motion::kImm) {
      predict_modes(target, dt_s, options);
    } else {
      predict_state(target, dt_s, Q, options);
    }
    predict_heading(target, dt_s);
  }
}

std::span<const associate::Candidate> gated_candidates(std::span<const Target> targets,
                                                       std::span<const Detection> detections,
                                                       const TrackerOptions& options,
                                                       Workspace& workspace) {
  const double gate = associate::gate_in_the_plane(options.gate_probability);
  auto& [grid, candidates, superfluous, mixed] = workspace;
  grid.reset(options.gate_distance_m + kLongestHalf_m);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    grid.add(targets[i].position_m(), static_cast<int>(i));
  }
  grid.sort();
  candidates.clear();
  for (std::size_t d = 0; d < detections.size(); ++d) {
    const Eigen::Vector2d& place = options.measurement == MeasuredAs::kVisibleMiddle
                                       ? detections[d].visible_middle_m
                                       : detections[d].box.centre_m;
    grid.near(place, [&](int t) {
      const auto cost = gated_cost(targets[t], detections[d], gate, options);
      if (cost) candidates.push_back({t, static_cast<int>(d), *cost});
    });
  }
  return candidates;
}

bool are_alike(const Target& target, const Detection& detection) {
  const ObjectClass believed = user_class_of(target);
  const bool vehicle = detection.object_class == ObjectClass::kVehicle;
  const double told = detection.class_probability[static_cast<std::size_t>(ObjectClass::kOther)];
  if (told > 0) return (believed == ObjectClass::kVehicle) == vehicle;
  return believed == detection.object_class;
}

std::optional<double> pair_cost(const Target& target, const Detection& detection,
                                const TrackerOptions& options) {
  return gated_cost(target, detection, associate::gate_in_the_plane(options.gate_probability),
                    options);
}

double unassigned_cost(const TrackerOptions& options) {
  return options.distance == Distance::kEuclidean ? options.gate_distance_m
                                                  : options.unassigned_cost;
}

namespace {

void update_class(Target& target, const Detection& detection, Time stamp,
                  const TrackerOptions& options) {
  const ObjectClass before = user_class_of(target);
  target.class_weight[static_cast<std::size_t>(detection.object_class)] +=
      std::clamp(detection.score, 0.0, 1.0);
  believe(target, detection, stamp, options.belief.get());
  if (options.measurement != MeasuredAs::kBox) return;
  const ObjectClass now = user_class_of(target);
  resize_to_class(target.state, before, now);
  if (options.motion != Motion::kImm) return;
  for (auto& mode : target.modes) resize_to_class(mode, before, now);
}

/// All of an update but the state.
void update_rest(Target& target, const Measurement& m, double speed_before,
                 const Detection& detection, int index, Time stamp, double dt_s,
                 const TrackerOptions& options) {
  update_heading(target, m);
  if (align_heading_with_course(target, dt_s)) reseat(target, detection, options);
  update_acceleration(target, speed_before, dt_s, options);
  update_moving(target, dt_s, options);
  update_class(target, detection, stamp, options);
  target.z_m += 0.3 * (detection.z_m - target.z_m);
  target.height_m = std::max(target.height_m, detection.height_m);
  target.seen = stamp;
  target.hidden_s = 0;
  target.detection = index;
  target.missed_frames = 0;
  ++target.age_frames;
  target.history = (target.history << 1) | 1U;
  const int hits = std::popcount(target.history & kRecentScans);
  target.is_steady = hits >= kSteadyHits && std::min(target.age_frames, 8) - hits <= kSteadyMisses;
}

}  // namespace

void update(Target& target, const Detection& detection, int index, Time stamp, double dt_s,
            const TrackerOptions& options) {
  const Measurement m = measure(detection, target, options);
  const double speed_before = target.velocity_m_per_s().norm();
  target.nis = estimate::innovation(target.state, m.position, m.H).nis();
  update_state(target, m, options);
  update_rest(target, m, speed_before, detection, index, stamp, dt_s, options);
}

void update_mixed(Target& target, const Gaussian<kStates>& mixed, const Detection& detection,
                  int index, Time stamp, double dt_s, const TrackerOptions& options) {
  const Measurement m = measure(detection, target, options);
  const double speed_before = target.velocity_m_per_s().norm();
  target.nis = estimate::innovation(target.state, m.position, m.H).nis();
  target.state = mixed;
  update_extent(target.state, m);
  update_rest(target, m, speed_before, detection, index, stamp, dt_s, options);
}

void miss(Target& target, double dt_s, bool is_hidden) {
  if (is_hidden) target.hidden_s += dt_s;
  target.detection = -1;
  target.nis = 0;
  ++target.missed_frames;
  ++target.age_frames;
  target.history <<= 1;
}

}  // namespace scanfuse::track
