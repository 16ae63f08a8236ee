#include "scanfuse/io/kitti/detections.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scanfuse/io/folder/stamps.hpp"
#include "scanfuse/io/kitti/box_line.hpp"
#include "scanfuse/io/kitti/camera.hpp"
#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLargestGap = 100;  // so that few lines cannot fill the memory

KittiLayout layout_of_file(const fs::path& path) {
  Diagnostics ignored;
  auto lines = LineReader::open(path);
  return lines ? kitti_layout(lines->peek_content(ignored)) : KittiLayout::kNone;
}

/// The files of a folder whose names are frame numbers.
std::map<std::int64_t, fs::path> numbered_files(const fs::path& folder) {
  std::map<std::int64_t, fs::path> numbered;
  for (const auto& file : files_of(folder, ".txt")) {
    const auto stem = file.stem().string();
    const bool digits = stem.find_first_not_of("0123456789") == stem.npos;
    if (const auto number = parse_whole(stem); digits && number && stem.size() < 9) {
      numbered.emplace(*number, file);
    }
  }
  return numbered;
}

bool is_folder_of_boxes(const fs::path& folder) {
  for (const auto& [number, file] : numbered_files(folder)) {
    std::error_code ignored;
    if (fs::file_size(file, ignored) == 0) continue;
    return layout_of_file(file) == KittiLayout::kObject;
  }
  return false;
}

Detection detection_of(const KittiBox& box) {
  Detection d;
  d.object_class = box.object_class;
  d.score = box.score.value_or(1);
  d.box = {box.centre_m.head<2>(), box.heading_rad, box.length_m, box.width_m};
  d.z_m = box.centre_m.z();
  d.height_m = box.height_m;
  d.covariance = Eigen::Vector3d(0.09, 0.09, 0.04).asDiagonal();
  d.var_length_m2 = 0.25;
  d.var_width_m2 = 0.04;
  d.length_seen = d.width_seen = true;
  d.visible_middle_m = d.box.centre_m;
  return d;
}

/// Boxes by frame while files are read.
class Collector {
 public:
  Collector(const Pose3& laser_from_camera, Diagnostics& diagnostics)
      : laser_from_camera_(laser_from_camera), diagnostics_(diagnostics) {}

  /// `number`: of a file that is one frame.
  void read(LineReader lines, KittiLayout layout, std::optional<std::int64_t> number) {
    if (number) frames_[*number];
    while (const auto line = lines.next(diagnostics_)) {
      if (trimmed(*line).empty()) continue;
      const auto parsed = parse_kitti_line(*line, layout, laser_from_camera_);
      const bool sized =
          parsed && parsed->box &&
          (parsed->box->dont_care || (parsed->box->length_m >= 0 && parsed->box->width_m >= 0));
      if (!sized) {
        diagnostics_.damage("bad detection line skipped", lines.where());
        if (first_bad_.empty()) first_bad_ = lines.where();
        continue;
      }
      auto& frame = frames_[number.value_or(parsed->frame)];
      good_ = true;
      if (parsed->box->dont_care) continue;
      frame.push_back(detection_of(*parsed->box));
      scored_ = scored_ || parsed->box->score.has_value();
      named_ = named_ || parsed->box->track >= 0;
    }
  }

  [[nodiscard]] Result<std::vector<DetectionFrame>> finish(const fs::path& path,
                                                           double frame_rate_hz) {
    if (!good_ && (!first_bad_.empty() || frames_.empty())) {
      return fail(Error::Code::kMalformed, "{}: no KITTI detection in it",
                  first_bad_.empty() ? path.string() : first_bad_);
    }
    tell_scores(path);
    std::vector<DetectionFrame> all;
    for (auto& [number, detections] : frames_) {
      fill_gap(all, number, frame_rate_hz);
      all.push_back(frame_at(number, frame_rate_hz));
      all.back().detections = std::move(detections);
    }
    return all;
  }

 private:
  static DetectionFrame frame_at(std::int64_t number, double frame_rate_hz) {
    return {time_from_seconds(static_cast<double>(number) / frame_rate_hz), number, "kitti", {}};
  }

  void fill_gap(std::vector<DetectionFrame>& all, std::int64_t until, double frame_rate_hz) {
    if (all.empty() || until - all.back().frame <= 1) return;
    if (until - all.back().frame > kLargestGap) {
      diagnostics_.note("more than 100 frames without a detection left out",
                        fmt::format("before frame {}", until));
      return;
    }
    while (all.back().frame + 1 < until) {
      all.push_back(frame_at(all.back().frame + 1, frame_rate_hz));
    }
  }

  void tell_scores(const fs::path& path) {
    if (!scored_) diagnostics_.note("boxes without a score: 1 taken", path.string());
    if (named_) {
      diagnostics_.note("identities of the labels are not used as detections", path.string());
    }
    bool outside = false;
    for (const auto& [number, detections] : frames_) {
      outside = outside || std::ranges::any_of(detections, [](const Detection& d) {
                  return d.score < 0 || d.score > 1;
                });
    }
    if (!outside) return;
    diagnostics_.note("scores outside 0 .. 1: taken as log odds", path.string());
    for (auto& [number, detections] : frames_) {
      for (auto& d : detections) d.score = 1 / (1 + std::exp(-d.score));
    }
  }

  Pose3 laser_from_camera_;
  Diagnostics& diagnostics_;
  std::map<std::int64_t, std::vector<Detection>> frames_;
  std::string first_bad_;
  bool good_ = false;
  bool scored_ = false;
  bool named_ = false;
};

}  // namespace

bool holds_kitti_boxes(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return is_folder_of_boxes(path);
  return layout_of_file(path) != KittiLayout::kNone;
}

Result<std::vector<DetectionFrame>> read_kitti_detections(const fs::path& path,
                                                          const KittiOptions& options,
                                                          Diagnostics& diagnostics) {
  const auto camera = laser_from_camera_for(path, options.calibration, diagnostics);
  if (!camera) return tl::unexpected(camera.error());
  Collector collector(*camera, diagnostics);
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) {
    auto lines = LineReader::open(path);
    if (!lines) return tl::unexpected(lines.error());
    collector.read(std::move(*lines), layout_of_file(path), std::nullopt);
    return collector.finish(path, options.frame_rate_hz);
  }
  for (const auto& [number, file] : numbered_files(path)) {
    auto lines = LineReader::open(file);
    if (!lines) return tl::unexpected(lines.error());
    collector.read(std::move(*lines), KittiLayout::kObject, number);
  }
  return collector.finish(path, options.frame_rate_hz);
}

}  // namespace scanfuse::io
