#include "track_run.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include "scanfuse/io/tables.hpp"
#include "scanfuse/io/toml.hpp"
#include "scanfuse/pipeline/capture_reader.hpp"
#include "track_outputs.hpp"

namespace scanfuse::app {
namespace {

/// Counts what `TrackOutcome` tells while scans go by.
class Tally {
 public:
  void add(const StepResult& step, std::size_t returns, double seconds) {
    ++outcome_.scans;
    outcome_.returns += static_cast<std::int64_t>(returns);
    outcome_.detections += static_cast<std::int64_t>(step.detections.size());
    outcome_.first = std::min(outcome_.first.value_or(step.stamp), step.stamp);
    outcome_.last = std::max(outcome_.last.value_or(step.stamp), step.stamp);
    for (const Track& track : step.tracks) {
      if (track.status != TrackStatus::kTentative) confirmed_.insert(track.id);
    }
    seconds_.push_back(static_cast<float>(seconds));
  }

  [[nodiscard]] TrackOutcome finish() {
    std::sort(seconds_.begin(), seconds_.end());
    if (!seconds_.empty()) {
      outcome_.median_scan_s = seconds_[seconds_.size() / 2];
      outcome_.p99_scan_s = seconds_[seconds_.size() * 99 / 100];
    }
    outcome_.tracks = static_cast<std::int64_t>(confirmed_.size());
    return std::move(outcome_);
  }

