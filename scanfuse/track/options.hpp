#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <utility>

#include "scanfuse/associate/associate.hpp"
#include "scanfuse/core/options.hpp"

namespace scanfuse::track {

struct BeliefModel;

/// What of a Detection is the measurement.
enum class MeasuredAs { kBox, kCentre, kVisibleMiddle };

constexpr auto choices(MeasuredAs) {
  using enum MeasuredAs;
  return std::array{std::pair{"box", kBox}, std::pair{"centre", kCentre},
                    std::pair{"visible_middle", kVisibleMiddle}};
}

/// Which distance gates and prices a pair of track and detection.
enum class Distance { kMahalanobis, kEuclidean };

constexpr auto choices(Distance) {
  using enum Distance;
  return std::array{std::pair{"mahalanobis", kMahalanobis}, std::pair{"euclidean", kEuclidean}};
}

/// The velocity that a new track starts with: unknown within a prior, or with eq. 14 of [Lu2018].
enum class Start { kVelocityPrior, kPaper };

constexpr auto choices(Start) {
  using enum Start;
  return std::array{std::pair{"velocity_prior", kVelocityPrior}, std::pair{"paper", kPaper}};
}

/// How targets are believed to move between scans (motion.hpp).
enum class Motion { kCv, kCtrv, kCtra, kImm };

constexpr auto choices(Motion) {
  using enum Motion;
  return std::array{std::pair{"cv", kCv}, std::pair{"ctrv", kCtrv}, std::pair{"ctra", kCtra},
                    std::pair{"imm", kImm}};
}

struct TrackerOptions {
  MeasuredAs measurement = MeasuredAs::kBox;
  associate::Method associator = associate::Method::kGlobal;
  Distance distance = Distance::kMahalanobis;
  Start start = Start::kVelocityPrior;
  Motion motion = Motion::kCtrv;
  double gate_probability = 0.999;
  double gate_distance_m = 4;
  double unassigned_cost = 10;
  double class_mismatch_cost = 4;
  double sigma_accel = 0.8;
  double sigma_velocity_m_per_s = 10;
  double moving_from = 0.5;
  double sigma_position_m = 0.01;
  double sigma_p_m = 0.5;
  double sigma_m_m = 0.2;
  int confirm_hits = 3;
  int confirm_window = 5;
  double coast_s = 1.6;
  double coast_share = 0.15;
  double coast_hidden_share = 6;
  double coast_sigma_m = 2.5;
  int coast_frames = 0;
  double lost_s = 3;
  double max_gap_s = 2;
  double confirm_other_probability = 0.2;
  double doubt_other_probability = 0.3;
  bool births_inside_tracks = false;
  /// Filters class probabilities over time; without it the class is that of the largest sum of
  /// scores. The pipeline puts it in where the recogniser tells probabilities.
  std::shared_ptr<const BeliefModel> belief;

  static constexpr auto fields() {
    using O = TrackerOptions;
    return std::tuple{
        Field{"measurement", &O::measurement, "what of a detection is measured"},
        Field{"associator", &O::associator, "how detections are given to tracks"},
        Field{"distance", &O::distance, "distance that gates and prices a pair"},
        Field{"start", &O::start, "what a new track believes of its velocity"},
        Field{"motion", &O::motion,
              "constant velocity, with turn rate, with acceleration too, or a mixture"},
        Field{"gate_probability", &O::gate_probability, 0.5, 0.999999,
              "share of right pairs inside the chi-square gate (mahalanobis)"},
        Field{"gate_distance_m", &O::gate_distance_m, 0.1, 50.0,
              "no pair is farther apart than this"},
        Field{"unassigned_cost", &O::unassigned_cost, -100.0, 1000.0,
              "cost m^2 + ln det S from which a pair is not believed (mahalanobis)"},
        Field{"class_mismatch_cost", &O::class_mismatch_cost, 0.0, 100.0,
              "added to the cost when track and detection differ in class (mahalanobis)"},
        Field{"sigma_accel", &O::sigma_accel, 0.0, 50.0,
              "velocity gained in one second by white acceleration, m/s; 0: no process noise"},
        Field{"sigma_velocity_m_per_s", &O::sigma_velocity_m_per_s, 0.1, 100.0,
              "deviation of a new track's velocity (velocity_prior)"},
        Field{"moving_from", &O::moving_from, 0.0, 1.0,
              "confirmed tracks that move with a smaller probability are reported to stand"},
        Field{"sigma_position_m", &O::sigma_position_m, 0.0, 10.0,
              "added in quadrature to what detections say of their position"},
        Field{"sigma_p_m", &O::sigma_p_m, 0.001, 10.0, "sigma_p of eq. 14 of [Lu2018] (paper)"},
        Field{"sigma_m_m", &O::sigma_m_m, 0.001, 10.0,
              "sigma_m of eq. 15 of [Lu2018] (visible_middle)"},
        Field{"confirm_hits", &O::confirm_hits, 1, 30, "hits that confirm a track, out of"},
        Field{"confirm_window", &O::confirm_window, 1, 30, "the last so many scans"},
        Field{"coast_s", &O::coast_s, 0.0, 60.0, "a confirmed track lives so long unseen"},
        Field{"coast_share", &O::coast_share, 0.0, 100.0,
              "nor longer than this share of the time it had been seen"},
        Field{"coast_hidden_share", &O::coast_hidden_share, 0.0, 100.0,
              "the same where something nearer hides it"},
        Field{"coast_sigma_m", &O::coast_sigma_m, 0.1, 100.0,
              "nor past the scan when its place is known no better than this"},
        Field{"coast_frames", &O::coast_frames, 0, 1000,
              "when not 0: the same counted in scans, for every track"},
        Field{"lost_s", &O::lost_s, 0.0, 60.0,
              "a confirmed track given up is known again so long after it was last seen"},
        Field{"max_gap_s", &O::max_gap_s, 0.1, 3600.0,
              "a longer pause in the data, or a step back by more, drops every track"},
        Field{"confirm_other_probability", &O::confirm_other_probability, 0.0, 1.0,
              "a track more surely no road user is not confirmed; a small one in its first second "
              "needs less"},
        Field{"doubt_other_probability", &O::doubt_other_probability, 0.0, 1.0,
              "and one that has become more surely so is tentative again"},
        Field{"births_inside_tracks", &O::births_inside_tracks,
              "start tracks inside the box of a confirmed one"},
    };
  }
};

/// The Kalman bank of [Lu2018, eqs 5-16] as printed: measures the middle of the visible line, has
/// no process noise, one detection after the other takes the nearest free filter within a fixed
/// gate, every other detection starts a filter that counts at once, filters coast a number of
/// frames. The paper prints neither the gate nor that number: 4 m and 20 frames.
[[nodiscard]] inline TrackerOptions literal_options() {
  TrackerOptions options;
  options.measurement = MeasuredAs::kVisibleMiddle;
  options.associator = associate::Method::kDetectionGreedy;
  options.distance = Distance::kEuclidean;
  options.start = Start::kPaper;
  options.motion = Motion::kCv;
  options.moving_from = 0;
  options.sigma_accel = 0;
  options.confirm_hits = 1;
  options.confirm_window = 1;
  options.coast_frames = 20;
  options.lost_s = 0;
  options.births_inside_tracks = true;
  return options;
}

}  // namespace scanfuse::track
