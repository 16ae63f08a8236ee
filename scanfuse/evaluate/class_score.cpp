#include "scanfuse/evaluate/class_score.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {
namespace {

constexpr double kWatch_s = 1.0;
constexpr double kSeenShare = 0.8;
constexpr int kSeenPoints = 3;
constexpr double kNearBox_m = 1, kNearCentre_m = 2;

/// How far a track's centre lies from what it may follow; none: too far.
std::optional<double> apart(const TruthObject& object, const Eigen::Vector2d& place) {
  const double from_centre = (place - object.position_m).norm();
  if (from_centre <= kNearCentre_m) return from_centre;
  if (!object.heading_rad || !object.length_m || !object.width_m) return std::nullopt;
  const Box2 box{object.position_m, *object.heading_rad, *object.length_m, *object.width_m};
  if (box.contains(place, kNearBox_m)) return from_centre;
  return std::nullopt;
}

struct Following {
  std::vector<int> track_of_object, object_of_track;  ///< -1: none
};

/// Confirmed tracks choose first: what is tentative must not take an object from them.
Following pair_up(const StepResult& step, const TruthFrame& truth,
                  std::span<const Eigen::Vector2d> places) {
  std::vector<std::tuple<bool, double, int, int>> pairs;
  for (std::size_t t = 0; t < places.size(); ++t) {
    const bool tentative = step.tracks[t].status == TrackStatus::kTentative;
    for (std::size_t o = 0; o < truth.objects.size(); ++o) {
      const auto d = apart(truth.objects[o], places[t]);
      if (d) pairs.emplace_back(tentative, *d, static_cast<int>(o), static_cast<int>(t));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Following f{std::vector<int>(truth.objects.size(), -1), std::vector<int>(places.size(), -1)};
  for (const auto& [tentative, d, o, t] : pairs) {
    if (f.track_of_object[o] >= 0 || f.object_of_track[t] >= 0) continue;
    f.track_of_object[o] = t;
    f.object_of_track[t] = o;
  }
  return f;
}

std::optional<double> ratio(const std::array<std::int64_t, ClassScore::kRangeBins>& part,
                            const std::array<std::int64_t, ClassScore::kRangeBins>& whole,
                            double range_m) {
  std::int64_t a = 0, b = 0;
  for (int i = 0; i < ClassScore::kRangeBins; ++i) {
    if ((i + 1) * ClassScore::kBin_m > range_m + 1e-9) break;
    a += part[i];
    b += whole[i];
  }
  if (b == 0) return std::nullopt;
  return static_cast<double>(a) / static_cast<double>(b);
}

std::size_t index_of(ObjectClass kind) { return static_cast<std::size_t>(kind); }

bool is_road_user(ObjectClass kind) {
  return kind == ObjectClass::kVehicle || kind == ObjectClass::kPedestrian ||
         kind == ObjectClass::kCyclist;
}

/// Pose of the sensor in the frame of the truth.
Eigen::Vector2d sensor_place(const StepResult& step, const TruthFrame& truth) {
  const Eigen::Vector2d mount = step.ego_from_sensor.translation_m.head<2>();
  return truth.coordinate_frame == "ego" ? mount : step.world_from_ego.planar() * mount;
}

std::vector<Eigen::Vector2d> places_of(const StepResult& step, const TruthFrame& truth) {
  const Pose2 to_from = truth_from_output(step, truth);
  std::vector<Eigen::Vector2d> places;
  places.reserve(step.tracks.size());
  for (const Track& t : step.tracks) places.push_back(to_from * t.box.centre_m);
  return places;
}

/// Range bin, or -1 beyond the last.
int bin_of(const Eigen::Vector2d& place, const Eigen::Vector2d& sensor) {
  const double bin = (place - sensor).norm() / ClassScore::kBin_m;
  return bin < ClassScore::kRangeBins ? static_cast<int>(bin) : -1;
}

}  // namespace

void Reliability::add(double probability, bool is_right) {
  const int bin = std::clamp(static_cast<int>(probability * kBins), 0, kBins - 1);
  said[bin] += probability;
  right[bin] += is_right ? 1 : 0;
  count[bin] += 1;
}

void Reliability::merge(const Reliability& other) {
  for (int i = 0; i < kBins; ++i) {
    said[i] += other.said[i];
    right[i] += other.right[i];
    count[i] += other.count[i];
  }
}

std::optional<double> Reliability::expected_calibration_error() const {
  double error = 0, all = 0;
  for (int i = 0; i < kBins; ++i) {
    error += std::abs(said[i] - right[i]);
    all += count[i];
  }
  if (all == 0) return std::nullopt;
  return error / all;
}

void ClassScore::start_recording() {
  objects_.clear();
  born_.clear();
}

void ClassScore::add(const StepResult& step, const TruthFrame& truth) {
  const auto places = places_of(step, truth);
  const Following f = pair_up(step, truth, places);
  ++scans_;
  count_objects(step, truth, f.track_of_object);
  count_tracks(step, truth, f.object_of_track);
}

void ClassScore::count_objects(const StepResult& step, const TruthFrame& truth,
                               std::span<const int> track_of_object) {
  const Eigen::Vector2d sensor = sensor_place(step, truth);
  for (std::size_t o = 0; o < truth.objects.size(); ++o) {
    const TruthObject& object = truth.objects[o];
    Watch& watch = objects_.try_emplace(object.id, Watch{step.stamp, {}}).first->second;
    watch.seen.emplace_back(step.stamp, object.visible_points.value_or(kSeenPoints) >= kSeenPoints);
    while (to_seconds(step.stamp - watch.seen.front().first) > kWatch_s) watch.seen.pop_front();
    const auto seen = std::count_if(watch.seen.begin(), watch.seen.end(),
                                    [](const auto& scan) { return scan.second; });
    const bool counts = to_seconds(step.stamp - watch.since) >= kWatch_s &&
                        static_cast<double>(seen) >= kSeenShare * std::ssize(watch.seen);
    const int bin = bin_of(object.position_m, sensor);
    if (!counts || bin < 0) continue;
    Counts& of = counts_[index_of(object.object_class)];
    ++of.objects[bin];
    const int t = track_of_object[o];
    const auto born = t < 0 ? born_.end() : born_.find(step.tracks[t].id);
    const bool followed = born != born_.end() && to_seconds(step.stamp - born->second) >= kWatch_s;
    of.followed[bin] += followed ? 1 : 0;
    if (t < 0) {
      ++of.untracked[bin];
    } else if (step.tracks[t].object_class != object.object_class) {
      ++of.misnamed[bin];
    } else if (step.tracks[t].status == TrackStatus::kTentative) {
      ++of.tentative[bin];
    } else {
      ++of.found[bin];
      of.named[bin] += followed ? 1 : 0;
    }
  }
}

void ClassScore::count_tracks(const StepResult& step, const TruthFrame& truth,
                              std::span<const int> object_of_track) {
  const Eigen::Vector2d sensor = sensor_place(step, truth);
  const auto places = places_of(step, truth);
  for (std::size_t t = 0; t < step.tracks.size(); ++t) {
    const Track& track = step.tracks[t];
    const Time born = born_.try_emplace(track.id, step.stamp).first->second;
    const int bin = bin_of(places[t], sensor);
    if (bin < 0) continue;
    const bool confirmed = track.status != TrackStatus::kTentative;
    const int o = object_of_track[t];
    const ObjectClass kind = o < 0 ? ObjectClass::kOther : truth.objects[o].object_class;
    const bool old = to_seconds(step.stamp - born) >= kWatch_s;
    if (confirmed && o < 0 && is_road_user(track.object_class)) {
      ++clutter_;
      old_clutter_ += old ? 1 : 0;
      const bool second = std::ranges::any_of(truth.objects, [&](const TruthObject& object) {
        return apart(object, places[t]).has_value();
      });
      old_seconds_ += old && second ? 1 : 0;
    }
    if (!old) continue;
    const bool right = kind == track.object_class;
    ++confusion_[index_of(kind)][index_of(track.object_class)];
    reliability_.add(track.class_probability, right);
    if (!confirmed) continue;
    Counts& of = counts_[index_of(track.object_class)];
    ++of.said[bin];
    of.right[bin] += right ? 1 : 0;
  }
}

void ClassScore::merge(const ClassScore& other) {
  for (std::size_t c = 0; c < kObjectClasses; ++c) {
    for (int i = 0; i < kRangeBins; ++i) {
      counts_[c].objects[i] += other.counts_[c].objects[i];
      counts_[c].found[i] += other.counts_[c].found[i];
      counts_[c].untracked[i] += other.counts_[c].untracked[i];
      counts_[c].tentative[i] += other.counts_[c].tentative[i];
      counts_[c].misnamed[i] += other.counts_[c].misnamed[i];
      counts_[c].followed[i] += other.counts_[c].followed[i];
      counts_[c].named[i] += other.counts_[c].named[i];
      counts_[c].said[i] += other.counts_[c].said[i];
      counts_[c].right[i] += other.counts_[c].right[i];
    }
    for (std::size_t k = 0; k < kObjectClasses; ++k) confusion_[c][k] += other.confusion_[c][k];
  }
  reliability_.merge(other.reliability_);
  scans_ += other.scans_;
  clutter_ += other.clutter_;
  old_clutter_ += other.old_clutter_;
  old_seconds_ += other.old_seconds_;
}

std::optional<double> ClassScore::precision(ObjectClass kind, double range_m) const {
  return ratio(counts(kind).right, counts(kind).said, range_m);
}

std::optional<double> ClassScore::recall(ObjectClass kind, double range_m) const {
  return ratio(counts(kind).found, counts(kind).objects, range_m);
}

std::optional<double> ClassScore::recall_of_followed(ObjectClass kind, double range_m) const {
  return ratio(counts(kind).named, counts(kind).followed, range_m);
}

std::optional<double> ClassScore::clutter_per_scan() const {
  if (scans_ == 0) return std::nullopt;
  return static_cast<double>(clutter_) / static_cast<double>(scans_);
}

std::optional<double> ClassScore::old_clutter_per_scan() const {
  if (scans_ == 0) return std::nullopt;
  return static_cast<double>(old_clutter_) / static_cast<double>(scans_);
}

std::optional<double> ClassScore::old_seconds_per_scan() const {
  if (scans_ == 0) return std::nullopt;
  return static_cast<double>(old_seconds_) / static_cast<double>(scans_);
}

}  // namespace scanfuse::evaluate
