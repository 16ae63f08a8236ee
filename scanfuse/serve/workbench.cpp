#include "scanfuse/serve/workbench.hpp"

#include <algorithm>
#include <map>

namespace scanfuse::serve {
namespace {

constexpr std::uint32_t kMostScored = 20000;

/// A scan as drawn where no chain ran over it.
ShownFrame bare(const pipeline::PosedScan& posed) {
  ShownFrame frame;
  frame.step.stamp = posed.scan.stamp;
  frame.step.frame = posed.scan.frame;
  frame.step.sensor = posed.scan.sensor;
  frame.step.world_from_ego = posed.world_from_ego;
  frame.step.ego_from_sensor = posed.ego_from_sensor;
  frame.points = place_returns(posed);
  return frame;
}

}  // namespace

ShowScan show_with(pipeline::PerceptionOptions options) {
  options.pipeline.frame = pipeline::OutputFrame::kWorld;
  auto perception = std::make_shared<pipeline::Perception>(options);
  return [perception, scale = options.pipeline.scale](const pipeline::PosedScan& posed) {
    const StepResult& step = perception->step(posed);
    return show(posed, step, *perception, scale);
  };
}

ShowScan show_stored(std::vector<StepResult> steps) {
  auto by_scan = std::make_shared<std::map<Time, StepResult>>();
  for (auto& step : steps) {
    const Time stamp = step.stamp;
    by_scan->insert_or_assign(stamp, in_world(std::move(step)));
  }
  return [by_scan](const pipeline::PosedScan& posed) {
    ShownFrame frame = bare(posed);
    const auto found = by_scan->find(posed.scan.stamp);
    if (found == by_scan->end()) return frame;
    frame.step.detections = found->second.detections;
    frame.step.tracks = found->second.tracks;
    return frame;
  };
}

Workbench::Workbench(std::unique_ptr<ScanSource> source, io::Spool spool, WorkbenchOptions options)
    : source_(std::move(source)),
      spool_(std::move(spool)),
      options_(std::move(options)),
      log_(spool_),
      main_(std::make_shared<Run>(RunName::kMain, log_, spool_, 0)) {
  for (const auto& truth : options_.truth) log_.add(truth);
}

Result<std::unique_ptr<Workbench>> Workbench::create(std::unique_ptr<ScanSource> source,
                                                     ShowScan show, WorkbenchOptions options) {
  auto spool = io::Spool::create();
  if (!spool) return tl::unexpected(spool.error());
  std::unique_ptr<Workbench> bench(
      new Workbench(std::move(source), std::move(*spool), std::move(options)));
  bench->reader_ =
      std::thread([raw = bench.get(), show = std::move(show)] { raw->read_all(show); });
  bench->trier_ = std::thread([raw = bench.get()] { raw->trial_loop(); });
  return bench;
}

Workbench::~Workbench() {
  {
    const std::lock_guard lock(guard_);
    stopping_ = true;
  }
  changed_.notify_all();
  source_->stop();
  reader_.join();
  trier_.join();
}

Result<bool> Workbench::read_one(const ShowScan& show) {
  auto posed = source_->next();
  if (!posed) return tl::unexpected(posed.error());
  if (options_.truth.empty()) {
    for (auto& truth : source_->take_truth()) log_.add(std::move(truth));
  }
  if (!*posed) return false;
  const auto frame = log_.add(**posed);
  if (!frame) return tl::unexpected(frame.error());
  ShownFrame shown = show(**posed);
  shown.sensor = log_.sensor_of(*frame);
  if (auto done = main_->add(shown); !done) return tl::unexpected(done.error());
  return true;
}

void Workbench::read_all(const ShowScan& show) {
  while (true) {
    const auto more = read_one(show);
    const std::lock_guard lock(guard_);
    diagnostics_ = source_->diagnostics();
    changed_.notify_all();
    if (!more) problem_ = more.error().message;
    if (!more || !*more || stopping_) break;
  }
  const std::lock_guard lock(guard_);
  done_ = true;
  changed_.notify_all();
}

void Workbench::wait() const {
  std::unique_lock lock(guard_);
  changed_.wait(lock, [&] { return done_; });
}

BenchStatus Workbench::status() const {
  const std::lock_guard lock(guard_);
  BenchStatus status;
  status.frames = main_->end();
  status.done = done_;
  status.problem = problem_;
  status.trial = trial_number_;
  status.trial_runs = trial_runs_;
  if (trial_) {
    status.trial_from = std::max(trial_->first(), trial_from_);
    status.trial_end = trial_->end();
  }
  status.disk_bytes = spool_.bytes();
  return status;
}

Diagnostics Workbench::diagnostics() const {
  const std::lock_guard lock(guard_);
  return diagnostics_;
}

std::shared_ptr<const Run> Workbench::run(RunName name) const {
  const std::lock_guard lock(guard_);
  return name == RunName::kMain ? main_ : trial_;
}

std::optional<pipeline::PerceptionOptions> Workbench::trial_options() const {
  const std::lock_guard lock(guard_);
  return trial_options_;
}

void Workbench::start_trial(std::uint32_t from, pipeline::PerceptionOptions options) {
  {
    const std::lock_guard lock(guard_);
    wanted_ = {from, std::move(options)};
    ++trial_number_;
    trial_runs_ = true;
  }
  changed_.notify_all();
}

void Workbench::stop_trial() {
  {
    const std::lock_guard lock(guard_);
    wanted_.reset();
    ++trial_number_;  // what runs sees that it is not the newest
    trial_.reset();
    trial_options_.reset();
    trial_runs_ = false;
  }
  changed_.notify_all();
}

void Workbench::trial_loop() {
  while (true) {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [&] { return stopping_ || wanted_; });
    if (stopping_) return;
    const auto [from, options] = *std::exchange(wanted_, std::nullopt);
    const std::uint64_t trial = trial_number_;
    const std::uint32_t first = from > options_.warm_up ? from - options_.warm_up : 0;
    auto run = std::make_shared<Run>(RunName::kTrial, log_, spool_, first);
    trial_ = run;
    trial_from_ = from;
    trial_options_ = options;
    lock.unlock();
    run_trial(*run, trial, options);
    lock.lock();
    if (trial == trial_number_) trial_runs_ = false;
    changed_.notify_all();
  }
}

