#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"

namespace scanfuse::serve {

/// Where the viewer's scans come from: a recording, or sensors that are running. Read by one
/// thread.
class ScanSource {
 public:
  virtual ~ScanSource() = default;
  /// The next scan; nothing at the end. A live source waits for it.
  [[nodiscard]] virtual Result<std::optional<pipeline::PosedScan>> next() = 0;
  /// Truth that came along since the last call.
  [[nodiscard]] virtual std::vector<TruthFrame> take_truth() { return {}; }
  /// From another thread: a `next` that waits gives nothing, soon.
  virtual void stop() {}
  [[nodiscard]] virtual bool is_live() const { return false; }
  [[nodiscard]] virtual Diagnostics diagnostics() const { return {}; }
};

/// The scans of a recording, of all sensors or of those named.
class RecordedScans final : public ScanSource {
 public:
  RecordedScans(pipeline::ScanFeed feed, std::vector<std::string> sensors)
      : feed_(std::move(feed)), sensors_(std::move(sensors)) {}
  [[nodiscard]] Result<std::optional<pipeline::PosedScan>> next() override;
  [[nodiscard]] std::vector<TruthFrame> take_truth() override { return feed_.take_truth(); }
  [[nodiscard]] Diagnostics diagnostics() const override { return feed_.diagnostics(); }

 private:
  pipeline::ScanFeed feed_;
  std::vector<std::string> sensors_;
};

}  // namespace scanfuse::serve
