#include "track_passive.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "scanfuse/triangulate/passive_tracker.hpp"
#include "track_outputs.hpp"
#include "track_passive_report.hpp"

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
  const std::pair<const char*, bool> others[] = {{"--detections", !request.detections.empty()},
                                                 {"--config", !request.config.empty()},
                                                 {"--topic", !request.topics.empty()},
                                                 {"--ego", !request.ego_file.empty()},
                                                 {"--ego-topic", !request.ego_topic.empty()},
                                                 {"--mount", !request.mount.empty()},
                                                 {"--standing", request.standing},
                                                 {"--calib", !request.calibration.empty()},
                                                 {"--frame", !request.frame.empty()}};
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

struct PassiveTrackOutcome {
  std::int64_t scans = 0;
  std::size_t bearings = 0;
  std::set<std::int64_t> confirmed;
  double worst_gap = 0;
  std::vector<SensorBias> biases;
  std::optional<evaluate::Evaluation> score;  ///< where truth was asked for
  Diagnostics diagnostics;
};

using Writers = std::vector<std::unique_ptr<io::ResultWriter>>;

Result<void> refuse_replacing(const TrackRequest& request) {
  auto outputs = request.outputs;
  if (!request.report.empty()) outputs.push_back(request.report);
  for (const auto& path : outputs) {
    for (const auto& in : {request.input, request.sensors, request.truth.path}) {
      if (in.empty()) continue;
      if (auto fine = refuse_to_replace(in, path); !fine) return fine;
    }
  }
  return {};
}

Result<Writers> open_writers(const TrackRequest& request) {
  Writers writers;
  for (const auto& path : request.outputs) {
    auto writer = io::open_result_writer(path);
    if (!writer) return tl::unexpected(writer.error());
    writers.push_back(std::move(*writer));
  }
  return writers;
}

/// Where tracks go: files, the comparison with truth, a page.
struct Sinks {
  Writers writers;
  Scorer scorer;
  std::optional<PassiveTrackReport> report;

  [[nodiscard]] Result<void> take(const BearingScan& scan, const triangulate::PassiveStep& found) {
    const StepResult step = as_step(scan, found);
    Scan none;
    none.stamp = scan.stamp;
    for (auto& writer : writers) {
      if (auto wrote = writer->write(step, none); !wrote) return wrote;
    }
    scorer.add(step);
    if (report) report->add(scan, found);
    return {};
  }
};

Result<PassiveTrackOutcome> follow(PassiveTracker& tracker, std::span<const BearingScan> scans,
                                   Sinks* sinks, const CommonOptions& common) {
  PassiveTrackOutcome outcome;
  Progress progress(sinks ? "tracking" : "estimating offsets", common.quiet);
  for (const BearingScan& scan : scans) {
    if (interrupted) break;
    const auto found = tracker.step(scan, common.threads);
    if (!found) return tl::unexpected(found.error());
    outcome.bearings += scan.bearings.size();
    outcome.worst_gap = std::max(outcome.worst_gap, found->gap);
    for (const PassiveTrack& track : found->tracks) {
      if (track.confirmed) outcome.confirmed.insert(track.id);
    }
    if (sinks) {
      if (auto taken = sinks->take(scan, *found); !taken) return tl::unexpected(taken.error());
    }
    progress.update(++outcome.scans, std::ssize(scans));
  }
  outcome.biases = tracker.biases();
  outcome.diagnostics = tracker.diagnostics();
  return outcome;
}

/// With offsets to estimate, twice: what the first run learnt is taken off in the second from its
/// first scan on.
Result<PassiveTrackOutcome> follow_all(const PassiveScene& scene, const PassiveSettings& settings,
                                       std::span<const BearingScan> scans, Sinks& sinks,
                                       const CommonOptions& common) {
  PassiveTracker tracker(scene, settings.track, settings.associate);
  if (settings.track.estimate_bias) {
    PassiveTracker first(scene, settings.track, settings.associate);
    const auto learnt = follow(first, scans, nullptr, common);
    if (!learnt) return learnt;
    tracker.set_biases(learnt->biases);
  }
  return follow(tracker, scans, &sinks, common);
}

std::string three_digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "-";
}

