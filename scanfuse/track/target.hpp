#pragma once

#include <array>
#include <cstdint>

#include "scanfuse/core/time.hpp"
#include "scanfuse/track/class_belief.hpp"
#include "scanfuse/types/gaussian.hpp"
#include "scanfuse/types/object_class.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::track {

/// Places in the state of a target: the four of [Lu2018], then the extent. Extent is part of the
/// state because an unseen end makes an error of the centre that does not average out: carried as
/// a correlated unknown it keeps the covariance honest, as white noise it would not.
enum State : int { kX, kVx, kY, kVy, kLength, kWidth, kStates };

using StateVector = Eigen::Matrix<double, kStates, 1>;
using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

/// The modes that `Motion::kImm` mixes: at rest, even motion, manoeuvre (motion.hpp).
enum Mode : int { kStill, kEven, kManoeuvre, kModes };

/// What the tracker believes of one object, in the tracking frame.
struct Target {
  std::int64_t id = 0;
  TrackStatus status = TrackStatus::kTentative;
  Gaussian<kStates> state;
  std::array<Gaussian<kStates>, kModes> modes;  ///< `Motion::kImm` only: `state` is their mixture
  Eigen::Matrix<double, kModes, 1> mode_probability;
  Gaussian<2> heading;  ///< rad and rad/s; its sign is settled by motion
  double moving = 0.5;  ///< probability that it moves (motion.hpp)
  Eigen::Vector2d rest_m = Eigen::Vector2d::Zero();  ///< where it has been of late
  double wander_m2 = 0.04;    ///< variance of its place around that, by axis, while it stood
  double forward_m = 0;       ///< way gone along the heading: the evidence for its sign
  double accel_m_per_s2 = 0;  ///< along the motion, smoothed
  double z_m = 0;
  double height_m = 0;
  std::array<double, 5> class_weight{};    ///< sum of scores, by ObjectClass
  ClassBelief belief;                      ///< where detections tell class probabilities
  ClassProbabilities class_probability{};  ///< what came of it; all zero: class_weight decides
  bool is_known = false;    ///< has been confirmed, be it before it was lost and found again
  bool is_trusted = false;  ///< was surely no clutter and is not doubted since: else tentative
  Time born;
  Time seen;
  double hidden_s = 0;  ///< of the time since `seen`, how long something nearer stood before it
  int age_frames = 0;
  int missed_frames = 0;
  bool is_steady = false;     ///< was seen in most of the scans before the last that saw it
  std::uint32_t history = 0;  ///< one bit a scan, the latest lowest: 1 is a hit
  int detection = -1;
  int sensor = 0;  ///< that saw it last
  double nis = 0;

  [[nodiscard]] Eigen::Vector2d position_m() const { return {state.mean(kX), state.mean(kY)}; }
  [[nodiscard]] Eigen::Vector2d velocity_m_per_s() const {
    return {state.mean(kVx), state.mean(kVy)};
  }
  [[nodiscard]] double heading_rad() const { return heading.mean(0); }
  [[nodiscard]] Box2 box() const {
    return {position_m(), heading_rad(), state.mean(kLength), state.mean(kWidth)};
  }
};

/// The class with the largest weight, the lowest of equals.
[[nodiscard]] ObjectClass class_of(const Target& target);

/// The same among road users: what it is if it is not clutter. Decides what it may be paired with.
[[nodiscard]] ObjectClass user_class_of(const Target& target);

/// Whether it is believed to be no road user: such targets are not confirmed, nor reported so.
[[nodiscard]] bool is_clutter(const Target& target);

/// Folds in what a detection says of the class, after the motion; without a model nothing.
void believe(Target& target, const Detection& detection, Time stamp, const BeliefModel* model);

/// The target as a value to report. When it is confirmed and moves with a probability below
/// `moving_from` it stands: velocity zero, what was believed of it added to its covariance.
[[nodiscard]] Track to_track(const Target& target, double moving_from = 0);

}  // namespace scanfuse::track
