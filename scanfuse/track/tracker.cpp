#include "scanfuse/track/tracker.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "scanfuse/track/steps.hpp"

namespace scanfuse::track {
namespace {

/// An object of which less is in view is hardly detected.
constexpr double kHiddenShare = 0.5;

/// Seconds from a to b. Stamps of damaged files may lie centuries apart: their difference does not
/// fit nanoseconds, and is then taken roughly.
double seconds_between(Time a, Time b) {
  const double rough_s =
      (static_cast<double>(to_nanos(b)) - static_cast<double>(to_nanos(a))) * 1e-9;
  return std::abs(rough_s) < 1e9 ? to_seconds(b - a) : rough_s;
}

}  // namespace

const std::vector<Track>& Tracker::step(Time stamp, std::span<const Detection> detections,
                                        int sensor) {
  const bool same_instant = last_ == stamp;
  const std::optional<double> dt_s = advance_clock(stamp);
  if (dt_s) {
    select_usable(detections);
    predict(targets_, *dt_s, options_);
    fold_in(stamp, *dt_s, same_instant, sensor);
  } else {
    for (Target& target : targets_) target.detection = -1;
  }
  report();
  return tracks_;
}

std::optional<double> Tracker::advance_clock(Time stamp) {
  const double dt_s = last_ ? seconds_between(*last_, stamp) : 0.0;
  const auto where = [&] { return "at " + std::to_string(to_nanos(stamp)) + " ns"; };
  if (dt_s < 0 && dt_s >= -options_.max_gap_s) {
    diagnostics_.note("scan older than the last one left out of tracking", where());
    return std::nullopt;
  }
  const bool jumped = dt_s < 0 || dt_s > options_.max_gap_s;
  if (jumped) {
    diagnostics_.note(
        dt_s < 0 ? "clock stepped back, tracks dropped" : "pause in the data, tracks dropped",
        where());
    targets_.clear();
    lost_.clear();
  }
  last_ = stamp;
  return jumped ? 0.0 : dt_s;
}

void Tracker::expect(Time stamp, std::vector<Expected>& expected) const {
  expected.clear();
  const double dt_s = last_ ? seconds_between(*last_, stamp) : 0.0;
  if (dt_s < 0 || dt_s > options_.max_gap_s) return;
  for (const Target& target : targets_) {
    const bool is_known =
        target.status != TrackStatus::kTentative || std::popcount(target.history) > 1;
    if (!is_known || user_class_of(target) != ObjectClass::kVehicle) continue;
    Box2 box = target.box();
    box.centre_m += dt_s * target.velocity_m_per_s();
    const auto& P = target.state.covariance;
    const auto variance = [&](int x, int v) {
      return P(x, x) + 2 * dt_s * P(x, v) + dt_s * dt_s * P(v, v);
    };
    const double worst = std::max({variance(kX, kVx), variance(kY, kVy), 0.0});
    expected.push_back({box, std::sqrt(worst), ObjectClass::kVehicle});
  }
}

void Tracker::select_usable(std::span<const Detection> detections) {
  usable_.clear();
  source_.clear();
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (is_usable(detections[i])) {
      usable_.push_back(detections[i]);
      source_.push_back(static_cast<int>(i));
    } else {
      diagnostics_.note("detection with unusable numbers left out",
                        "detection " + std::to_string(i));
    }
  }
}

void Tracker::fold_in(Time stamp, double dt_s, bool same_instant, int sensor) {
  const auto candidates = gated_candidates(targets_, usable_, options_, workspace_);
  const auto& assignment =
      associate_(options_.associator, static_cast<int>(targets_.size()),
                 static_cast<int>(usable_.size()), candidates, unassigned_cost(options_));
  shadows_.cast(usable_);
  // The modes of `imm` are not mixed over detections: there the likeliest alone is folded in.
  const bool mixes =
      options_.associator == associate::Method::kJpda && options_.motion != Motion::kImm;
  const auto mixed =
      mixes ? mixed_states(targets_, usable_, candidates, associate_.shares(), options_, workspace_)
            : std::span<const Gaussian<kStates>>{};
  for (std::size_t t = 0; t < targets_.size(); ++t) {
    const int d = assignment.detection_of_track[t];
    if (d >= 0) {
      if (mixes) {
        update_mixed(targets_[t], mixed[t], usable_[d], source_[d], stamp, dt_s, options_);
      } else {
        update(targets_[t], usable_[d], source_[d], stamp, dt_s, options_);
      }
      targets_[t].sensor = sensor;
      promote(targets_[t], options_);
    } else if (same_instant || targets_[t].sensor != sensor) {
      targets_[t].detection = -1;
    } else {
      if (mixes) targets_[t].state = mixed[t];
      miss(targets_[t], dt_s, shadows_.hidden_share(targets_[t].box()) >= kHiddenShare);
    }
  }
  give_up(stamp, dt_s);
  give_birth(stamp, dt_s, sensor, assignment.track_of_detection);
  if (!options_.births_inside_tracks) merge_duplicates(targets_, workspace_);
}

void Tracker::give_up(Time stamp, double dt_s) {
  lost_.advance(stamp, dt_s, options_);
  std::erase_if(targets_, [&](const Target& target) {
    if (!is_over(target, stamp, options_)) return false;
    if (options_.lost_s > 0) lost_.keep(target);
    return true;
  });
}

void Tracker::give_birth(Time stamp, double dt_s, int sensor,
                         std::span<const int> track_of_detection) {
  const std::size_t elders = targets_.size();
  for (std::size_t d = 0; d < usable_.size(); ++d) {
    if (track_of_detection[d] >= 0) continue;
    const std::span<const Target> present(targets_.data(), elders);
    if (!options_.births_inside_tracks && is_part_of(usable_[d], present)) continue;
    if (auto known = lost_.find(usable_[d], options_)) {
      update(*known, usable_[d], source_[d], stamp, dt_s, options_);
      targets_.push_back(std::move(*known));
    } else {
      targets_.push_back(birth(usable_[d], source_[d], ++*ids_, stamp, dt_s, options_));
    }
    targets_.back().sensor = sensor;
  }
}

void Tracker::report() {
  tracks_.clear();
  for (const Target& target : targets_) {
    tracks_.push_back(to_track(target, options_.moving_from));
  }
}

}  // namespace scanfuse::track
