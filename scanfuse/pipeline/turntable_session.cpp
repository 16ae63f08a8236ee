#include "scanfuse/pipeline/turntable_session.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/io/image.hpp"

namespace scanfuse::pipeline {
namespace {

using Boards = std::array<camera::DetectedBoard, 2>;
constexpr std::size_t kFewestPositions = 3;

/// Seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Every n-th pixel of every n-th row, so that the width fits; the brightest of each block, for a
/// thin stripe to stay visible.
Thumbnail thumbnail_of(const Image& image, int width_px) {
  Thumbnail small;
  if (width_px <= 0 || image.width_px <= 0) return small;
  const int n = std::max((image.width_px + width_px - 1) / width_px, 1);
  small.scale = n;
  small.image.width_px = image.width_px / n;
  small.image.height_px = image.height_px / n;
  small.image.channels = 1;
  for (int y = 0; y < small.image.height_px; ++y) {
    for (int x = 0; x < small.image.width_px; ++x) {
      std::uint8_t brightest = 0;
      for (int k = 0; k < n * n; ++k) {
        for (int c = 0; c < image.channels; ++c) {
          brightest = std::max(brightest, image.at(n * x + k % n, n * y + k / n, c));
        }
      }
      small.image.pixels.push_back(brightest);
    }
  }
  return small;
}

Result<void> check_size(const Image& image, const Camera& camera, const std::string& name) {
  if (image.width_px == camera.width_px && image.height_px == camera.height_px) return {};
  return fail(Error::Code::kMalformed,
              "{}: {} x {} pixels; session.toml's [camera] says {} x {}: give the intrinsics of "
              "this image size",
              name, image.width_px, image.height_px, camera.width_px, camera.height_px);
}

/// Corners of both boards from one image of both, or an image of each.
Result<Boards> find_boards(const io::SessionFolder& session, const SessionLoadOptions& options,
                           LoadedSession& loaded) {
  const std::array<BoardSpec, 2>& specs = loaded.features.boards;
  const auto read = [&](const std::filesystem::path& path) -> Result<Image> {
    auto image = io::read_image(path);
    if (!image) return image;
    if (auto same = check_size(*image, loaded.features.camera, path.string()); !same) {
      return tl::unexpected(same.error());
    }
    loaded.board = thumbnail_of(*image, 2 * options.thumbnail_width_px);
    return image;
  };
  Boards boards;
  if (!session.about.boards[0].image.empty() && !session.about.boards[1].image.empty()) {
    for (std::size_t b = 0; b < 2; ++b) {
      const auto path = session.folder / session.about.boards[b].image;
      const auto image = read(path);
      if (!image) return tl::unexpected(image.error());
      auto found = camera::find_board(*image, specs[b], options.boards);
      if (!found) return fail(found.error().code, "{}: {}", path.string(), found.error().message);
      boards[b] = std::move(*found);
    }
    return boards;
  }
  if (session.board_images.empty()) {
    return fail(Error::Code::kNotFound,
                "{}: no board*.png: a bright image of both boards, seen by the camera as it stands",
                session.folder.string());
  }
  // The first in which both are found; the error is that of the first.
  std::optional<Error> first;
  for (const auto& path : session.board_images) {
    const auto image = read(path);
    if (!image) return tl::unexpected(image.error());
    auto found = camera::find_two_boards(*image, specs, options.boards);
    if (found) return std::move(*found);
    if (!first) first = Error{found.error().code, path.string() + ": " + found.error().message};
  }
  return tl::unexpected(*first);
}

/// One position's stripes; the reason where it cannot be used.
std::string find_position(const io::SessionPosition& files, const Boards& boards,
                          const SessionLoadOptions& options, const Camera& camera,
                          TurntablePosition& position, Thumbnail& thumbnail) {
  const auto image = io::read_image(files.stripe);
  if (!image) return image.error().message;
  if (auto same = check_size(*image, camera, files.stripe.string()); !same) {
    return same.error().message;
  }
  std::optional<Image> off;
  if (!files.stripe_off.empty()) {
    auto read = io::read_image(files.stripe_off);
    if (!read) return read.error().message;
    off = std::move(*read);
  }
  thumbnail = thumbnail_of(*image, options.thumbnail_width_px);
  const auto stripes = camera::find_stripes(*image, off ? &*off : nullptr, boards, options.stripes);
  if (!stripes) return files.stripe.string() + ": " + stripes.error().message;
  std::string reason;
  for (std::size_t b = 0; b < 2; ++b) {
    const camera::Stripe& stripe = (*stripes)[b];
    position.stripe_px[b] = stripe.positions();
    if (stripe.found()) continue;
    if (!reason.empty()) reason += "; ";
    reason += fmt::format("{}: no stripe on board {}: {}", files.stripe.filename().string(), b,
                          stripe.reason);
  }
  return reason;
}

void find_all_stripes(const io::SessionFolder& session, const Boards& boards,
                      const SessionLoadOptions& options, LoadedSession& loaded) {
  auto& positions = loaded.features.positions;
  std::vector<std::string> reasons(positions.size());
  loaded.stripes.resize(positions.size());
  std::size_t done = 0;
  std::mutex telling;
  std::atomic<bool> stop{false};
  parallel_for(positions.size(), options.threads, [&](std::size_t k) {
    if (stop) return;
    if (session.positions[k].stripe.empty()) {
      reasons[k] = io::numbered_name("stripe", k, ".png") + " is missing";
    } else {
      reasons[k] = find_position(session.positions[k], boards, options, loaded.features.camera,
                                 positions[k], loaded.stripes[k]);
    }
    const std::scoped_lock lock(telling);
    if (options.progress && options.progress(++done, positions.size())) stop = true;
  });
  loaded.stopped = stop;
  for (std::size_t k = 0; k < reasons.size(); ++k) {
    if (!reasons[k].empty()) loaded.left_out.push_back({k, reasons[k]});
  }
}

Result<void> find_camera(const io::SessionFolder& session, const SessionLoadOptions& options,
                         LoadedSession& loaded) {
  if (session.about.camera) return {};
  if (!session.about.camera_images) {
    return fail(Error::Code::kMalformed,
                "{}: no [camera]: give its intrinsics, or images to calibrate it from",
                (session.folder / "session.toml").string());
  }
  auto made =
      calibrate_camera_from(session.camera_images, session.about.camera_images->board, options);
  if (!made) return tl::unexpected(made.error());
  for (const auto& fault : made->left_out) {
    loaded.diagnostics.note("camera image without the board left out", fault);
  }
  loaded.features.camera = made->calibration.camera;
  loaded.camera = std::move(made->calibration);
  return {};
}

/// Positions in order of their angle, everything about them with them.
void sort_positions(LoadedSession& loaded) {
  auto& positions = loaded.features.positions;
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return positions[a].turntable_rad < positions[b].turntable_rad;
  });
  if (std::ranges::is_sorted(order)) return;
  const bool falling = std::ranges::is_sorted(order, std::greater<>{});
  if (!falling) loaded.diagnostics.note("turntable angles do not ascend, positions sorted");
  std::vector<TurntablePosition> sorted;
  std::vector<Thumbnail> thumbnails(loaded.stripes.size());
  std::vector<std::size_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    sorted.push_back(std::move(positions[order[k]]));
    if (k < thumbnails.size()) thumbnails[k] = std::move(loaded.stripes[order[k]]);
  }
  positions = std::move(sorted);
  loaded.stripes = std::move(thumbnails);
  for (auto& entry : loaded.left_out) entry.position = place[entry.position];
}

