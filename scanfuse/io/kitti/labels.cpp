#include "scanfuse/io/kitti/labels.hpp"

#include <map>

#include "scanfuse/io/kitti/box_line.hpp"
#include "scanfuse/io/kitti/camera.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr double kFrame_s = 0.1;

TruthObject object_of(const KittiBox& box) {
  TruthObject object;
  object.id = box.track;
  object.object_class = box.object_class;
  object.position_m = box.centre_m.head<2>();
  object.z_m = box.centre_m.z();
  object.heading_rad = box.heading_rad;
  object.length_m = box.length_m;
  object.width_m = box.width_m;
  object.height_m = box.height_m;
  object.occluded = box.occluded;
  return object;
}

}  // namespace

Result<std::vector<TruthFrame>> read_kitti_labels(LineReader lines, const Pose3& laser_from_camera,
                                                  Diagnostics& diagnostics) {
  std::map<std::int64_t, TruthFrame> frames;
  while (const auto line = lines.next(diagnostics)) {
    if (trimmed(*line).empty()) continue;
    const auto label = parse_kitti_line(*line, KittiLayout::kTracking, laser_from_camera);
    if (!label || !label->box) diagnostics.damage("bad label line skipped", lines.where());
    if (!label) continue;
    TruthFrame& frame = frames[label->frame];
    frame.frame = label->frame;
    frame.stamp = time_from_seconds(kFrame_s * static_cast<double>(label->frame));
    frame.coordinate_frame = "ego";
    if (label->box && !label->box->dont_care) frame.objects.push_back(object_of(*label->box));
  }
  if (frames.empty()) {
    return fail(Error::Code::kMalformed, "{}: no KITTI label in it", lines.name());
  }
  std::vector<TruthFrame> in_order;
  in_order.reserve(frames.size());
  for (auto& [number, frame] : frames) in_order.push_back(std::move(frame));
  return in_order;
}

Result<std::vector<TruthFrame>> read_kitti_labels(const std::filesystem::path& path,
                                                  Diagnostics& diagnostics) {
  auto lines = LineReader::open(path);
  if (!lines) return tl::unexpected(lines.error());
  const auto camera = laser_from_camera_for(path, {}, diagnostics);
  if (!camera) return tl::unexpected(camera.error());
  return read_kitti_labels(std::move(*lines), *camera, diagnostics);
}

}  // namespace scanfuse::io
