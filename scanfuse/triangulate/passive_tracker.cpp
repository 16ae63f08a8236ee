#include "scanfuse/triangulate/passive_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

constexpr double kMostLogOdds = 50;

bool is_flat(const PassiveScene& scene) {
  return std::ranges::none_of(scene.sensors, &PassiveSensor::tells_elevation);
}

double size_of(const PassiveScene::Volume& volume) {
  double size = 1;
  for (const auto& [low, high] : volume) size *= high - low;
  return size;
}

/// Which sensors have a bearing in the scan.
std::vector<bool> looking(const BearingScan& scan, const PassiveScene& scene) {
  std::vector<bool> looks(scene.sensors.size(), false);
  for (const Bearing& b : scan.bearings) looks[static_cast<std::size_t>(b.sensor)] = true;
  return looks;
}

/// That two or more of the sensors that look see a target: what it takes to start a track.
double chance_of_start(const PassiveScene& scene, const std::vector<bool>& looks) {
  AtMostOne seen;
  for (std::size_t s = 0; s < looks.size(); ++s) {
    if (looks[s]) seen.add(scene.sensors[s].detection_probability);
  }
  return 1 - seen.probability();
}

/// ln odds of r s from those of r.
double survived(double log_odds, double survival) {
  return std::log(survival) - std::log(std::exp(-log_odds) + (1 - survival));
}

std::vector<LineOfSight> pick(std::span<const LineOfSight> lines,
                              std::span<const std::int32_t> places) {
  std::vector<LineOfSight> picked;
  picked.reserve(places.size());
  for (const std::int32_t p : places) picked.push_back(lines[static_cast<std::size_t>(p)]);
  return picked;
}

}  // namespace

PassiveTracker::PassiveTracker(PassiveScene scene, const PassiveTrackOptions& options,
                               const AssociationOptions& association)
    : scene_(std::move(scene)),
      options_(options),
      association_(association),
      point_update_(make_point_update(options.update)) {
  if (options_.estimate_bias) bias_filter_.emplace(scene_.sensors, options_.bias_sigma_rad);
}

void PassiveTracker::set_biases(std::vector<SensorBias> biases) {
  biases_ = std::move(biases);
  bias_filter_.reset();
}

std::vector<SensorBias> PassiveTracker::biases() const {
  return bias_filter_ ? bias_filter_->biases() : biases_;
}

BearingScan PassiveTracker::corrected(BearingScan scan) const {
  if (biases_.empty()) return scan;
  for (Bearing& b : scan.bearings) {
    b = without_bias(b, biases_[static_cast<std::size_t>(b.sensor)]);
  }
  return scan;
}

ScenePrior PassiveTracker::prior_of(const BearingScan& scan) {
  const std::vector<bool> looks = looking(scan, scene_);
  EstimatedPrior found = scene_prior(scene_, scan);
  ScenePrior& prior = found.prior;
  const double size = size_of(prior.volume_m);
  const double targets = std::exp(prior.log_intensity) * size;
  const bool telling = std::ranges::count(looks, true) > 1;
  if (!unseen_targets_ && (telling || !found.targets_estimated)) unseen_targets_ = targets;
  if (telling) {
    const std::string where = fmt::format("scan {}", scan.scan);
    if (found.volume_estimated) diagnostics_.note("volume_m not given, estimated", where);
    if (found.targets_estimated) diagnostics_.note("expected_targets not given, estimated", where);
    scene_.volume_m = prior.volume_m;
    scene_.expected_targets = targets;
  }
  constexpr double kFewest = 1e-9;
  prior.log_intensity = std::log(std::max(unseen_targets_.value_or(targets), kFewest) / size);
  for (std::size_t s = 0; s < looks.size(); ++s) {
    if (!looks[s]) prior.sensors[s].log_missed = 0;
  }
  if (unseen_targets_) *unseen_targets_ *= 1 - chance_of_start(scene_, looks);
  return found.prior;
}