Result<void> find_in_images(const io::SessionFolder& session, const SessionLoadOptions& options,
                            LoadedSession& loaded) {
  Stopwatch watch;
  const auto boards = find_boards(session, options, loaded);
  loaded.seconds_boards += watch.lap();
  if (!boards) return tl::unexpected(boards.error());
  for (std::size_t b = 0; b < 2; ++b) loaded.features.corners_px[b] = (*boards)[b].corners_px;
  find_all_stripes(session, *boards, options, loaded);
  loaded.seconds_stripes = watch.lap();
  return {};
}

}  // namespace

Result<LoadedSession> load_turntable_session(const std::filesystem::path& folder,
                                             const SessionLoadOptions& options) {
  Stopwatch watch;
  const auto session = io::open_session(folder);
  if (!session) return tl::unexpected(session.error());
  if (session->about.boards.empty()) {
    return fail(Error::Code::kMalformed,
                "{}: no [[board]]: give rows, columns and square_m of both boards",
                (folder / "session.toml").string());
  }
  if (session->positions.size() < kFewestPositions) {
    return fail(Error::Code::kOutOfRange,
                "{}: {} positions; a turntable needs at least {} (turn further and scan again)",
                (folder / "session.toml").string(), session->positions.size(), kFewestPositions);
  }
  auto content = io::read_session_content(*session);
  if (!content) return tl::unexpected(content.error());
  LoadedSession loaded;
  loaded.features = std::move(content->features);
  loaded.left_out = std::move(content->left_out);
  loaded.diagnostics = std::move(content->diagnostics);
  loaded.seconds_files = watch.lap();
  if (auto done = find_camera(*session, options, loaded); !done) {
    return tl::unexpected(done.error());
  }
  loaded.seconds_boards = watch.lap();
  if (session->features.empty()) {
    if (auto done = find_in_images(*session, options, loaded); !done) {
      return tl::unexpected(done.error());
    }
  }
  sort_positions(loaded);
  std::ranges::stable_sort(loaded.left_out, {}, &io::LeftOut::position);
  return loaded;
}

}  // namespace scanfuse::pipeline
