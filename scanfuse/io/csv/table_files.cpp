#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"
#include "scanfuse/io/kitti/box_line.hpp"
#include "scanfuse/io/kitti/detections.hpp"
#include "scanfuse/io/kitti/labels.hpp"
#include "scanfuse/io/mcap/result_writer.hpp"

namespace scanfuse::io {
namespace {

template <class T>
Result<T> read_table_file(const std::filesystem::path& path, Diagnostics* diagnostics,
                          Result<T> (*read)(LineReader, Diagnostics&)) {
  auto lines = LineReader::open(path);
  if (!lines) return tl::unexpected(lines.error());
  Diagnostics unasked;
  return read(std::move(*lines), diagnostics != nullptr ? *diagnostics : unasked);
}

template <class Item>
Result<void> write_table_file(const std::filesystem::path& path, const std::string& header,
                              std::span<const Item> items, std::string (*rows)(const Item&)) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto wrote = file->write(header); !wrote) return wrote;
  for (const Item& item : items) {
    if (auto wrote = file->write(rows(item)); !wrote) return wrote;
  }
  return file->commit();
}

bool names_contain(const std::vector<std::string_view>& names,
                   std::initializer_list<std::string_view> wanted) {
  for (const std::string_view name : wanted) {
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
  }
  return true;
}

}  // namespace

TableKind table_kind_of_header(std::string_view header) {
  std::vector<std::string> scratch;
  std::vector<std::string_view> names;
  split_csv(header, scratch, names);
  const auto has = [&](auto... wanted) { return names_contain(names, {wanted...}); };
  if (has("track_id")) return TableKind::kTracks;
  if (has("measurement", "azimuth_rad")) return TableKind::kBearings;
  if (has("object_id")) return TableKind::kTruth;
  if (has("class", "x_m", "y_m")) return TableKind::kDetections;
  if (has("x_m", "y_m", "heading_rad") && !has("frame")) return TableKind::kEgo;
  if (has("x_m", "y_m") || has("x", "y")) return TableKind::kPoints;
  // Points and ego motion with a column missing: the reader names it.
  if (has("frame", "time_s") && (has("x_m") || has("y_m"))) return TableKind::kPoints;
  return TableKind::kNone;
}

TableKind table_kind(const std::filesystem::path& path) {
  Diagnostics ignored;
  auto lines = LineReader::open(path);
  if (!lines) return TableKind::kNone;
  const std::string_view first = lines->peek_content(ignored);
  if (trimmed(first).starts_with('{')) {
    return first.find("\"track_id\"") == first.npos ? TableKind::kNone : TableKind::kTracks;
  }
  const KittiLayout kitti = kitti_layout(first);
  if (kitti == KittiLayout::kTracking) return TableKind::kTruth;
  if (kitti != KittiLayout::kNone) return TableKind::kDetections;
  return table_kind_of_header(first);
}

std::string_view to_string(TableKind kind) {
  switch (kind) {
    case TableKind::kPoints:
      return "points";
    case TableKind::kDetections:
      return "detections";
    case TableKind::kTracks:
      return "tracks";
    case TableKind::kTruth:
      return "truth";
    case TableKind::kEgo:
      return "ego motion";
    case TableKind::kBearings:
      return "bearings";
    case TableKind::kNone:
      break;
  }
  return "no table";
}

Result<std::vector<StepResult>> read_tracks(const std::filesystem::path& path,
                                            Diagnostics* diagnostics) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  const auto start = read_start(**source, 8);
  if (start && start->starts_with("\x89MCAP")) return read_tracks_mcap(path, diagnostics);
  return read_table_file(path, diagnostics, &read_track_table);
}

Result<std::vector<TruthFrame>> read_truth(const std::filesystem::path& path,
                                           Diagnostics* diagnostics) {
  Diagnostics ignored;
  if (auto lines = LineReader::open(path);
      lines && kitti_layout(lines->peek_content(ignored)) == KittiLayout::kTracking) {
    return read_kitti_labels(path, diagnostics != nullptr ? *diagnostics : ignored);
  }
  return read_table_file(path, diagnostics, &read_truth_table);
}

Result<std::vector<PoseSample>> read_ego(const std::filesystem::path& path,
                                         Diagnostics* diagnostics) {
  return read_table_file(path, diagnostics, &read_ego_table);
}

Result<std::vector<DetectionFrame>> read_detections(const std::filesystem::path& path,
                                                    Diagnostics* diagnostics,
                                                    const KittiOptions& kitti) {
  Diagnostics unasked;
  if (holds_kitti_boxes(path)) {
    return read_kitti_detections(path, kitti, diagnostics != nullptr ? *diagnostics : unasked);
  }
  return read_table_file(path, diagnostics, &read_detection_table);
}

bool holds_detections(const std::filesystem::path& path) {
  return table_kind(path) == TableKind::kDetections || holds_kitti_boxes(path);
}

Result<void> write_detections(const std::filesystem::path& path,
                              std::span<const DetectionFrame> frames) {
  return write_table_file<DetectionFrame>(path, detection_header(), frames, &detection_rows);
}

Result<void> write_truth_csv(const std::filesystem::path& path,
                             std::span<const TruthFrame> frames) {
  return write_table_file<TruthFrame>(path, truth_header(), frames, &truth_rows);
}

Result<void> write_ego_csv(const std::filesystem::path& path, std::span<const PoseSample> poses) {
  return write_table_file<PoseSample>(path, ego_header(), poses, &ego_row);
}

}  // namespace scanfuse::io