void PassiveTracker::predict(Time stamp) {
  if (last_ && stamp < *last_) diagnostics_.note("time went back, taken as standing still");
  const double dt_s = last_ ? std::max(to_seconds(stamp - *last_), 0.0) : 0;
  last_ = last_ ? std::max(*last_, stamp) : stamp;
  const double survival = std::exp(-dt_s / options_.life_s);
  const double sigma_z = is_flat(scene_) ? 0 : options_.sigma_accel_z;
  for (PassiveTrack& track : tracks_) {
    track.state = predict_point(track.state, dt_s, options_.sigma_accel, sigma_z);
    track.log_odds = survived(track.log_odds, survival);
    ++track.age_scans;
  }
  if (unseen_targets_) {
    *unseen_targets_ = *unseen_targets_ * survival + options_.new_targets_per_s * dt_s;
  }
}

void PassiveTracker::update(const TrackChoice& choice, std::span<const LineOfSight> lines,
                            Time stamp) {
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    PassiveTrack& track = tracks_[t];
    track.bearings = choice.bearings_of_track[t];
    track.log_odds = std::min(track.log_odds + choice.log_ratio[t], kMostLogOdds);
    if (track.bearings.empty()) {
      ++track.missed_scans;
      continue;
    }
    const auto own = pick(lines, track.bearings);
    track.state =
        std::visit([&](const auto& policy) { return policy(track.state, own); }, point_update_);
    track.missed_scans = 0;
    track.last_seen = stamp;
    ++track.scans_seen;
    track.confirmed =
        track.confirmed || (track.scans_seen >= options_.confirm_scans &&
                            track.existence_probability() >= options_.confirm_probability);
  }
}

void PassiveTracker::learn_bias(const BearingScan& scan) {
  const auto lines = lines_of_sight(scan, scene_);
  for (const PassiveTrack& track : tracks_) {
    if (!track.confirmed || track.bearings.size() < 2) continue;
    bias_filter_->learn(pick(lines, track.bearings), track.state.mean.head<3>());
  }
  biases_ = bias_filter_->biases();
}

void PassiveTracker::start(const TrackChoice& choice, std::span<const LineOfSight> lines,
                           const ScenePrior& prior, Time stamp) {
  constexpr double kLevel_m_per_s = 1e-3;  // a flat scene says nothing of climbing
  const double v = options_.start_speed_m_per_s;
  const double vz = prior.flat ? kLevel_m_per_s : options_.start_climb_m_per_s;
  for (const TrackChoice::Start& fresh : choice.starts) {
    const auto at = most_likely(pick(lines, fresh.bearings), prior.height());
    if (!at) continue;
    PassiveTrack track;
    track.id = next_id_++;
    track.state.mean.setZero();
    track.state.mean.head<3>() = at->position_m;
    track.state.covariance.setZero();
    track.state.covariance.topLeftCorner<3, 3>() = at->covariance_m2;
    track.state.covariance.diagonal().tail<3>() << v * v, v * v, vz * vz;
    track.log_odds = std::min(fresh.weight, kMostLogOdds);
    track.scans_seen = 1;
    track.confirmed = options_.confirm_scans == 1 &&
                      track.existence_probability() >= options_.confirm_probability;
    track.last_seen = stamp;
    track.bearings = fresh.bearings;
    tracks_.push_back(std::move(track));
  }
}

void PassiveTracker::drop(Time stamp) {
  std::erase_if(tracks_, [&](const PassiveTrack& track) {
    return to_seconds(stamp - track.last_seen) > options_.coast_s ||
           track.existence_probability() < options_.drop_probability ||
           !track.state.mean.allFinite();
  });
}

Result<PassiveStep> PassiveTracker::step(const BearingScan& measured, int threads) {
  const BearingScan scan = corrected(measured);
  predict(scan.stamp);
  const ScenePrior prior = prior_of(scan);
  const auto lines = lines_of_sight(scan, scene_);
  const auto choice =
      associate_tracks(scan, lines, tracks_, scene_, prior, options_, association_, threads);
  if (!choice) return tl::unexpected(choice.error());
  update(*choice, lines, *last_);
  start(*choice, lines, prior, *last_);
  if (bias_filter_) learn_bias(measured);
  drop(*last_);

  PassiveStep result;
  result.tracks = tracks_;
  result.gap = choice->gap;
  result.track_of_bearing.assign(scan.bearings.size(), -1);
  for (const PassiveTrack& track : tracks_) {
    for (const auto p : track.bearings) {
      result.track_of_bearing[static_cast<std::size_t>(p)] = track.id;
    }
  }
  return result;
}

}  // namespace scanfuse::triangulate
