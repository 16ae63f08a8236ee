#include "track_passive.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "scanfuse/triangulate/passive_tracker.hpp"
#include "track_outputs.hpp"

namespace scanfuse::app {
namespace {

using triangulate::PassiveTrack;
using triangulate::PassiveTracker;
using triangulate::SensorBias;

struct PassiveSettings {
  triangulate::PassiveTrackOptions track;
  triangulate::AssociationOptions associate;

  [[nodiscard]] std::vector<OptionView> views() const {
    auto all = view_options("passive", track);
    for (auto&& more :
         {view_options("associate", associate), view_options("candidates", associate.candidates)}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }
};

/// "passive.update=cubature"
Result<void> change_setting(PassiveSettings& settings, std::string_view text) {
  const auto setting = split_setting(text);
  if (!setting) {
    return fail(Error::Code::kMalformed, "--set {}: write section.option=value", text);
  }
  const auto& [section, name, value] = *setting;
  if (section == "passive") return set_option(settings.track, name, value);
  if (section == "associate") return set_option(settings.associate, name, value);
  if (section == "candidates") return set_option(settings.associate.candidates, name, value);
  return fail(Error::Code::kNotFound,
              "--set {}: no section '{}'; bearings have passive, associate, candidates", text,
              section);
}

Result<PassiveSettings> settings_of(const TrackRequest& request) {
  const std::pair<const char*, bool> others[] = {
      {"--detections", !request.detections.empty()}, {"--report", !request.report.empty()},
      {"--config", !request.config.empty()},         {"--topic", !request.topics.empty()},
      {"--ego", !request.ego_file.empty()},          {"--ego-topic", !request.ego_topic.empty()},
      {"--mount", !request.mount.empty()},           {"--calib", !request.calibration.empty()},
      {"--truth", !request.truth.path.empty()},      {"--frame", !request.frame.empty()}};
  for (const auto& [name, given] : others) {
    if (given) {
      return fail(Error::Code::kUnsupported, "{}: not for bearings; without --sensors only", name);
    }
  }
  PassiveSettings settings;
  settings.associate.posterior = false;
  for (const std::string& set : request.set) {
    if (auto done = change_setting(settings, set); !done) return tl::unexpected(done.error());
  }
  return settings;
}

/// As every track is written: no extent, heading along the motion.
Track as_track(const PassiveTrack& point) {
  Track track;
  const auto& x = point.state.mean;
  const auto& P = point.state.covariance;
  track.id = point.id;
  track.status = !point.confirmed         ? TrackStatus::kTentative
                 : point.bearings.empty() ? TrackStatus::kCoasting
                                          : TrackStatus::kConfirmed;
  track.box.centre_m = x.head<2>();
  track.box.heading_rad = std::atan2(x(4), x(3));
  track.z_m = x(2);
  constexpr std::array order{0, 3, 1, 4};
  for (int i = 0; i < 4; ++i) {
    const int a = order[static_cast<std::size_t>(i)];
    track.state.mean(i) = x(a);
    for (int j = 0; j < 4; ++j) {
      track.state.covariance(i, j) = P(a, order[static_cast<std::size_t>(j)]);
    }
  }
  track.speed_m_per_s = x.tail<3>().norm();
  track.age_frames = point.age_scans;
  track.missed_frames = point.missed_scans;
  return track;
}

}  // namespace

StepResult as_step(const BearingScan& scan, const triangulate::PassiveStep& found) {
  StepResult step;
  step.stamp = scan.stamp;
  step.frame = scan.scan;
  step.sensor = "passive";
  step.tracks.reserve(found.tracks.size());
  for (const PassiveTrack& track : found.tracks) step.tracks.push_back(as_track(track));
  return step;
}

namespace {

struct PassiveOutcome {
  std::int64_t scans = 0;
  std::size_t bearings = 0;
  std::set<std::int64_t> confirmed;
  double worst_gap = 0;
  std::vector<SensorBias> biases;
  Diagnostics diagnostics;
};

using Writers = std::vector<std::unique_ptr<io::ResultWriter>>;

Result<Writers> open_writers(const TrackRequest& request) {
  Writers writers;
  for (const auto& path : request.outputs) {
    for (const auto& in : {request.input, request.sensors}) {
      if (auto fine = refuse_to_replace(in, path); !fine) return tl::unexpected(fine.error());
    }
    auto writer = io::open_result_writer(path);
    if (!writer) return tl::unexpected(writer.error());
    writers.push_back(std::move(*writer));
  }
  return writers;
}

Result<PassiveOutcome> follow(PassiveTracker& tracker, std::span<const BearingScan> scans,
                              Writers* writers, const CommonOptions& common) {
  PassiveOutcome outcome;
  Progress progress(writers ? "tracking" : "estimating offsets", common.quiet);
  for (const BearingScan& scan : scans) {
    if (interrupted) break;
    const auto found = tracker.step(scan, common.threads);
    if (!found) return tl::unexpected(found.error());
    outcome.bearings += scan.bearings.size();
    outcome.worst_gap = std::max(outcome.worst_gap, found->gap);
    for (const PassiveTrack& track : found->tracks) {
      if (track.confirmed) outcome.confirmed.insert(track.id);
    }
    if (writers) {
      const StepResult step = as_step(scan, *found);
      Scan none;
      none.stamp = scan.stamp;
      for (auto& writer : *writers) {
        if (auto wrote = writer->write(step, none); !wrote) return tl::unexpected(wrote.error());
      }
    }
    progress.update(++outcome.scans, std::ssize(scans));
  }
  outcome.biases = tracker.biases();
  outcome.diagnostics = tracker.diagnostics();
  return outcome;
}

/// With offsets to estimate, twice: what the first run learnt is taken off in the second from its
/// first scan on.
Result<PassiveOutcome> follow_all(const PassiveScene& scene, const PassiveSettings& settings,
                                  std::span<const BearingScan> scans, Writers& writers,
                                  const CommonOptions& common) {
  PassiveTracker tracker(scene, settings.track, settings.associate);
  if (settings.track.estimate_bias) {
    PassiveTracker first(scene, settings.track, settings.associate);
    const auto learnt = follow(first, scans, nullptr, common);
    if (!learnt) return learnt;
    tracker.set_biases(learnt->biases);
  }
  return follow(tracker, scans, &writers, common);
}

Result<void> finish(Writers& writers, const TrackRequest& request,
                    const PassiveSettings& settings) {
  for (auto& writer : writers) {
    if (auto done = writer->finish(); !done) return done;
  }
  return write_configurations(request.outputs, settings.views());
}

nlohmann::json passive_json(const TrackRequest& request, const PassiveOutcome& outcome,
                            const PassiveScene& scene) {
  nlohmann::json biases = nlohmann::json::array();
  for (std::size_t s = 0; s < outcome.biases.size(); ++s) {
    const SensorBias& bias = outcome.biases[s];
    nlohmann::json row{{"sensor", scene.sensors[s].name},
                       {"bias_azimuth_rad", bias.azimuth_rad},
                       {"sigma_azimuth_rad", bias.sigma_azimuth_rad}};
    if (scene.sensors[s].tells_elevation()) {
      row["bias_elevation_rad"] = bias.elevation_rad;
      row["sigma_elevation_rad"] = bias.sigma_elevation_rad;
    }
    biases.push_back(std::move(row));
  }
  return {{"input", request.input},
          {"scans", outcome.scans},
          {"bearings", outcome.bearings},
          {"confirmed_tracks", outcome.confirmed.size()},
          {"largest_gap", outcome.worst_gap},
          {"biases", biases},
          {"interrupted", interrupted.load()},
          {"outputs", request.outputs},
          {"diagnostics", diagnostics_json(outcome.diagnostics)}};
}

void print_passive(const TrackRequest& request, const PassiveOutcome& outcome,
                   const PassiveScene& scene) {
  fmt::print("{}\n", request.input);
  fmt::print("  {:<18} {}\n", "scans", outcome.scans);
  fmt::print("  {:<18} {}\n", "bearings", outcome.bearings);
  fmt::print("  {:<18} {}\n", "confirmed tracks", outcome.confirmed.size());
  for (std::size_t s = 0; s < outcome.biases.size(); ++s) {
    const SensorBias& bias = outcome.biases[s];
    fmt::print("  {:<18} azimuth {:.6f} +- {:.6f} rad", "offset " + scene.sensors[s].name,
               bias.azimuth_rad, bias.sigma_azimuth_rad);
    if (scene.sensors[s].tells_elevation()) {
      fmt::print(", elevation {:.6f} +- {:.6f} rad", bias.elevation_rad, bias.sigma_elevation_rad);
    }
    fmt::print("\n");
  }
  for (const auto& path : request.outputs) fmt::print("  {:<18} {}\n", "wrote", path);
}

}  // namespace

int run_track_passive(const TrackRequest& request, const CommonOptions& common) {
  const auto settings = settings_of(request);
  if (!settings) return report_error(settings.error());
  const auto scene = io::read_sensors(request.sensors);
  if (!scene) return report_error(scene.error());
  Diagnostics diagnostics;
  const auto scans = io::read_bearings(request.input, *scene, &diagnostics);
  if (!scans) return report_error(scans.error());
  auto writers = open_writers(request);
  if (!writers) return report_error(writers.error());
  auto outcome = follow_all(*scene, *settings, *scans, *writers, common);
  if (!outcome) return report_error(outcome.error());
  outcome->diagnostics.merge(diagnostics);
  if (auto done = finish(*writers, request, *settings); !done) return report_error(done.error());
  if (request.json) {
    fmt::print("{}\n", passive_json(request, *outcome, *scene)
                           .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_passive(request, *outcome, *scene);
  }
  const int code = report_diagnostics(outcome->diagnostics, common.quiet);
  return interrupted ? kInterrupted : code;
}

std::string passive_track_help() {
  return "Settings for bearings (--set SECTION.NAME=VALUE):\n" +
         settings_help(PassiveSettings{}.views());
}

}  // namespace scanfuse::app
