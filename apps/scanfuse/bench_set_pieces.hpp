#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench_rows.hpp"
#include "scanfuse/pipeline/perception.hpp"

namespace scanfuse::app {

/// Identity changes a run of the tracker alone in each set piece, `runs` runs from seed 100.
[[nodiscard]] std::vector<BenchRow> bench_set_pieces(const track::TrackerOptions& options,
                                                     int runs);

/// The bend with oncoming cars, and with a crossing cyclist (by preset road-users): the whole
/// chain, and by the tracker alone with a perfect detection of whatever shows three returns.
[[nodiscard]] Result<std::vector<BenchRow>> bench_bends(const SeedRange& range,
                                                        const pipeline::PerceptionOptions& config,
                                                        int threads);

/// Thread CPU time of one step of the tracker, 10 and 2000 cars a frame.
[[nodiscard]] std::vector<BenchRow> bench_tracker_speed(const track::TrackerOptions& options);

}  // namespace scanfuse::app
