#include <atomic>
#include <memory>

#include "view_run.hpp"

namespace scanfuse::app {
namespace {

/// Sensors that are running, until stopped.
class LiveScans final : public serve::ScanSource {
 public:
  explicit LiveScans(LiveInput input)
      : bus_(std::move(input.bus)),
        feed_(
            (input.stream->stop_when([this] { return stopping_.load(); }), std::move(input.stream)),
            input.feed) {}

  [[nodiscard]] Result<std::optional<pipeline::PosedScan>> next() override { return feed_.next(); }
  void stop() override { stopping_ = true; }
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] Diagnostics diagnostics() const override { return feed_.diagnostics(); }

 private:
  std::atomic<bool> stopping_ = false;
  std::shared_ptr<drivers::Ros2Bus> bus_;
  pipeline::ScanFeed feed_;
};

std::string title_of(const LiveRequest& live) {
  return fmt::format("{}", fmt::join(live.sensors.empty() ? live.topics : live.sensors, ", "));
}

}  // namespace

Result<std::unique_ptr<serve::Workbench>> open_live_bench(const TrackRequest& request,
                                                          const LiveRequest& live) {
  const auto options = resolve_options(request);
  if (!options) return tl::unexpected(options.error());
  auto input = open_live(live);
  if (!input) return tl::unexpected(input.error());
  serve::WorkbenchOptions bench;
  bench.title = title_of(live);
  bench.preset = request.preset;
  bench.options = *options;
  return serve::Workbench::create(std::make_unique<LiveScans>(std::move(*input)),
                                  serve::show_with(*options), std::move(bench));
}

}  // namespace scanfuse::app
