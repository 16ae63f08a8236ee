#include "scanfuse/pipeline/scan_feed.hpp"

#include <algorithm>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::pipeline {
namespace {

constexpr Duration kLongestWait = std::chrono::seconds(1);
constexpr std::size_t kMostWaiting = 256;
constexpr Duration kMemory = std::chrono::seconds(10);
/// The motion that a freeze cut off is that around this before it.
constexpr Duration kBeforeFreeze = std::chrono::milliseconds(60);

bool is_odometry(const std::string& type) {
  return type.ends_with("Odometry") || type == "carmen pose";
}

std::string first_known(const std::vector<std::string>& ancestry,
                        std::initializer_list<const char*> wanted) {
  for (const char* name : wanted) {
    if (std::find(ancestry.begin(), ancestry.end(), name) != ancestry.end()) return name;
  }
  return {};
}

}  // namespace

ScanFeed::ScanFeed(std::unique_ptr<io::RecordingReader> reader, FeedOptions options)
    : reader_(std::move(reader)), options_(std::move(options)) {
  for (const auto& sample : options_.ego) {
    ego_.add(sample.stamp, sample.pose);
    frozen_.add(sample.stamp, sample.pose);
  }
  choose_ego_topic();
}

void ScanFeed::choose_ego_topic() {
  std::vector<std::string> odometry;
  for (const auto& topic : reader_->info().topics) {
    if (is_odometry(topic.type) && topic.decoded) odometry.push_back(topic.name);
    if (topic.type.ends_with("TFMessage") || topic.type.ends_with("tfMessage")) {
      recording_has_tf_ = true;
    }
  }
  ego_topic_ = options_.ego_topic;
  if (!ego_topic_.empty() || odometry.empty() || !options_.ego.empty()) return;
  const auto named = std::find(odometry.begin(), odometry.end(), "/odom");
  ego_topic_ = named != odometry.end() ? *named : odometry.front();
  if (odometry.size() > 1) {
    diagnostics_.note("several odometry topics; name one with --ego-topic", "using " + ego_topic_);
  }
}

bool ScanFeed::uses_tf() const {
  return options_.ego.empty() && options_.ego_topic.empty() && !tree_.empty();
}

ScanFeed::Frames ScanFeed::frames_of(const std::string& sensor_frame) const {
  const auto ancestry = tree_.ancestry(sensor_frame);
  Frames frames;
  frames.ego = first_known(ancestry, {"base_link", "base_footprint", "ego", "base", "vehicle"});
  frames.world = first_known(ancestry, {"odom", "map", "world"});
  if (frames.ego.empty()) {
    // The highest frame that is still fixed to the sensor.
    for (const auto& name : ancestry) {
      if (name != frames.world && !tree_.moves(name, sensor_frame)) frames.ego = name;
    }
  }
  if (frames.world.empty() && tree_.moves(ancestry.back(), sensor_frame)) {
    frames.world = ancestry.back();
  }
  if (!frames.world.empty() && !tree_.lookup(frames.world, frames.ego, Time{})) frames.world = {};
  return frames;
}

bool ScanFeed::is_ready(const Waiting& waiting) const {
  if (at_end_ || waiting_.size() > kMostWaiting) return true;
  if (newest_log_ - waiting.log_time > kLongestWait) return true;
  if (!options_.ego.empty()) return true;
  bool tf_may_tell = recording_has_tf_;
  if (options_.ego_topic.empty() && (recording_has_tf_ || !tree_.empty())) {
    const Frames frames = frames_of(waiting.scan.frame_id);
    tf_may_tell = tf_may_tell || !frames.world.empty();  // live sensors announce no tf
    if (!frames.world.empty() && tree_.covers(frames.world, frames.ego, waiting.scan.stamp)) {
      return true;
    }
  }
  return ego_topic_.empty() ? !tf_may_tell : ego_.covers(waiting.scan.stamp);
}

Result<std::optional<PosedScan>> ScanFeed::next() {
  while (waiting_.empty() || !is_ready(waiting_.front())) {
    if (at_end_) return std::nullopt;
    const auto more = read_one();
    if (!more) return tl::unexpected(more.error());
    at_end_ = !*more;
  }
  Scan scan = std::move(waiting_.front().scan);
  waiting_.pop_front();
  return pose(std::move(scan));
}

Result<bool> ScanFeed::read_one() {
  auto event = reader_->next();
  if (!event) return tl::unexpected(event.error());
  if (!*event) return false;
  take(std::move(**event));
  return true;
}

void ScanFeed::take(io::Event event) {
  newest_log_ = std::max(newest_log_, event.log_time);
  if (auto* scan = std::get_if<Scan>(&event.payload)) {
    if (!is_repeat(*scan)) waiting_.push_back({std::move(*scan), event.log_time});
  } else if (auto* sample = std::get_if<PoseSample>(&event.payload)) {
    take_pose(event.topic, *sample);
  } else if (auto* edges = std::get_if<std::vector<TransformSample>>(&event.payload)) {
    for (const auto& edge : *edges) tree_.add(edge);
  } else if (auto* truth = std::get_if<TruthFrame>(&event.payload)) {
    truth_.push_back(std::move(*truth));
  }
}

bool ScanFeed::is_repeat(const Scan& scan) {
  auto& last = last_read_[scan.sensor];
  const bool repeat = last == scan.stamp;
  last = scan.stamp;
  if (repeat) {
    diagnostics_.note("scan with the stamp of the one before it left out",
                      fmt::format("{} scan {}", scan.sensor, scan.frame));
  }
  return repeat;
}