 private:
  TrackOutcome outcome_;
  std::set<std::int64_t> confirmed_;
  std::vector<float> seconds_;
};

Result<pipeline::FeedOptions> feed_options(const TrackRequest& request) {
  pipeline::FeedOptions options;
  options.ego_topic = request.ego_topic;
  options.may_move = !request.standing;
  if (!request.mount.empty()) {
    options.mount = Pose3::from_planar({request.mount[0], request.mount[1], request.mount[2]});
  }
  if (!request.ego_file.empty()) {
    auto ego = io::read_ego(request.ego_file);
    if (!ego) return tl::unexpected(ego.error());
    options.ego = std::move(*ego);
  }
  return options;
}

bool is_wanted(const TrackRequest& request, const std::string& sensor) {
  return request.topics.empty() ||
         std::find(request.topics.begin(), request.topics.end(), sensor) != request.topics.end();
}

/// Compares with truth, where there is any, and closes all outputs.
Result<void> conclude(const TrackRequest& request, const pipeline::PerceptionOptions& options,
                      Scorer& scorer, TrackOutputs& outputs, TrackOutcome& outcome) {
  if (auto done = scorer.finish(outcome.diagnostics); !done) return done;
  if (auto score = scorer.score()) {
    outcome.score = std::move(score->all);
    outcome.by_class = std::move(score->by_class);
  }
  if (scorer.was_asked()) outputs.show(scorer.truth());
  return outputs.finish(request, outcome, options);
}

Result<void> track_all(const TrackRequest& request, pipeline::ScanFeed& feed,
                       pipeline::Perception& perception, TrackOutputs& outputs, Tally& tally,
                       Scorer& scorer, bool quiet) {
  Progress progress("tracking", quiet);
  std::int64_t scans = 0;
  while (!interrupted) {
    auto posed = feed.next();
    if (!posed) return tl::unexpected(posed.error());
    for (auto& truth : feed.take_truth()) {
      if (auto done = outputs.write(truth); !done) return done;
      scorer.add(truth);
    }
    if (!*posed) break;
    if (!is_wanted(request, (*posed)->scan.sensor)) continue;
    const auto before = std::chrono::steady_clock::now();
    const StepResult& step = perception.step(**posed);
    const auto took = std::chrono::steady_clock::now() - before;
    tally.add(step, (*posed)->scan.returns.size(), to_seconds(took));
    scorer.add(step);
    if (auto done =
            outputs.write(step, (*posed)->scan, &perception.virtual_scan(), &perception.clusters());
        !done) {
      return done;
    }
    progress.update(++scans);
  }
  return {};
}

}  // namespace

/// The topics to read: those asked for, and what tells where the ego is.
Result<pipeline::ScanFeed> open_feed(const TrackRequest& request) {
  io::OpenOptions open;
  open.paper_axes = request.paper_axes;
  auto reader = pipeline::open_any_recording(request.input, open, {request.sensor, {}});
  if (!reader) return tl::unexpected(reader.error());
  std::vector<std::string> known;
  for (const auto& topic : (*reader)->info().topics) known.push_back(topic.name);
  auto wanted = request.topics;
  if (!request.ego_topic.empty()) wanted.push_back(request.ego_topic);
  for (const auto& topic : wanted) {
    if (std::find(known.begin(), known.end(), topic) == known.end() && !known.empty()) {
      return fail(Error::Code::kNotFound,
                  "{}: no topic '{}'; did you mean '{}'? `scanfuse info` "
                  "lists them",
                  request.input, topic, nearest_name(topic, known));
    }
  }
  auto options = feed_options(request);
  if (!options) return tl::unexpected(options.error());
  return pipeline::ScanFeed(std::move(*reader), std::move(*options));
}

Result<pipeline::PerceptionOptions> resolve_options(const TrackRequest& request) {
  auto options = pipeline::preset(request.preset);
  if (!options) return options;
  if (!request.config.empty()) {
    const auto entries = io::read_toml(request.config);
    if (!entries) return tl::unexpected(entries.error());
    for (const auto& entry : *entries) {
      auto done = set_config(*options, entry.section, entry.key, entry.value);
      if (!done) {
        return fail(done.error().code, "{}:{}:{}: {}", request.config, entry.line, entry.column,
                    done.error().message);
      }
    }
  }
  for (const auto& assignment : request.set) {
    if (auto done = set_config(*options, assignment); !done) return tl::unexpected(done.error());
  }
  if (!request.frame.empty()) {
    if (auto done = set_config(*options, "pipeline", "frame", request.frame); !done) {
      return tl::unexpected(done.error());
    }
  }
  return options;
}

Result<TrackOutcome> run_track(const TrackRequest& request, const CommonOptions& common) {
  const auto options = resolve_options(request);
  if (!options) return tl::unexpected(options.error());
  auto scorer = Scorer::create(request.truth, request.scoring, request.input);
  if (!scorer) return tl::unexpected(scorer.error());
  auto feed = open_feed(request);
  if (!feed) return tl::unexpected(feed.error());
  auto outputs = TrackOutputs::open(request);
  if (!outputs) return tl::unexpected(outputs.error());
  pipeline::Perception perception(*options);
  Tally tally;
  auto done = track_all(request, *feed, perception, *outputs, tally, *scorer, common.quiet);
  if (!done) return tl::unexpected(done.error());
  TrackOutcome outcome = tally.finish();
  outcome.stopped = interrupted;
  outcome.diagnostics = feed->diagnostics();
  outcome.diagnostics.merge(perception.diagnostics());
  if (outcome.scans == 0 && !outcome.stopped) {
    return fail(Error::Code::kNotFound,
                "{}: no scan in it that scanfuse can read; `scanfuse info` lists what is there",
                request.input);
  }
  if (auto finished = conclude(request, *options, *scorer, *outputs, outcome); !finished) {
    return tl::unexpected(finished.error());
  }
  return outcome;
}

Result<std::vector<StepResult>> track_steps(const TrackRequest& request) {
  const auto options = resolve_options(request);
  if (!options) return tl::unexpected(options.error());
  auto feed = open_feed(request);
  if (!feed) return tl::unexpected(feed.error());
  pipeline::Perception perception(*options);
  std::vector<StepResult> steps;
  while (true) {
    auto posed = feed->next();
    if (!posed) return tl::unexpected(posed.error());
    if (!*posed) return steps;
    if (!is_wanted(request, (*posed)->scan.sensor)) continue;
    steps.push_back(perception.step(**posed));
    steps.back().detections.clear();
  }
}

namespace {

/// Where detections are brought from the frame of the sensor: into the world and, if the results
/// are asked for in the frame of the ego, back.
class DetectionPlacer {
 public:
  [[nodiscard]] static Result<DetectionPlacer> create(const TrackRequest& request,
                                                      const pipeline::PerceptionOptions& options) {
    auto feed = feed_options(request);
    if (!feed) return tl::unexpected(feed.error());
    DetectionPlacer placer;
    for (const auto& sample : feed->ego) placer.ego_.add(sample.stamp, sample.pose);
    placer.mount_ = feed->mount.value_or(Pose3{});
    placer.in_ego_ = options.pipeline.frame == pipeline::OutputFrame::kEgo;
    return placer;
  }

