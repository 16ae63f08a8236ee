#include "scanfuse/io/session/session_file.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "scanfuse/io/session/camera_table.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLargestSession = std::size_t{1} << 20;
constexpr int kMostPositions = 100000;

constexpr std::array<std::pair<const char*, double>, 2> kAngleUnits{
    {{"deg", kPi / 180}, {"rad", 1.0}}};
constexpr std::array<std::pair<const char*, double>, 4> kRangeUnits{
    {{"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"0.1mm", 1e-4}}};

/// Hands a value on or ends the surrounding function with its error.
template <class T>
Result<void> put(T& place, Result<T> value) {
  if (!value) return tl::unexpected(std::move(value.error()));
  place = std::move(*value);
  return {};
}

template <std::size_t N>
Result<void> read_unit(const DocumentTable& table, const char* key, double& unit,
                       const std::array<std::pair<const char*, double>, N>& known) {
  std::vector<std::string> names;
  std::string current;
  for (const auto& [name, value] : known) {
    names.emplace_back(name);
    if (value == unit) current = name;
  }
  const auto chosen = table.choice_or(key, current, names);
  if (!chosen) return tl::unexpected(chosen.error());
  for (const auto& [name, value] : known) {
    if (*chosen == name) unit = value;
  }
  return {};
}

Result<BoardSpec> read_board_spec(const DocumentTable& table) {
  BoardSpec spec;
  if (auto r = put(spec.rows, table.whole("rows", 2, 1000)); !r) return tl::unexpected(r.error());
  if (auto r = put(spec.columns, table.whole("columns", 2, 1000)); !r) {
    return tl::unexpected(r.error());
  }
  if (table.has("square_mm") == table.has("square_m")) {
    return table.wrong("square_mm", "give the side of a square as square_m or as square_mm");
  }
  const bool millimetres = table.has("square_mm");
  const auto side =
      millimetres ? table.number("square_mm", 0.01, 1e5) : table.number("square_m", 1e-5, 100);
  if (!side) return tl::unexpected(side.error());
  spec.square_m = millimetres ? *side * 1e-3 : *side;
  return spec;
}

Result<void> read_camera_part(const DocumentTable& table, SessionFile& session) {
  if (!table.has("images")) {
    if (auto known = table.only(camera_keys()); !known) return known;
    const auto camera = read_camera(table);
    if (!camera) return tl::unexpected(camera.error());
    session.camera = *camera;
    return {};
  }
  if (table.has("fx_px")) {
    return table.wrong("images", "give the intrinsics or images to calibrate them from, not both");
  }
  if (auto known = table.only({"images", "rows", "columns", "square_m", "square_mm"}); !known) {
    return known;
  }
  CameraImages images;
  if (auto r = put(images.folder, table.text_or("images", "")); !r) return r;
  if (auto r = put(images.board, read_board_spec(table)); !r) return r;
  session.camera_images = images;
  return {};
}

Result<void> read_turntable(const DocumentTable& table, SessionFile& session) {
  if (auto known = table.only({"angles_deg", "first_deg", "step_deg", "positions"}); !known) {
    return known;
  }
  if (table.has("angles_deg")) {
    if (table.has("first_deg") || table.has("step_deg") || table.has("positions")) {
      return table.wrong("angles_deg", "give angles_deg or first_deg, step_deg and positions");
    }
    auto angles = table.numbers("angles_deg");
    if (!angles) return tl::unexpected(angles.error());
    for (double& angle : *angles) {
      if (!(std::abs(angle) <= 36000)) {
        return table.wrong("angles_deg", "angles need numbers from -36000 to 36000");
      }
      session.turntable_rad.push_back(radians(angle));
    }
    return {};
  }
  const auto first = table.number_or("first_deg", 0, -36000, 36000);
  if (!first) return tl::unexpected(first.error());
  const auto step = table.number("step_deg", -360, 360);
  if (!step) return tl::unexpected(step.error());
  const auto positions = table.whole("positions", 1, kMostPositions);
  if (!positions) return tl::unexpected(positions.error());
  for (int k = 0; k < *positions; ++k) session.turntable_rad.push_back(radians(*first + k * *step));
  return {};
}

Result<void> read_lidar(const DocumentTable& table, LidarConventions& lidar) {
  if (auto known = table.only({"angle_unit", "range_unit", "direction", "zero_deg",
                               "invalid_ranges", "min_range_m", "max_range_m", "recording"});
      !known) {
    return known;
  }
  if (auto r = read_unit(table, "angle_unit", lidar.angle_unit_rad, kAngleUnits); !r) return r;
  if (auto r = read_unit(table, "range_unit", lidar.range_unit_m, kRangeUnits); !r) return r;
  const auto direction =
      table.choice_or("direction", "counterclockwise", {"counterclockwise", "clockwise"});
  if (!direction) return tl::unexpected(direction.error());
  lidar.clockwise = *direction == "clockwise";
  const auto zero = table.number_or("zero_deg", 0, -360, 360);
  if (!zero) return tl::unexpected(zero.error());
  lidar.zero_rad = radians(*zero);
  if (table.has("invalid_ranges")) {
    if (auto r = put(lidar.invalid_ranges, table.numbers("invalid_ranges")); !r) return r;
  }
  if (auto r = put(lidar.min_range_m, table.number_or("min_range_m", 0.01, 0, 1e5)); !r) return r;
  if (auto r = put(lidar.max_range_m, table.number_or("max_range_m", 100, 1e-3, 1e6)); !r) return r;
  if (lidar.min_range_m >= lidar.max_range_m) {
    return table.wrong("max_range_m", "max_range_m must be above min_range_m");
  }
  return put(lidar.recording, table.text_or("recording", ""));
}

Result<void> read_boards(const DocumentTable& root, SessionFile& session) {
  const auto tables = root.tables("board");
  if (!tables) return tl::unexpected(tables.error());
  if (!tables->empty() && tables->size() != 2) {
    return root.wrong("board", fmt::format("{} [[board]]; a V has two", tables->size()));
  }
  for (const DocumentTable& table : *tables) {
    if (auto known = table.only({"rows", "columns", "square_m", "square_mm", "image"}); !known) {
      return known;
    }
    SessionBoard board;
    if (auto r = put(board.spec, read_board_spec(table)); !r) return r;
    if (auto r = put(board.image, table.text_or("image", "")); !r) return r;
    session.boards.push_back(std::move(board));
  }
  return {};
}

Result<SessionFile> read_session_root(const DocumentTable& root) {
  if (auto known = root.only({"camera", "board", "turntable", "lidar"}); !known) {
    return tl::unexpected(known.error());
  }
  SessionFile session;
  const auto part = [&](const char* key, const auto& read) -> Result<void> {
    const auto table = root.table(key);
    if (!table) return tl::unexpected(table.error());
    if (!*table) return {};
    return read(**table);
  };
  for (const auto& done :
       {part("camera", [&](const auto& table) { return read_camera_part(table, session); }),
        part("turntable", [&](const auto& table) { return read_turntable(table, session); }),
        part("lidar", [&](const auto& table) { return read_lidar(table, session.lidar); }),
        read_boards(root, session)}) {
    if (!done) return tl::unexpected(done.error());
  }
  return session;
}

template <std::size_t N>
std::string unit_name(double unit, const std::array<std::pair<const char*, double>, N>& known) {
  for (const auto& [name, value] : known) {
    if (value == unit) return name;
  }
  return known.front().first;
}

std::string board_spec_text(const BoardSpec& spec) {
  return fmt::format("rows = {}\ncolumns = {}\nsquare_m = {}\n", spec.rows, spec.columns,
                     print_number(spec.square_m));
}

std::string lidar_text(const LidarConventions& lidar) {
  std::vector<std::string> codes;
  for (const double code : lidar.invalid_ranges) codes.push_back(print_number(code));
  std::string text = fmt::format(
      "[lidar]\nangle_unit = \"{}\"\nrange_unit = \"{}\"\ndirection = \"{}\"\n"
      "zero_deg = {}\ninvalid_ranges = [{}]\nmin_range_m = {}\nmax_range_m = {}\n",
      unit_name(lidar.angle_unit_rad, kAngleUnits), unit_name(lidar.range_unit_m, kRangeUnits),
      lidar.clockwise ? "clockwise" : "counterclockwise", print_number(degrees(lidar.zero_rad)),
      fmt::join(codes, ", "), print_number(lidar.min_range_m), print_number(lidar.max_range_m));
  if (!lidar.recording.empty()) text += fmt::format("recording = \"{}\"\n", lidar.recording);
  return text;
}

}  // namespace

Result<SessionFile> parse_session_file(std::string_view text, const std::string& name) {
  const auto document = parse_toml_document(text, name);
  if (!document) return tl::unexpected(document.error());
  const auto root = DocumentTable::root(*document, name);
  if (!root) return tl::unexpected(root.error());
  return read_session_root(*root);
}

Result<SessionFile> read_session_file(const std::filesystem::path& path) {
  const auto text = read_document_text(path, kLargestSession, "session.toml");
  if (!text) return tl::unexpected(text.error());
  return parse_session_file(*text, path.string());
}

std::string session_file_text(const SessionFile& session) {
  std::string text;
  if (session.camera) text += "[camera]\n" + camera_text(*session.camera) + "\n";
  if (session.camera_images) {
    text += fmt::format("[camera]\nimages = \"{}\"\n{}\n", session.camera_images->folder,
                        board_spec_text(session.camera_images->board));
  }
  for (const SessionBoard& board : session.boards) {
    text += "[[board]]\n" + board_spec_text(board.spec);
    if (!board.image.empty()) text += fmt::format("image = \"{}\"\n", board.image);
    text += "\n";
  }
  if (!session.turntable_rad.empty()) {
    std::vector<std::string> angles;
    for (const double angle : session.turntable_rad) {
      // Nine digits after the point: 0.25 degrees is to be written as it was meant.
      angles.push_back(print_number(std::round(degrees(angle) * 1e9) / 1e9));
    }
    text += fmt::format("[turntable]\nangles_deg = [{}]\n\n", fmt::join(angles, ", "));
  }
  return text + lidar_text(session.lidar);
}

}  // namespace scanfuse::io