void ScanFeed::take_pose(const std::string& topic, const PoseSample& sample) {
  if (!options_.ego.empty() || topic != ego_topic_) return;
  ego_.add(sample.stamp, sample.pose);
  frozen_.add(sample.stamp, sample.pose);
  ego_names_ = {sample.frame_id, sample.child_frame_id};
}

PosedScan ScanFeed::pose(Scan scan) {
  const auto last = last_stamp_.find(scan.sensor);
  if (last != last_stamp_.end() && scan.stamp < last->second) {
    diagnostics_.note("scan older than the one before it",
                      fmt::format("{} scan {}", scan.sensor, scan.frame));
  }
  last_stamp_[scan.sensor] = scan.stamp;
  PosedScan posed;
  posed.scan = std::move(scan);
  posed.mount_is_known = options_.mount || reader_->info().format == "csv points";
  if (options_.mount) posed.ego_from_sensor = *options_.mount;
  place(posed);
  name_frames(posed);
  const Time stamp = posed.scan.stamp;
  if (options_.ego.empty()) ego_.forget_before(stamp - kMemory);
  tree_.forget_before(stamp - kMemory);
  return posed;
}

void ScanFeed::place(PosedScan& posed) {
  if (uses_tf() && place_by_tf(posed)) return;
  if (ego_.empty()) return place_by_scans(posed);
  if (place_while_frozen(posed)) return;
  const auto found = ego_.at(posed.scan.stamp);
  if (found->extrapolated) {
    diagnostics_.note("ego pose extrapolated", fmt::format("scan {}", posed.scan.frame));
  }
  posed.world_from_ego = found->pose;
  posed.twist = ego_.twist_at(posed.scan.stamp);
}

void ScanFeed::place_by_scans(PosedScan& posed) {
  if (!options_.may_move) return;
  const auto placed = scan_ego_(posed.scan, posed.ego_from_sensor, posed.mount_is_known);
  if (!placed) return;
  diagnostics_.note("ego motion taken from the scans, since nothing tells it",
                    fmt::format("{} scan {}", posed.scan.sensor, posed.scan.frame));
  posed.world_from_ego = placed->world_from_ego;
  posed.twist = placed->twist;
  posed.ego_from_scans = true;
  posed.world_frame = "odom";
}

bool ScanFeed::place_while_frozen(PosedScan& posed) {
  const Time stamp = posed.scan.stamp;
  const auto since = frozen_.frozen_since(stamp);
  if (!since) {
    scan_ego_.forget();
    return false;
  }
  diagnostics_.note(
      "scan at a frozen ego pose",
      fmt::format("scan {}, the same since {} s", posed.scan.frame, io::print_seconds(*since)));
  if (!options_.may_move) return false;
  const auto twist = ego_.twist_at(*since - kBeforeFreeze);
  const double dt_s = to_seconds(stamp - *since);
  const Pose2 way{dt_s * twist.speed_m_per_s, dt_s * twist.lateral_m_per_s,
                  dt_s * twist.yaw_rate_rad_per_s};
  const auto placed = scan_ego_.go_on(posed.scan, posed.ego_from_sensor,
                                      {ego_.at(*since)->pose * Pose3::from_planar(way), twist});
  if (!placed) return false;
  posed.world_from_ego = placed->world_from_ego;
  posed.twist = placed->twist;
  return true;
}

bool ScanFeed::place_by_tf(PosedScan& posed) {
  const Time stamp = posed.scan.stamp;
  const Frames frames = frames_of(posed.scan.frame_id);
  const auto mount = tree_.lookup(frames.ego, posed.scan.frame_id, stamp);
  if (mount && !options_.mount) posed.ego_from_sensor = mount->pose;
  posed.mount_is_known = posed.mount_is_known || mount;
  if (frames.world.empty()) return false;
  const auto ego = tree_.lookup(frames.world, frames.ego, stamp);
  if (!ego) return false;
  posed.world_frame = frames.world;
  if (ego->extrapolated) {
    diagnostics_.note("ego pose extrapolated", fmt::format("scan {}", posed.scan.frame));
  }
  posed.world_from_ego = ego->pose;
  constexpr auto kStep = std::chrono::milliseconds(50);
  PoseBuffer around;
  for (const auto t : {stamp - kStep, stamp + kStep}) {
    if (const auto at = tree_.lookup(frames.world, frames.ego, t)) around.add(t, at->pose);
  }
  posed.twist = around.twist_at(stamp);
  return true;
}

void ScanFeed::name_frames(PosedScan& posed) const {
  posed.ego_frame = tree_.empty() ? posed.scan.frame_id : frames_of(posed.scan.frame_id).ego;
  if (!posed.world_frame.empty()) return;  // tf has told it
  const bool told = !ego_.empty() && !ego_names_.world.empty();
  posed.world_frame = told ? ego_names_.world : posed.ego_frame;
  if (told && !ego_names_.ego.empty()) posed.ego_frame = ego_names_.ego;
}

std::vector<TruthFrame> ScanFeed::take_truth() { return std::exchange(truth_, {}); }

Diagnostics ScanFeed::diagnostics() const {
  Diagnostics all = reader_->diagnostics();
  all.merge(diagnostics_);
  return all;
}

}  // namespace scanfuse::pipeline
