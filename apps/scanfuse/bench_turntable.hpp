#pragma once

#include <optional>

#include "bench_rows.hpp"
#include "scanfuse/calibrate/turntable.hpp"
#include "turntable_errors.hpp"

namespace scanfuse::app {

/// The rows of `bench turntable` that come from rendered images, files and simulated scans: errors
/// of the joint result, a disc measured by the rig that was found, where the time goes. Only the
/// first few of the seeds, since rendering takes its time.
[[nodiscard]] std::vector<BenchRow> bench_turntable_images(const SeedRange& seeds, int threads);

}  // namespace scanfuse::app