/// False when the scan will not come, or the trial is no longer wanted.
bool Workbench::wait_for_scan(std::uint32_t frame, std::uint64_t trial) {
  std::unique_lock lock(guard_);
  changed_.wait(
      lock, [&] { return stopping_ || trial != trial_number_ || done_ || frame < log_.size(); });
  return !stopping_ && trial == trial_number_ && frame < log_.size();
}

void Workbench::run_trial(Run& run, std::uint64_t trial,
                          const pipeline::PerceptionOptions& options) {
  const ShowScan show = show_with(options);
  for (std::uint32_t frame = run.first(); wait_for_scan(frame, trial); ++frame) {
    const auto posed = log_.get(frame);
    if (!posed) return;
    ShownFrame shown = show(*posed);
    shown.sensor = log_.sensor_of(frame);
    if (!run.add(shown)) return;
  }
}

std::optional<evaluate::Evaluation> Workbench::score(const Run& run, std::uint32_t from,
                                                     std::uint32_t end) const {
  std::vector<StepResult> steps;
  for (std::uint32_t frame = from; frame < end; ++frame) {
    auto step = run.step(frame);
    if (step) steps.push_back(std::move(*step));
  }
  if (steps.empty()) return std::nullopt;
  std::vector<TruthFrame> truth;
  for (const auto& frame : log_.truth()) {
    const Duration margin = std::chrono::milliseconds(50);
    if (frame.stamp >= steps.front().stamp - margin && frame.stamp <= steps.back().stamp + margin) {
      truth.push_back(frame);
    }
  }
  if (truth.empty()) return std::nullopt;
  return evaluate::evaluate(steps, truth, options_.scoring);
}

Result<Workbench::Comparison> Workbench::compare() const {
  const auto main = run(RunName::kMain);
  const auto trial = run(RunName::kTrial);
  Comparison comparison;
  comparison.end = trial ? std::min(main->end(), trial->end()) : main->end();
  {
    const std::lock_guard lock(guard_);
    comparison.from = trial ? std::max(trial->first(), trial_from_) : 0;
  }
  if (!log_.has_truth()) return comparison;
  if (comparison.end > kMostScored) {
    comparison.from = std::max(comparison.from, comparison.end - kMostScored);
  }
  if (comparison.from >= comparison.end) return comparison;
  comparison.main = score(*main, comparison.from, comparison.end);
  if (trial) comparison.trial = score(*trial, comparison.from, comparison.end);
  return comparison;
}

}  // namespace scanfuse::serve
