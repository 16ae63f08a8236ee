#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/ego.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

/// Tables in text: tracks, truth, ego motion, detections. All are CSV whose columns are found by
/// name (tracks and detections also JSON lines), packed with gzip or xz if need be. Rows that
/// cannot be read are skipped and counted as damage in `diagnostics`; a table without a good row
/// and a missing column are errors. SI units and radians.
namespace scanfuse::io {

enum class TableKind { kNone, kPoints, kDetections, kTracks, kTruth, kEgo, kBearings };

/// What a file's header says that it holds; kNone for anything that is no such table.
[[nodiscard]] TableKind table_kind(const std::filesystem::path& path);
[[nodiscard]] std::string_view to_string(TableKind kind);

/// Tracks as `open_result_writer` writes them (.csv, .jsonl or .mcap). Needs `frame`, `time_s`,
/// `track_id`, `x_m`, `y_m`; without `status` a row counts as confirmed. One step per frame and
/// time, ascending; scans without tracks have no step.
[[nodiscard]] Result<std::vector<StepResult>> read_tracks(const std::filesystem::path& path,
                                                          Diagnostics* diagnostics = nullptr);

/// `frame,time_s,object_id,class,x_m,y_m[,z_m,heading_rad,vx_m_per_s,vy_m_per_s,length_m,width_m,`
/// `height_m,visible_points,occluded]`; one TruthFrame per frame, ascending. Or KITTI's tracking
/// labels (kitti/labels.hpp), which stand in the ego frame.
[[nodiscard]] Result<std::vector<TruthFrame>> read_truth(const std::filesystem::path& path,
                                                         Diagnostics* diagnostics = nullptr);

/// `time_s,x_m,y_m,heading_rad[,z_m,speed_m_per_s,yaw_rate_rad_per_s]`: the ego vehicle in the
/// world, ascending in time.
[[nodiscard]] Result<std::vector<PoseSample>> read_ego(const std::filesystem::path& path,
                                                       Diagnostics* diagnostics = nullptr);

/// The detections of one scan.
struct DetectionFrame {
  Time stamp;
  std::int64_t frame = 0;
  std::string sensor;
  std::vector<Detection> detections;
};

/// What files of KITTI boxes leave open.
struct KittiOptions {
  std::filesystem::path calibration;  ///< empty: looked for beside the boxes
  double frame_rate_hz = 10;          ///< 0.1 to 10 000
};

/// `frame,time_s,class,x_m,y_m[,score,z_m,heading_rad,length_m,width_m,height_m,...]` with the
/// further columns that `write_detections` writes. A row with neither `x_m` nor `y_m` says that
/// nothing was seen in its frame. Without variances: 0.3 m in x and y, 0.2 rad in heading
/// (1.8 rad, that is none, without `heading_rad`). Or KITTI boxes (kitti/detections.hpp), a file or
/// a folder with a file a frame, in the laser's frame.
[[nodiscard]] Result<std::vector<DetectionFrame>> read_detections(
    const std::filesystem::path& path, Diagnostics* diagnostics = nullptr,
    const KittiOptions& kitti = {});

/// Whether `read_detections` knows what the path holds.
[[nodiscard]] bool holds_detections(const std::filesystem::path& path);

/// One detection frame as CSV rows; the header first. For writers that add a frame at a time.
[[nodiscard]] std::string detection_header();
[[nodiscard]] std::string detection_rows(const DetectionFrame& frame);

/// Whole files, written under another name first and then moved into place.
[[nodiscard]] Result<void> write_detections(const std::filesystem::path& path,
                                            std::span<const DetectionFrame> frames);
[[nodiscard]] Result<void> write_truth_csv(const std::filesystem::path& path,
                                           std::span<const TruthFrame> frames);
[[nodiscard]] Result<void> write_ego_csv(const std::filesystem::path& path,
                                         std::span<const PoseSample> poses);

}  // namespace scanfuse::io
