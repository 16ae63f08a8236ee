#include "scanfuse/io/session/features_json.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/io/document/document.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

using Points = std::vector<Eigen::Vector2d>;
constexpr double kFarthestPixel = 1e6;

/// Two lists of image points, one for each board.
Result<std::array<Points, 2>> read_point_lists(const DocumentTable& table, std::string_view key) {
  const auto wrong = [&] {
    return table.wrong(key, fmt::format("{} needs two lists of points [u, v]", key));
  };
  const DocumentNode* node = table.find(key);
  const auto* lists = node != nullptr ? node->array() : nullptr;
  if (lists == nullptr || lists->size() != 2) return wrong();
  std::array<Points, 2> points;
  for (std::size_t b = 0; b < 2; ++b) {
    const auto* list = (*lists)[b].array();
    if (list == nullptr) return wrong();
    points[b].reserve(list->size());
    for (const DocumentNode& item : *list) {
      const auto* pair = item.array();
      if (pair == nullptr || pair->size() != 2) return wrong();
      const double *u = (*pair)[0].number(), *v = (*pair)[1].number();
      if (u == nullptr || v == nullptr) return wrong();
      if (std::max(std::abs(*u), std::abs(*v)) > kFarthestPixel) return wrong();
      points[b].emplace_back(*u, *v);
    }
  }
  return points;
}

Result<std::vector<BeamReturn>> read_beams(const DocumentTable& table) {
  if (auto known = table.only({"angle_rad", "range_m", "intensity"}); !known) {
    return tl::unexpected(known.error());
  }
  const auto angles = table.numbers("angle_rad");
  if (!angles) return tl::unexpected(angles.error());
  const auto ranges = table.numbers("range_m", 0, true);
  if (!ranges) return tl::unexpected(ranges.error());
  std::vector<double> intensities(angles->size(), std::nan(""));
  if (table.has("intensity")) {
    auto read = table.numbers("intensity", 0, true);
    if (!read) return tl::unexpected(read.error());
    intensities = std::move(*read);
  }
  if (ranges->size() != angles->size() || intensities.size() != angles->size()) {
    return table.wrong("range_m", fmt::format("{} angles, {} ranges, {} intensities",
                                              angles->size(), ranges->size(), intensities.size()));
  }
  std::vector<BeamReturn> scan;
  scan.reserve(angles->size());
  for (std::size_t k = 0; k < angles->size(); ++k) {
    if (std::abs((*angles)[k]) > 4 * kPi) {
      return table.wrong("angle_rad", "an angle is more than two turns; write radians");
    }
    const double range = (*ranges)[k];
    const bool valid = range > 0 && range < kFarthestCoordinate_m;
    scan.push_back({(*angles)[k], valid ? range : std::nan(""), intensities[k]});
  }
  std::ranges::stable_sort(scan, {}, &BeamReturn::angle_rad);
  return scan;
}

Result<void> read_position(const DocumentTable& table, TurntablePosition& position) {
  if (auto known = table.only({"name", "stripe_px", "scan"}); !known) return known;
  auto stripes = read_point_lists(table, "stripe_px");
  if (!stripes) return tl::unexpected(stripes.error());
  position.stripe_px = std::move(*stripes);
  const auto scan = table.table("scan");
  if (!scan) return tl::unexpected(scan.error());
  if (!*scan) return {};
  auto beams = read_beams(**scan);
  if (!beams) return tl::unexpected(beams.error());
  position.scan = std::move(*beams);
  return {};
}

Result<void> read_corners(const DocumentTable& root, TurntableFeatures& features) {
  auto corners = read_point_lists(root, "corners_px");
  if (!corners) return tl::unexpected(corners.error());
  for (std::size_t b = 0; b < 2; ++b) {
    const BoardSpec& board = features.boards[b];
    const auto wanted = static_cast<std::size_t>(board.rows * board.columns);
    if ((*corners)[b].size() == wanted) continue;
    return root.wrong("corners_px",
                      fmt::format("{} corners on board {}; session.toml says {} rows of {}",
                                  (*corners)[b].size(), b, board.rows, board.columns));
  }
  features.corners_px = std::move(*corners);
  return {};
}

std::string points_text(const Points& points) {
  std::string text = "[";
  for (const auto& p : points) {
    text += fmt::format("{}[{},{}]", text.size() > 1 ? "," : "", print_number(p.x()),
                        print_number(p.y()));
  }
  return text + "]";
}

std::string scan_text(const std::vector<BeamReturn>& scan) {
  const auto list = [&](double BeamReturn::* member) {
    std::string text = "[";
    for (const BeamReturn& beam : scan) {
      const double value = beam.*member;
      if (text.size() > 1) text += ",";
      text += std::isfinite(value) ? print_number(value) : "null";
    }
    return text + "]";
  };
  const bool intensity =
      std::ranges::any_of(scan, [](const auto& beam) { return std::isfinite(beam.intensity); });
  return fmt::format(R"({{"angle_rad":{},"range_m":{}{}}})", list(&BeamReturn::angle_rad),
                     list(&BeamReturn::range_m),
                     intensity ? R"(,"intensity":)" + list(&BeamReturn::intensity) : "");
}

}  // namespace

Result<void> parse_features(std::string_view text, const std::string& name,
                            TurntableFeatures& features) {
  const auto document = parse_json_document(text, name);
  if (!document) return tl::unexpected(document.error());
  const auto root = DocumentTable::root(*document, name);
  if (!root) return tl::unexpected(root.error());
  if (auto known = root->only({"corners_px", "positions"}); !known) return known;
  if (auto read = read_corners(*root, features); !read) return read;
  const auto positions = root->tables("positions");
  if (!positions) return tl::unexpected(positions.error());
  if (positions->size() != features.positions.size()) {
    return root->wrong("positions", fmt::format("{} positions; session.toml gives {} angles",
                                                positions->size(), features.positions.size()));
  }
  for (std::size_t k = 0; k < positions->size(); ++k) {
    if (auto read = read_position((*positions)[k], features.positions[k]); !read) return read;
  }
  return {};
}

std::string features_text(const TurntableFeatures& features) {
  std::string text =
      fmt::format("{{\"corners_px\":[{},\n{}],\n\"positions\":[",
                  points_text(features.corners_px[0]), points_text(features.corners_px[1]));
  bool first = true;
  for (const TurntablePosition& position : features.positions) {
    text += fmt::format("{}\n{{\"stripe_px\":[{},{}]", std::exchange(first, false) ? "" : ",",
                        points_text(position.stripe_px[0]), points_text(position.stripe_px[1]));
    if (!position.scan.empty()) text += ",\"scan\":" + scan_text(position.scan);
    text += "}";
  }
  return text + "\n]}\n";
}

}  // namespace scanfuse::io
