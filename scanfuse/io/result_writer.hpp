#pragma once

#include <filesystem>
#include <memory>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::io {

/// Takes the results of a run scan by scan. Writes to a temporary name beside the target; only
/// `finish` moves it into place, so that a half-written file never looks whole. Destroyed without
/// `finish`, it removes what it wrote.
class ResultWriter {
 public:
  virtual ~ResultWriter() = default;
  /// `scan` is the input of this step, passed through by formats that can carry it.
  [[nodiscard]] virtual Result<void> write(const StepResult& step, const Scan& scan) = 0;
  /// Truth that the recording carried, passed through likewise.
  [[nodiscard]] virtual Result<void> write(const TruthFrame& truth) = 0;
  /// Closes the file and moves it into place.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

/// By extension: `.mcap` (scans, boxes, trails, tracks, detections), `.csv` or `.jsonl` (tracks).
[[nodiscard]] Result<std::unique_ptr<ResultWriter>> open_result_writer(
    const std::filesystem::path& path);

}  // namespace scanfuse::io
