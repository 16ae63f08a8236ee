#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "scanfuse/serve/scan_source.hpp"
#include "scanfuse/serve/workbench.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::testing {

/// The first scans of the second scenario of [Lu2018], with truth.
class SimulatedScans final : public serve::ScanSource {
 public:
  explicit SimulatedScans(int frames) : simulation_(make(frames)) {}

  [[nodiscard]] Result<std::optional<pipeline::PosedScan>> next() override {
    auto frame = simulation_.next();
    if (!frame) return std::optional<pipeline::PosedScan>{};
    truth_.push_back(std::move(frame->truth));
    pipeline::PosedScan posed;
    posed.scan = std::move(frame->scan);
    posed.world_from_ego = frame->ego.pose;
    posed.ego_from_sensor = simulation_.ego_from_sensor();
    return std::optional(std::move(posed));
  }
  [[nodiscard]] std::vector<TruthFrame> take_truth() override { return std::exchange(truth_, {}); }

 private:
  static simulate::Simulation make(int frames) {
    simulate::SimulateOptions options;
    options.frames = frames;
    return std::move(*simulate::Simulation::create("lu2018-2", 7, options));
  }
  simulate::Simulation simulation_;
  std::vector<TruthFrame> truth_;
};

/// A workbench that has read all of it.
inline std::unique_ptr<serve::Workbench> simulated_bench(int frames) {
  serve::WorkbenchOptions options;
  options.title = "simulated";
  options.preset = "vehicle-pag";
  options.warm_up = 5;
  auto bench = serve::Workbench::create(std::make_unique<SimulatedScans>(frames),
                                        serve::show_with(options.options), options);
  if (!bench) return nullptr;
  (*bench)->wait();
  return std::move(*bench);
}

}  // namespace scanfuse::testing
