#pragma once

#include "scanfuse/track/measure.hpp"

/// How a target moves between scans, inside the state x, vx, y, vy, length, width.
namespace scanfuse::track {

/// A step along an arc, linear in the state for a known turn rate w and acceleration a:
///
///   p' = p + T A v + T^2 B a u,   v' = R(w T) v + T R(w T) a u,   u = v / |v|
///   A = int_0^1 R(w T s) ds,      B = int_0^1 s R(w T s) ds
///
/// w is what the heading filter believes, a what the speed corrections of past updates add up to.
/// Neither is a state: their errors are covered by the white acceleration. With w = a = 0 this is
/// the constant-velocity step.
struct Step {
  StateMatrix F = StateMatrix::Identity();
  StateVector shift = StateVector::Zero();
};

[[nodiscard]] Step step_along_arc(const StateVector& from, double dt_s, double yaw_rate_rad_per_s,
                                  double accel_m_per_s2);

/// The turn rate and acceleration along the motion that the policy lets the target keep. Zero
/// unless it surely moves and is of a kind whose heading boxes tell.
struct Manoeuvre {
  double yaw_rate_rad_per_s = 0;
  double accel_m_per_s2 = 0;
};
[[nodiscard]] Manoeuvre manoeuvre_of(const Target& target, const TrackerOptions& options);

/// Whether the velocity believed is motion or noise. Both hypotheses foresee it as a Gaussian of
/// zero mean, with four times the covariance P of the estimate, since its errors last, and beyond
/// it 0.1 m/s at rest, 3 m/s in motion (pedestrians: P as it is, 1 m/s); their posterior from even
/// odds, smoothed over 0.4 s. With the mixture, the probability of the modes that move.
void update_moving(Target& target, double dt_s, const TrackerOptions& options);

/// Makes the modes of a target that has only a state: at birth, after a quarter turn.
void start_modes(Target& target);

/// Interacting multiple models [Blom1988] of three modes: at rest (no velocity, the place wanders a
/// little), even motion along the arc with a third of the white acceleration, and a manoeuvre with
/// three times of it. What the mode at rest holds at zero it passes on as the velocity that
/// something starts to move with.
void predict_modes(Target& target, double dt_s, const TrackerOptions& options);

/// Folds the measured place and extent into every mode, weighs the modes by how well each foresaw
/// the place, and mixes them into the state.
void update_modes(Target& target, const Measurement& measurement);

}  // namespace scanfuse::track
