#include "view_run.hpp"

#include <algorithm>
#include <filesystem>

#include "scanfuse/io/tables.hpp"

namespace scanfuse::app {
namespace {

constexpr const char* kTracksTopic = "/scanfuse/tracks";

/// Whether the recording carries tracks of ours.
bool carries_tracks(const std::string& input) {
  const auto reader = io::open_recording(input);
  if (!reader) return false;
  const auto& topics = (*reader)->info().topics;
  return std::ranges::find(topics, kTracksTopic, &io::TopicInfo::name) != topics.end();
}

Result<std::unique_ptr<serve::ScanSource>> open_source(const TrackRequest& request) {
  auto feed = open_feed(request);
  if (!feed) return tl::unexpected(feed.error());
  return std::make_unique<serve::RecordedScans>(std::move(*feed), request.topics);
}

/// Poses of topics are given at the stamps of scans: a pass over the recording finds them.
Result<std::vector<StepResult>> stamps_of(const TrackRequest& request) {
  auto feed = open_feed(request);
  if (!feed) return tl::unexpected(feed.error());
  std::vector<StepResult> steps;
  while (true) {
    auto posed = feed->next();
    if (!posed) return tl::unexpected(posed.error());
    if (!*posed) return steps;
    StepResult step;
    step.stamp = (*posed)->scan.stamp;
    step.frame = (*posed)->scan.frame;
    step.sensor = (*posed)->scan.sensor;
    step.world_from_ego = (*posed)->world_from_ego;
    step.ego_from_sensor = (*posed)->ego_from_sensor;
    steps.push_back(std::move(step));
  }
}

Result<std::vector<TruthFrame>> truth_for(const TrackRequest& request) {
  TruthRequest truth = request.truth;
  if (truth.path.empty() && truth.topics.empty()) return std::vector<TruthFrame>{};
  if (truth.path.empty()) truth.path = request.input;
  std::vector<StepResult> steps;
  if (!truth.topics.empty()) {
    auto found = stamps_of(request);
    if (!found) return tl::unexpected(found.error());
    steps = std::move(*found);
  }
  Diagnostics ignored;  // `evaluate` tells them; here the truth is only shown beside the tracks
  return read_truth(truth, steps, ignored);
}

Result<serve::ShowScan> show_for(const ViewRequest& request,
                                 const pipeline::PerceptionOptions& options) {
  const bool asks = request.again || request.has_preset || !request.track.config.empty() ||
                    !request.track.set.empty();
  if (asks || !carries_tracks(request.track.input)) return serve::show_with(options);
  auto steps = io::read_tracks(request.track.input);
  if (!steps) return tl::unexpected(steps.error());
  return serve::show_stored(std::move(*steps));
}

Result<std::unique_ptr<serve::Workbench>> open_bench(const ViewRequest& request) {
  if (io::table_kind(request.track.input) == io::TableKind::kBearings) {
    return fail(Error::Code::kUnsupported,
                "{}: bearings; say where the sensors are: --sensors TOML", request.track.input);
  }
  const auto options = resolve_options(request.track);
  if (!options) return tl::unexpected(options.error());
  auto truth = truth_for(request.track);
  if (!truth) return tl::unexpected(truth.error());
  auto show = show_for(request, *options);
  if (!show) return tl::unexpected(show.error());
  auto source = open_source(request.track);
  if (!source) return tl::unexpected(source.error());
  serve::WorkbenchOptions bench;
  bench.title = std::filesystem::path(request.track.input).filename().string();
  bench.preset = request.track.preset;
  bench.options = *options;
  bench.truth = std::move(*truth);
  const auto scoring = resolve_scoring(request.track.scoring, request.track.truth);
  if (!scoring) return tl::unexpected(scoring.error());
  bench.scoring = *scoring;
  return serve::Workbench::create(std::move(*source), std::move(*show), std::move(bench));
}

/// Labels of an earlier sitting belong to frames that must have been read first.
Result<void> load_labels(const std::string& path, const serve::Workbench& bench,
                         serve::Labels& labels) {
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return {};
  Diagnostics diagnostics;
  const auto frames = io::read_truth(path, &diagnostics);
  if (!frames) return tl::unexpected(frames.error());
  bench.wait();
  labels.load(*frames, bench.log());
  return {};
}

Result<std::unique_ptr<serve::Workbench>> open_any_bench(const ViewRequest& request,
                                                         const CommonOptions& common) {
  if (request.scene) return open_rig_bench(*request.scene);
  if (!request.rig.empty()) {
    const auto scene = read_rig_scene(request.track.input, request.rig);
    if (!scene) return tl::unexpected(scene.error());
    return open_rig_bench(*scene);
  }
  if (!request.live.empty()) return open_live_bench(request.track, request.live);
  if (!request.track.sensors.empty()) return open_passive_bench(request, common.threads);
  return open_bench(request);
}

}  // namespace

Result<OpenView> open_view(const ViewRequest& request, const CommonOptions& common) {
  if (auto fine = refuse_to_replace(request.track.input, request.labels); !fine) {
    return tl::unexpected(fine.error());
  }
  auto bench = open_any_bench(request, common);
  if (!bench) return tl::unexpected(bench.error());
  auto labels = std::make_unique<serve::Labels>(request.labels);
  if (auto done = load_labels(request.labels, **bench, *labels); !done) {
    return tl::unexpected(done.error());
  }
  auto viewer = serve::Viewer::start(**bench, *labels, request.server);
  if (!viewer) return tl::unexpected(viewer.error());
  return OpenView{std::move(*bench), std::move(labels), std::move(*viewer)};
}

}  // namespace scanfuse::app