  StepResult place(const io::DetectionFrame& frame, Diagnostics& diagnostics) const {
    StepResult step;
    step.stamp = frame.stamp;
    step.frame = frame.frame;
    step.sensor = frame.sensor;
    step.ego_from_sensor = mount_;
    if (const auto found = ego_.at(frame.stamp)) {
      step.world_from_ego = found->pose;
      if (found->extrapolated) {
        diagnostics.note("ego pose extrapolated", fmt::format("frame {}", frame.frame));
      }
    }
    const Pose2 world_from_sensor = (step.world_from_ego * mount_).planar();
    step.detections.reserve(frame.detections.size());
    for (const auto& detection : frame.detections) {
      step.detections.push_back(pipeline::moved(detection, world_from_sensor));
    }
    return step;
  }

  void give_back(StepResult& step) const {
    if (!in_ego_) return;
    step.coordinate_frame = "ego";
    const Pose2 ego_from_world = step.world_from_ego.planar().inverse();
    for (auto& detection : step.detections) detection = pipeline::moved(detection, ego_from_world);
    for (auto& track : step.tracks) track = pipeline::moved(track, ego_from_world);
  }

 private:
  pipeline::PoseBuffer ego_;
  Pose3 mount_;
  bool in_ego_ = false;
};

}  // namespace

Result<TrackOutcome> run_track_on_detections(const TrackRequest& request,
                                             const CommonOptions& common) {
  const auto options = resolve_options(request);
  if (!options) return tl::unexpected(options.error());
  Diagnostics diagnostics;
  const auto frames = io::read_detections(request.input, &diagnostics,
                                          {request.calibration, request.frame_rate_hz});
  if (!frames) return tl::unexpected(frames.error());
  const auto placer = DetectionPlacer::create(request, *options);
  if (!placer) return tl::unexpected(placer.error());
  auto scorer = Scorer::create(request.truth, request.scoring, request.input);
  if (!scorer) return tl::unexpected(scorer.error());
  auto outputs = TrackOutputs::open(request);
  if (!outputs) return tl::unexpected(outputs.error());
  track::Tracker tracker(options->track);
  Tally tally;
  Progress progress("tracking", common.quiet);
  for (const auto& frame : *frames) {
    if (interrupted) break;
    StepResult step = placer->place(frame, diagnostics);
    const auto before = std::chrono::steady_clock::now();
    step.tracks = tracker.step(frame.stamp, step.detections);
    tally.add(step, 0, to_seconds(std::chrono::steady_clock::now() - before));
    placer->give_back(step);
    scorer->add(step);
    if (auto done = outputs->write(step, Scan{}, nullptr, nullptr); !done) {
      return tl::unexpected(done.error());
    }
    progress.update(step.frame);
  }
  TrackOutcome outcome = tally.finish();
  outcome.stopped = interrupted;
  outcome.diagnostics = std::move(diagnostics);
  outcome.diagnostics.merge(tracker.diagnostics());
  if (auto finished = conclude(request, *options, *scorer, *outputs, outcome); !finished) {
    return tl::unexpected(finished.error());
  }
  return outcome;
}

}  // namespace scanfuse::app
