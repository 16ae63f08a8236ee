#include "turntable_files.hpp"

#include <system_error>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/image.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/io/session/session_folder.hpp"

namespace scanfuse::app {
namespace {

namespace fs = std::filesystem;
using simulate::SimulatedTurntable;

io::SessionFile session_file_of(const SimulatedTurntable& made) {
  io::SessionFile session;
  session.camera = made.features.camera;
  for (const BoardSpec& board : made.features.boards) session.boards.push_back({board, ""});
  for (const auto& position : made.features.positions) {
    session.turntable_rad.push_back(position.turntable_rad);
  }
  return session;
}

}  // namespace

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return {};
  return fail(Error::Code::kNotFound, "{}: cannot be created: {}", folder.string(),
              error.message());
}

Result<void> write_session_about(const fs::path& folder, const SimulatedTurntable& made) {
  auto wrote = io::write_rig(folder / "truth.toml", {made.world.rig, made.world.camera});
  if (!wrote) return wrote;
  return io::write_whole(folder / "session.toml", io::session_file_text(session_file_of(made)));
}

Result<void> write_session_scans(const fs::path& folder, const SimulatedTurntable& made) {
  const io::LidarConventions conventions;
  for (std::size_t k = 0; k < made.features.positions.size(); ++k) {
    const auto text = io::scan_table_text(made.features.positions[k].scan, conventions);
    auto wrote = io::write_whole(folder / io::numbered_name("scan", k, ".csv"), text);
    if (!wrote) return wrote;
  }
  return {};
}

Result<void> write_session_images(const fs::path& folder, const SimulatedTurntable& made,
                                  const SessionImageOptions& options) {
  const simulate::TurntableRenderer renderer(made.world, options.images, options.seed,
                                             options.threads);
  if (auto wrote = io::write_png(folder / "board.png", renderer.bright()); !wrote) return wrote;
  const std::size_t count = made.features.positions.size();
  std::vector<Result<void>> done(count);
  // In blocks, so that progress is told and a wish to stop is heard.
  constexpr std::size_t kBlock = 8;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    parallel_for(std::min(kBlock, count - begin), options.threads, [&](std::size_t i) {
      const std::size_t k = begin + i;
      done[k] = io::write_png(folder / io::numbered_name("stripe", k, ".png"),
                              renderer.stripe(k, made.turned_rad[k]));
      if (done[k] && options.laser_off) {
        done[k] = io::write_png(folder / io::numbered_name("stripe", k, "_off.png"),
                                renderer.laser_off(k));
      }
    });
    const std::size_t end = std::min(begin + kBlock, count);
    if (options.progress && options.progress(end, count)) break;
  }
  for (auto& each : done) {
    if (!each) return each;
  }
  return {};
}

}  // namespace scanfuse::app
