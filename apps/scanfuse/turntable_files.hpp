#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "scanfuse/core/result.hpp"
#include "scanfuse/simulate/turntable_features.hpp"
#include "scanfuse/simulate/turntable_images.hpp"

/// Files of a simulated turntable session (docs/turntable-session.md).
namespace scanfuse::app {

struct SessionImageOptions {
  simulate::TurntableImageOptions images;
  bool laser_off = false;
  std::uint64_t seed = 0;
  int threads = 0;
  /// Called with positions done and all; true asks to stop.
  std::function<bool(std::size_t, std::size_t)> progress;
};

[[nodiscard]] Result<void> make_folder(const std::filesystem::path& folder);

/// session.toml and truth.toml.
[[nodiscard]] Result<void> write_session_about(const std::filesystem::path& folder,
                                               const simulate::SimulatedTurntable& made);

/// scan_0000.csv, ...
[[nodiscard]] Result<void> write_session_scans(const std::filesystem::path& folder,
                                               const simulate::SimulatedTurntable& made);

/// Renders and writes board.png, stripe_0000.png, ...; some are missing where it was stopped.
[[nodiscard]] Result<void> write_session_images(const std::filesystem::path& folder,
                                                const simulate::SimulatedTurntable& made,
                                                const SessionImageOptions& options);

}  // namespace scanfuse::app
