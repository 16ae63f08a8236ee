#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::app {

/// One figure of a benchmark: what was measured, a peer's figure where there is one, the target
/// where one was set, and whether it is met.
struct BenchRow {
  std::string name;
  double value = 0;
  std::string unit;
  std::optional<double> peer;
  std::optional<double> target;
  std::optional<bool> met;
};

struct BenchOptions {
  int seeds = 20;
  std::uint64_t first_seed = 1;
  int threads = 0;
  std::string preset = "vehicle-pag";
  std::vector<std::string> set;  ///< section.option=value
};

/// The three scenarios of [Lu2018] by the chain of a preset, against truth.
[[nodiscard]] Result<std::vector<BenchRow>> bench_track(const BenchOptions& options);

}  // namespace scanfuse::app
