#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/serve/run.hpp"
#include "scanfuse/serve/scan_source.hpp"

namespace scanfuse::serve {

/// Makes of a scan what is shown. Called by one thread, scan after scan.
using ShowScan = std::function<ShownFrame(const pipeline::PosedScan&)>;

/// The chain of docs/architecture.md; results are given in the world frame.
[[nodiscard]] ShowScan show_with(pipeline::PerceptionOptions options);

/// Results that were stored with their recording, matched by sensor and scan number.
[[nodiscard]] ShowScan show_stored(std::vector<StepResult> steps);

struct WorkbenchOptions {
  std::string title;  ///< name of the recording
  std::string preset;
  pipeline::PerceptionOptions options;
  evaluate::EvaluateOptions scoring;
  std::vector<TruthFrame> truth;  ///< besides what comes along with the scans
  std::uint32_t warm_up = 30;  ///< frames before its first that a trial sees, so that tracks live
};

/// What runs, for the page's status line.
struct BenchStatus {
  std::uint32_t frames = 0;
  bool done = false;    ///< the recording is read
  std::string problem;  ///< why reading ended early; empty: it did not
  std::uint32_t trial_from = 0, trial_end = 0;
  bool trial_runs = false;
  std::uint64_t trial = 0;  ///< counts the trials; 0: there was none
  std::uint64_t disk_bytes = 0;
};

/// Runs the chain over the scans of a source in a thread of its own and keeps what it gave on disk,
/// so that every frame can be asked for; beside it a trial of other options over the same scans.
/// All members may be called from any thread.
class Workbench {
 public:
  /// `show` is what makes the main run of `options.options` or of stored results.
  [[nodiscard]] static Result<std::unique_ptr<Workbench>> create(std::unique_ptr<ScanSource> source,
                                                                 ShowScan show,
                                                                 WorkbenchOptions options);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  [[nodiscard]] BenchStatus status() const;
  [[nodiscard]] const WorkbenchOptions& options() const { return options_; }
  [[nodiscard]] const ScanLog& log() const { return log_; }
  [[nodiscard]] Diagnostics diagnostics() const;
  [[nodiscard]] bool is_live() const { return source_->is_live(); }
  /// Nothing where no trial was started.
  [[nodiscard]] std::shared_ptr<const Run> run(RunName name) const;

  /// Starts the trial over from that frame; one that runs is ended first: newest wins.
  void start_trial(std::uint32_t from, pipeline::PerceptionOptions options);
  void stop_trial();
  [[nodiscard]] std::optional<pipeline::PerceptionOptions> trial_options() const;

  /// Both runs over the frames that both have, at most the last 20 000 of them; over the main run's
  /// alone without a trial. Empty without truth.
  struct Comparison {
    std::uint32_t from = 0, end = 0;
    std::optional<evaluate::Evaluation> main, trial;
  };
  [[nodiscard]] Result<Comparison> compare() const;

  /// Blocks until the recording is read, or reading failed.
  void wait() const;

 private:
  Workbench(std::unique_ptr<ScanSource> source, io::Spool spool, WorkbenchOptions options);
  void read_all(const ShowScan& show);
  [[nodiscard]] Result<bool> read_one(const ShowScan& show);
  void run_trial(Run& run, std::uint64_t trial, const pipeline::PerceptionOptions& options);
  [[nodiscard]] bool wait_for_scan(std::uint32_t frame, std::uint64_t trial);
  [[nodiscard]] std::optional<evaluate::Evaluation> score(const Run& run, std::uint32_t from,
                                                          std::uint32_t end) const;
  void trial_loop();

  std::unique_ptr<ScanSource> source_;
  io::Spool spool_;
  WorkbenchOptions options_;
  ScanLog log_;

  mutable std::mutex guard_;
  mutable std::condition_variable changed_;
  std::shared_ptr<Run> main_, trial_;
  bool done_ = false, stopping_ = false, trial_runs_ = false;
  std::string problem_;
  Diagnostics diagnostics_;
  std::uint64_t trial_number_ = 0;
  std::uint32_t trial_from_ = 0;
  std::optional<pipeline::PerceptionOptions> trial_options_;
  std::optional<std::pair<std::uint32_t, pipeline::PerceptionOptions>> wanted_;
  std::thread reader_, trier_;
};

}  // namespace scanfuse::serve
