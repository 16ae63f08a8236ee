#include <algorithm>
#include <bit>
#include <cmath>

#include "scanfuse/associate/position_grid.hpp"
#include "scanfuse/estimate/constant_velocity.hpp"
#include "scanfuse/track/extent.hpp"
#include "scanfuse/track/motion.hpp"
#include "scanfuse/track/steps.hpp"

namespace scanfuse::track {
namespace {

/// Step that eq. 14 uses for a filter born in the very first scan: 12.5 Hz, as the paper's lidar.
constexpr double kNominalStep_s = 0.08;
/// Stamps are rounded: a limit of a whole number of scans must not lose the last one.
constexpr double kStampRounding_s = 1e-3;
/// A few missed scans in a row are chance, however young the track.
constexpr double kLeastCoast_s = 0.3;
/// What is small and has just appeared is oftener clutter than what stays.
constexpr double kFullTrust_s = 1;
constexpr double kMergeRadius_m = 3;
constexpr double kMergeSpeed_m_per_s = 2;

/// How fast a new target may be, by class; vehicles and what is unknown take the option.
double velocity_prior(ObjectClass kind, const TrackerOptions& options) {
  switch (kind) {
    case ObjectClass::kPedestrian:
      return std::min(2.0, options.sigma_velocity_m_per_s);
    case ObjectClass::kCyclist:
      return std::min(5.0, options.sigma_velocity_m_per_s);
    default:
      return options.sigma_velocity_m_per_s;
  }
}

/// Class prior, moved to at least what was seen; a side seen whole is folded in afterwards.
Gaussian<2> starting_extent(const Detection& detection, const Measurement& m,
                            const TrackerOptions& options) {
  Gaussian<2> extent = extent_prior(detection.object_class);
  if (options.measurement != MeasuredAs::kBox) {
    extent.mean << m.length.size_m, m.width.size_m;
  } else if (detection.object_class == ObjectClass::kUnknown ||
             detection.object_class == ObjectClass::kOther) {
    extent.mean << std::max(m.length.size_m, 0.1), std::max(m.width.size_m, 0.1);
  }
  return extent;
}

/// x = (p - A e, v, e): the centre follows from the measured end p and the extent e, so an error of
/// e is an error of the centre of the opposite sign.
Gaussian<kStates> starting_state(const Gaussian<4>& motion, const Gaussian<2>& extent,
                                 const Measurement& m) {
  StateMatrix G = StateMatrix::Identity();
  G.block<1, 2>(kX, kLength) = -m.H.block<1, 2>(0, kLength);
  G.block<1, 2>(kY, kLength) = -m.H.block<1, 2>(1, kLength);
  Gaussian<kStates> apart;
  apart.mean << motion.mean, extent.mean;
  apart.covariance.setZero();
  apart.covariance.topLeftCorner<4, 4>() = motion.covariance;
  apart.covariance.bottomRightCorner<2, 2>() = extent.covariance;
  return {G * apart.mean, G * apart.covariance * G.transpose()};
}

Gaussian<4> starting_motion(const Detection& detection, const Measurement& m, double dt_s,
                            const TrackerOptions& options) {
  Gaussian<4> motion =
      estimate::start_from_one_point(m.position, velocity_prior(detection.object_class, options));
  if (options.start == Start::kPaper) {
    motion.covariance =
        estimate::two_point_covariance(options.sigma_p_m, dt_s > 0 ? dt_s : kNominalStep_s);
  }
  return motion;
}

int hits_within(std::uint32_t history, int scans) {
  return std::popcount(history & ((1U << scans) - 1U));
}

bool are_one(const Target& elder, const Target& younger) {
  const bool inside =
      elder.box().contains(younger.position_m()) || younger.box().contains(elder.position_m());
  const double apart = (elder.velocity_m_per_s() - younger.velocity_m_per_s()).norm();
  const bool both_seen = elder.missed_frames == 0 && younger.missed_frames == 0;
  const bool small = std::max(elder.state.mean(kLength), younger.state.mean(kLength)) < 2.5;
  return inside && apart < kMergeSpeed_m_per_s && !(both_seen && small);
}

}  // namespace

Target birth(const Detection& detection, int index, std::int64_t id, Time stamp, double dt_s,
             const TrackerOptions& options) {
  const Measurement m = measure(detection, detection.box.heading_rad, options);
  Target target;
  target.id = id;
  target.state = starting_state(starting_motion(detection, m, dt_s, options),
                                starting_extent(detection, m, options), m);
  update_extent(target.state, m);
  if (options.motion == Motion::kImm) start_modes(target);
  target.rest_m = target.position_m();
  target.heading.mean << m.heading_rad, 0;
  target.heading.covariance = Eigen::Vector2d(m.var_heading_rad2 + 0.01, 0.25).asDiagonal();
  target.class_weight[static_cast<std::size_t>(detection.object_class)] =
      std::clamp(detection.score, 0.0, 1.0);
  believe(target, detection, stamp, options.belief.get());
  target.z_m = detection.z_m;
  target.height_m = detection.height_m;
  target.born = target.seen = stamp;
  target.detection = index;
  target.age_frames = 1;
  target.history = 1;
  promote(target, options);
  return target;
}

void reseat(Target& target, const Detection& detection, const TrackerOptions& options) {
  const Measurement m = measure(detection, target.heading_rad(), options);
  Gaussian<4> motion = estimate::start_from_one_point(m.position, 1);
  for (const int row : {kVx, kVy}) {
    motion.mean(row) = target.state.mean(row);
    for (const int column : {kVx, kVy}) {
      motion.covariance(row, column) = target.state.covariance(row, column);
    }
  }
  target.state = starting_state(motion, starting_extent(detection, m, options), m);
  update_extent(target.state, m);
  if (options.motion != Motion::kImm) return;
  const auto probability = target.mode_probability;
  start_modes(target);
  target.mode_probability = probability;
}

void promote(Target& target, const TrackerOptions& options) {
  const int window = std::max(options.confirm_window, options.confirm_hits);
  if (target.status == TrackStatus::kTentative &&
      hits_within(target.history, window) >= options.confirm_hits) {
    target.status = TrackStatus::kConfirmed;
    target.is_known = true;
  }
  const double other = target.class_probability[static_cast<std::size_t>(ObjectClass::kOther)];
  const double life_s = to_seconds(target.seen - target.born);
  const bool is_small = class_of(target) != ObjectClass::kVehicle;
  const double trust = is_small ? std::min(life_s / kFullTrust_s, 1.0) : 1.0;
  if (other <= options.confirm_other_probability * trust) {
    target.is_trusted = true;
  } else if (other > options.doubt_other_probability) {
    target.is_trusted = false;
  }
}

bool is_part_of(const Detection& detection, std::span<const Target> targets) {
  return std::ranges::any_of(targets, [&](const Target& target) {
    if (target.status != TrackStatus::kConfirmed) return false;
    return target.box().contains(detection.box.centre_m) ||
           detection.box.contains(target.position_m());
  });
}

bool is_vague(const Target& target, const TrackerOptions& options) {
  const auto& P = target.state.covariance;
  return std::max(P(kX, kX), P(kY, kY)) > options.coast_sigma_m * options.coast_sigma_m;
}

bool is_over(const Target& target, Time stamp, const TrackerOptions& options) {
  const double unseen_s = to_seconds(stamp - target.seen);
  // Of a sensor that has fallen silent.
  if (target.missed_frames == 0) return unseen_s > options.coast_s + kStampRounding_s;
  if (options.coast_frames > 0) return target.missed_frames > options.coast_frames;
  if (target.status == TrackStatus::kTentative) {
    const int window = std::max(options.confirm_window, options.confirm_hits);
    const int scans = std::min(target.age_frames, window);
    const int misses = scans - hits_within(target.history, scans);
    return misses > window - options.confirm_hits;
  }
  const double seen_s = to_seconds(target.seen - target.born);
  const auto earned_s = [&](double share) { return std::max(kLeastCoast_s, share * seen_s); };
  const double hidden_share = target.is_steady
                                  ? std::max(options.coast_share, options.coast_hidden_share)
                                  : options.coast_share;
  const double open_s = unseen_s - target.hidden_s;
  return unseen_s > std::min(options.coast_s, earned_s(hidden_share)) + kStampRounding_s ||
         open_s > earned_s(options.coast_share) + kStampRounding_s || is_vague(target, options);
}

void merge_duplicates(std::vector<Target>& targets, Workspace& workspace) {
  auto& [grid, candidates, superfluous, mixed] = workspace;
  grid.reset(kMergeRadius_m);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    grid.add(targets[i].position_m(), static_cast<int>(i));
  }
  grid.sort();
  superfluous.assign(targets.size(), 0);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].status != TrackStatus::kConfirmed) continue;
    grid.near(targets[i].position_m(), [&](int j) {
      // Targets stand in order of birth, found ones where they came back: a lower index is the
      // elder.
      if (static_cast<std::size_t>(j) <= i || superfluous[i]) return;
      if (are_one(targets[i], targets[j])) superfluous[j] = 1;
    });
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (superfluous[i]) continue;
    if (kept != i) targets[kept] = std::move(targets[i]);
    ++kept;
  }
  targets.resize(kept);
}

}  // namespace scanfuse::track
