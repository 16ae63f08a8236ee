#include "scanfuse/io/session/session_folder.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "scanfuse/io/document/document.hpp"
#include "scanfuse/io/session/features_json.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/io/text/natural_order.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestFeatures = std::size_t{1} << 29;

bool is_image(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

Result<std::vector<fs::path>> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored)) files.push_back(it->path());
  }
  if (error) {
    return fail(Error::Code::kNotFound, "{}: cannot be listed: {}", folder.string(),
                error.message());
  }
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return files;
}

/// The number in "stripe_0007" or "stripe_0007_off"; nothing for other names.
std::optional<std::size_t> number_in(std::string_view stem, std::string_view prefix,
                                     std::string_view suffix) {
  if (!stem.starts_with(prefix) || !stem.ends_with(suffix)) return std::nullopt;
  if (stem.size() <= prefix.size() + suffix.size()) return std::nullopt;
  stem = stem.substr(prefix.size(), stem.size() - prefix.size() - suffix.size());
  if (stem.size() > 9 || stem.find_first_not_of("0123456789") != stem.npos) return std::nullopt;
  const auto number = parse_whole(stem);
  if (!number) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

Result<void> take_file(SessionFolder& session, std::size_t number, fs::path SessionPosition::* kind,
                       const fs::path& file) {
  if (number >= session.positions.size()) {
    return fail(Error::Code::kOutOfRange,
                "{}: has no angle: session.toml gives {} ([turntable]; files count from 0)",
                file.string(), session.positions.size());
  }
  fs::path& place = session.positions[number].*kind;
  if (!place.empty()) {
    return fail(Error::Code::kMalformed, "{}: {} is of the same position; remove one",
                file.string(), place.filename().string());
  }
  place = file;
  return {};
}

Result<void> sort_files(SessionFolder& session, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    Result<void> taken;
    if (is_image(file) && stem.starts_with("board")) {
      session.board_images.push_back(file);
    } else if (const auto off = number_in(stem, "stripe_", "_off"); off && is_image(file)) {
      taken = take_file(session, *off, &SessionPosition::stripe_off, file);
    } else if (const auto on = number_in(stem, "stripe_", ""); on && is_image(file)) {
      taken = take_file(session, *on, &SessionPosition::stripe, file);
    } else if (const auto scan = number_in(stem, "scan_", ""); scan && file.extension() == ".csv") {
      taken = take_file(session, *scan, &SessionPosition::scan, file);
    } else if (file.filename() == "features.json") {
      session.features = file;
    }
    if (!taken) return taken;
  }
  return {};
}

/// Whether one scan's error is everybody's: a unit that was declared wrong.
bool concerns_all(const Error& error) { return error.code == Error::Code::kOutOfRange; }

Result<void> read_scans(const SessionFolder& session, SessionContent& content) {
  auto& positions = content.features.positions;
  std::map<int, std::vector<BeamReturn>> recorded;
  if (!session.about.lidar.recording.empty()) {
    auto scans = read_scan_recording(session.folder / session.about.lidar.recording,
                                     session.about.lidar, content.diagnostics);
    if (!scans) return tl::unexpected(scans.error());
    if (static_cast<std::size_t>(scans->rbegin()->first) >= positions.size()) {
      return fail(Error::Code::kOutOfRange, "{}: holds a scan {}; session.toml gives {} angles",
                  session.about.lidar.recording, scans->rbegin()->first, positions.size());
    }
    recorded = std::move(*scans);
  }
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (!positions[k].scan.empty()) continue;  // features.json brought it
    if (const auto found = recorded.find(static_cast<int>(k)); found != recorded.end()) {
      positions[k].scan = std::move(found->second);
      continue;
    }
    const fs::path& file = session.positions[k].scan;
    if (file.empty()) {
      content.left_out.push_back({k, numbered_name("scan", k, ".csv") + " is missing"});
      continue;
    }
    auto scan = read_scan_table(file, session.about.lidar, content.diagnostics);
    if (scan) {
      positions[k].scan = std::move(*scan);
    } else if (concerns_all(scan.error())) {
      return tl::unexpected(scan.error());
    } else {
      content.left_out.push_back({k, scan.error().message});
    }
  }
  return {};
}

Result<std::vector<fs::path>> camera_images_of(const SessionFolder& session) {
  if (!session.about.camera_images) return std::vector<fs::path>{};
  return list_images(session.folder / session.about.camera_images->folder);
}

}  // namespace

std::string numbered_name(std::string_view stem, std::size_t position, std::string_view ending) {
  return fmt::format("{}_{:04}{}", stem, position, ending);
}

Result<std::vector<fs::path>> list_images(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return std::vector{path};
  auto files = files_in(path);
  if (!files) return files;
  std::erase_if(*files, [](const fs::path& file) { return !is_image(file); });
  if (!files->empty()) return files;
  return fail(Error::Code::kNotFound, "{}: no .png or .jpg in it", path.string());
}

Result<SessionFolder> open_session(const fs::path& folder) {
  SessionFolder session;
  session.folder = folder;
  std::error_code ignored;
  if (!fs::is_regular_file(folder / "session.toml", ignored)) {
    return fail(Error::Code::kNotFound,
                "{}: no session.toml in it; docs/turntable-session.md says what a session holds",
                folder.string());
  }
  auto about = read_session_file(folder / "session.toml");
  if (!about) return tl::unexpected(about.error());
  session.about = std::move(*about);
  if (session.about.turntable_rad.empty()) {
    return fail(Error::Code::kMalformed,
                "{}: no angles: give [turntable] angles_deg, or first_deg, step_deg and positions",
                (folder / "session.toml").string());
  }
  for (std::size_t k = 0; k < session.about.turntable_rad.size(); ++k) {
    session.positions.push_back(
        {fmt::format("position {}", k), session.about.turntable_rad[k], {}, {}, {}});
  }
  const auto files = files_in(folder);
  if (!files) return tl::unexpected(files.error());
  if (auto done = sort_files(session, *files); !done) return tl::unexpected(done.error());
  auto images = camera_images_of(session);
  if (!images) return tl::unexpected(images.error());
  session.camera_images = std::move(*images);
  return session;
}

Result<SessionContent> read_session_content(const SessionFolder& session) {
  SessionContent content;
  if (session.about.camera) content.features.camera = *session.about.camera;
  for (std::size_t b = 0; b < session.about.boards.size(); ++b) {
    content.features.boards[b] = session.about.boards[b].spec;
  }
  for (const SessionPosition& position : session.positions) {
    TurntablePosition made;
    made.name = position.name;
    made.turntable_rad = position.turntable_rad;
    content.features.positions.push_back(std::move(made));
  }
  if (!session.features.empty() && !session.about.boards.empty()) {
    const auto text = read_document_text(session.features, kLargestFeatures, "features.json");
    if (!text) return tl::unexpected(text.error());
    auto read = parse_features(*text, session.features.string(), content.features);
    if (!read) return tl::unexpected(read.error());
  }
  if (auto read = read_scans(session, content); !read) return tl::unexpected(read.error());
  return content;
}

}  // namespace scanfuse::io
