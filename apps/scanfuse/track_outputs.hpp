#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "scanfuse/report/track_report.hpp"
#include "track_run.hpp"

namespace scanfuse::app {

/// Every file that `track` writes, fed scan by scan; all of them appear at the end or not at all.
class TrackOutputs {
 public:
  [[nodiscard]] static Result<TrackOutputs> open(const TrackRequest& request);

  [[nodiscard]] Result<void> write(const StepResult& step, const Scan& scan,
                                   const VirtualScan* flat, const Clusters* clusters);
  [[nodiscard]] Result<void> write(const TruthFrame& truth);
  /// Truth that is not part of the recording: for the report only.
  void show(std::span<const TruthFrame> truth);
  /// Moves everything into place: results, detections, report, and beside each result the options
  /// it was made with.
  [[nodiscard]] Result<void> finish(const TrackRequest& request, const TrackOutcome& outcome,
                                    const pipeline::PerceptionOptions& options);

 private:
  std::vector<std::unique_ptr<io::ResultWriter>> results_;
  std::optional<io::AtomicFile> detections_;
  std::unique_ptr<report::TrackReport> report_;
};

/// The resolved configuration beside each result: OUT.config.toml.
[[nodiscard]] Result<void> write_configurations(const std::vector<std::string>& results,
                                                const std::vector<OptionView>& options);

/// What was odd, by name, as `--json` tells it.
[[nodiscard]] nlohmann::json diagnostics_json(const Diagnostics& diagnostics);

/// (name, value) rows for people.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> summary_rows(
    const TrackOutcome& outcome);

}  // namespace scanfuse::app