report::ReportTable score_table(const evaluate::Evaluation& score) {
  return {
      "Against truth",
      {"MOTA", "identity switches", "IDF1", "HOTA", "GOSPA [m]", "position RMSE [m]",
       "velocity RMSE [m/s]", "median NEES"},
      {{three_digits(score.clear.mota), fmt::format("{}", score.clear.identity_switches),
        three_digits(score.identity.idf1), three_digits(score.hota.hota),
        three_digits(score.sets.gospa_m), three_digits(score.rmse.position_m),
        three_digits(score.rmse.velocity_m_per_s), three_digits(score.consistency.nees_median)}}};
}

Result<void> write_report(const PassiveTrackReport& report, const TrackRequest& request,
                          const PassiveTrackOutcome& outcome) {
  auto file = io::AtomicFile::create(request.report);
  if (!file) return tl::unexpected(file.error());
  std::vector<report::ReportTable> tables;
  if (outcome.score) tables.push_back(score_table(*outcome.score));
  if (auto wrote = file->write(report.page(request.input, tables)); !wrote) return wrote;
  return file->commit();
}

/// Compares with truth, and moves all files into place.
Result<void> finish(Sinks& sinks, const TrackRequest& request, const PassiveSettings& settings,
                    PassiveTrackOutcome& outcome) {
  if (auto done = sinks.scorer.finish(outcome.diagnostics); !done) return done;
  if (const auto score = sinks.scorer.score()) outcome.score = score->all;
  for (auto& writer : sinks.writers) {
    if (auto done = writer->finish(); !done) return done;
  }
  if (sinks.report) {
    sinks.report->show(sinks.scorer.truth());
    if (auto done = write_report(*sinks.report, request, outcome); !done) return done;
  }
  return write_configurations(request.outputs, settings.views());
}

nlohmann::json passive_json(const TrackRequest& request, const PassiveTrackOutcome& outcome,
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
  nlohmann::json json{{"input", request.input},
                      {"scans", outcome.scans},
                      {"bearings", outcome.bearings},
                      {"confirmed_tracks", outcome.confirmed.size()},
                      {"largest_gap", outcome.worst_gap},
                      {"biases", biases},
                      {"interrupted", interrupted.load()},
                      {"outputs", request.outputs},
                      {"diagnostics", diagnostics_json(outcome.diagnostics)}};
  if (outcome.score) json["evaluation"] = nlohmann::json::parse(to_json(*outcome.score));
  return json;
}

void print_passive(const TrackRequest& request, const PassiveTrackOutcome& outcome,
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
  if (outcome.score) {
    const auto& score = *outcome.score;
    fmt::print("  {:<18} MOTA {}, {} identity switches, position RMSE {} m\n", "against truth",
               three_digits(score.clear.mota), score.clear.identity_switches,
               three_digits(score.rmse.position_m));
  }
  for (const auto& path : request.outputs) fmt::print("  {:<18} {}\n", "wrote", path);
  if (!request.report.empty()) fmt::print("  {:<18} {}\n", "wrote", request.report);
}

Result<Sinks> open_sinks(const TrackRequest& request, const PassiveScene& scene,
                         std::size_t scans) {
  if (auto fine = refuse_replacing(request); !fine) return tl::unexpected(fine.error());
  auto scorer = Scorer::create(request.truth, request.scoring, request.input);
  if (!scorer) return tl::unexpected(scorer.error());
  auto writers = open_writers(request);
  if (!writers) return tl::unexpected(writers.error());
  Sinks sinks{std::move(*writers), std::move(*scorer), {}};
  if (!request.report.empty()) sinks.report.emplace(scene, scans);
  return sinks;
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

int run_track_passive(const TrackRequest& request, const CommonOptions& common) {
  const auto settings = settings_of(request);
  if (!settings) return report_error(settings.error());
  const auto scene = io::read_sensors(request.sensors);
  if (!scene) return report_error(scene.error());
  Diagnostics diagnostics;
  const auto scans = io::read_bearings(request.input, *scene, &diagnostics);
  if (!scans) return report_error(scans.error());
  auto sinks = open_sinks(request, *scene, scans->size());
  if (!sinks) return report_error(sinks.error());
  auto outcome = follow_all(*scene, *settings, *scans, *sinks, common);
  if (!outcome) return report_error(outcome.error());
  outcome->diagnostics.merge(diagnostics);
  if (auto done = finish(*sinks, request, *settings, *outcome); !done) {
    return report_error(done.error());
  }
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
