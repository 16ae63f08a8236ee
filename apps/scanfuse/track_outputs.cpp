#include "track_outputs.hpp"

#include <nlohmann/json.hpp>

#include "class_tables.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/io/toml.hpp"

namespace scanfuse::app {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string milli(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "-";
}

Rows metric_rows(const evaluate::Evaluation& score) {
  return {{"MOTA", milli(score.clear.mota)},
          {"identity switches", std::to_string(score.clear.identity_switches)},
          {"IDF1", milli(score.identity.idf1)},
          {"HOTA", milli(score.hota.hota)},
          {"position RMSE / m", milli(score.rmse.position_m)},
          {"velocity RMSE / (m/s)", milli(score.rmse.velocity_m_per_s)},
          {"heading RMSE mod pi / rad", milli(score.rmse.heading_mod_pi_rad)},
          {"GOSPA / m", milli(score.sets.gospa_m)},
          {"median NEES (4 states)", milli(score.consistency.nees_median)},
          {"false tracks per frame", milli(score.ghosts_per_frame)}};
}

Rows diagnostic_rows(const Diagnostics& diagnostics) {
  Rows rows;
  for (const auto& [what, entry] : diagnostics.entries()) {
    rows.emplace_back(what, fmt::format("{}{}{}", entry.count,
                                        entry.first.empty() ? "" : ", first: ", entry.first));
  }
  return rows;
}

/// Of the options only what was changed: the file beside the result has all of them.
std::string changed_options(const TrackRequest& request,
                            const pipeline::PerceptionOptions& options) {
  std::string text = "preset " + request.preset;
  for (const auto& view : pipeline::view_config(options)) {
    if (view.value != view.fallback) {
      text += fmt::format("\n{}.{} = {}", view.section, view.name, view.value);
    }
  }
  return text;
}

std::filesystem::path beside(const std::string& result) {
  return std::filesystem::path(result).replace_extension(".config.toml");
}

}  // namespace

Result<TrackOutputs> TrackOutputs::open(const TrackRequest& request) {
  TrackOutputs outputs;
  auto paths = request.outputs;
  paths.insert(paths.end(), {request.detections, request.report});
  for (const auto& path : paths) {
    if (auto fine = refuse_to_replace(request.input, path); !fine)
      return tl::unexpected(fine.error());
  }
  for (const auto& path : request.outputs) {
    auto writer = io::open_result_writer(path);
    if (!writer) return tl::unexpected(writer.error());
    outputs.results_.push_back(std::move(*writer));
  }
  if (!request.detections.empty()) {
    auto file = io::AtomicFile::create(request.detections);
    if (!file) return tl::unexpected(file.error());
    outputs.detections_ = std::move(*file);
    if (auto done = outputs.detections_->write(io::detection_header()); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (!request.report.empty()) outputs.report_ = std::make_unique<report::TrackReport>();
  return outputs;
}

Result<void> TrackOutputs::write(const StepResult& step, const Scan& scan, const VirtualScan* flat,
                                 const Clusters* clusters) {
  for (auto& writer : results_) {
    if (auto done = writer->write(step, scan); !done) return done;
  }
  if (detections_) {
    const io::DetectionFrame frame{step.stamp, step.frame, step.sensor, step.detections};
    if (auto done = detections_->write(io::detection_rows(frame)); !done) return done;
  }
  if (report_) report_->add(step, scan, flat, clusters);
  return {};
}

Result<void> TrackOutputs::write(const TruthFrame& truth) {
  for (auto& writer : results_) {
    if (auto done = writer->write(truth); !done) return done;
  }
  if (report_) report_->add(truth);
  return {};
}

void TrackOutputs::show(std::span<const TruthFrame> truth) {
  if (!report_) return;
  for (const auto& frame : truth) report_->add(frame);
}

Result<void> TrackOutputs::finish(const TrackRequest& request, const TrackOutcome& outcome,
                                  const pipeline::PerceptionOptions& options) {
  for (auto& writer : results_) {
    if (auto done = writer->finish(); !done) return done;
  }
  if (detections_) {
    if (auto done = detections_->commit(); !done) return done;
  }
  if (report_) {
    report::TrackReportHeader header;
    header.input = std::filesystem::path(request.input).filename().string();
    header.configuration = changed_options(request, options);
    header.summary = summary_rows(outcome);
    if (outcome.score) header.metrics = metric_rows(*outcome.score);
    add_class_figures(outcome.by_class, header);
    header.diagnostics = diagnostic_rows(outcome.diagnostics);
    if (auto done = io::write_whole(request.report, report_->html(header)); !done) return done;
  }
  return write_configurations(request.outputs, pipeline::view_config(options));
}

Result<void> write_configurations(const std::vector<std::string>& results,
                                  const std::vector<OptionView>& options) {
  const std::string resolved = io::write_toml(options);
  for (const auto& path : results) {
    if (auto done = io::write_whole(beside(path), resolved); !done) return done;
  }
  return {};
}

nlohmann::json diagnostics_json(const Diagnostics& diagnostics) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [what, entry] : diagnostics.entries()) {
    json[what] = {{"count", entry.count}, {"first", entry.first}, {"damage", entry.damage}};
  }
  return json;
}

Rows summary_rows(const TrackOutcome& outcome) {
  Rows rows{{"scans", std::to_string(outcome.scans)},
            {"returns", std::to_string(outcome.returns)},
            {"detections", std::to_string(outcome.detections)},
            {"confirmed tracks", std::to_string(outcome.tracks)}};
  if (outcome.first && outcome.last) {
    rows.emplace_back("duration",
                      fmt::format("{:.1f} s", to_seconds(*outcome.last - *outcome.first)));
  }
  if (outcome.scans > 0) {
    rows.emplace_back("time per scan",
                      fmt::format("median {:.0f} us, 99 % {:.0f} us", 1e6 * outcome.median_scan_s,
                                  1e6 * outcome.p99_scan_s));
  }
  return rows;
}

}  // namespace scanfuse::app
