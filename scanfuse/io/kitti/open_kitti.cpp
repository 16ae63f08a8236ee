#include "scanfuse/io/kitti/open_kitti.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scanfuse/io/folder/scan_folder.hpp"
#include "scanfuse/io/kitti/kitti_ego.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kKittiPointBytes = 16;

std::int16_t hdl64_layer(const Return& r) {
  const double elevation_deg =
      degrees(std::atan2(static_cast<double>(r.z_m), std::sqrt(r.squared_range())));
  const double from_top =
      elevation_deg >= -8.83 + 0.25 ? (2 - elevation_deg) * 3 : 32 + (-8.83 - elevation_deg) * 2;
  return static_cast<std::int16_t>(63 - std::clamp(std::lround(from_top), 0L, 63L));
}

}  // namespace

Result<Scan> read_kitti_bin(std::string_view bytes, const std::string& name,
                            Diagnostics& diagnostics) {
  if (bytes.size() < kKittiPointBytes) {
    return fail(Error::Code::kMalformed, "{}: {} bytes hold no return of 16 bytes", name,
                bytes.size());
  }
  Scan scan;
  scan.returns.reserve(bytes.size() / kKittiPointBytes);
  std::int64_t not_finite = 0;
  for (std::size_t at = 0; at + kKittiPointBytes <= bytes.size(); at += kKittiPointBytes) {
    float values[4];
    std::memcpy(values, bytes.data() + at, sizeof values);
    const bool possible = std::all_of(std::begin(values), std::end(values), [](float v) {
      return std::abs(v) <= static_cast<float>(kFarthestCoordinate_m);
    });
    if (!possible) {
      ++not_finite;
      continue;
    }
    Return& r = scan.returns.emplace_back();
    r.x_m = values[0];
    r.y_m = values[1];
    r.z_m = values[2];
    r.intensity = values[3];
    r.layer = hdl64_layer(r);
  }
  if (scan.returns.empty()) {
    return fail(Error::Code::kMalformed, "{}: none of its {} returns is finite", name, not_finite);
  }
  if (not_finite > 0) diagnostics.damage("returns that are not finite dropped", name, not_finite);
  if (bytes.size() % kKittiPointBytes != 0) {
    diagnostics.damage(
        "cut off points",
        fmt::format("{}: byte {}", name, bytes.size() / kKittiPointBytes * kKittiPointBytes));
  }
  return scan;
}

std::filesystem::path kitti_scan_folder(const std::filesystem::path& path) {
  for (const auto* inner :
       {"", "velodyne_points/data", "velodyne_points", "velodyne/data", "velodyne", "data"}) {
    const auto folder = *inner == '\0' ? path : path / inner;
    if (!files_of(folder, ".bin").empty()) return folder;
  }
  return {};
}

Result<std::unique_ptr<RecordingReader>> open_kitti(const std::filesystem::path& path,
                                                    const OpenOptions& options) {
  ScanFolder folder;
  folder.path = path;
  folder.format = "kitti";
  folder.topic = "/velodyne";
  folder.type = "kitti velodyne";
  folder.frame_id = "velodyne";
  folder.pose_topic = "/oxts";
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    const auto scans = kitti_scan_folder(path);
    if (scans.empty()) return fail(Error::Code::kNotFound, "{}: no .bin file in it", path.string());
    folder.files = stamp_files(scans, files_of(scans, ".bin"), folder.diagnostics);
    folder.poses = read_kitti_poses(scans, folder.files, folder.diagnostics);
    if (!folder.poses.empty()) {
      const Time start = std::min(folder.files.front().stamp, folder.poses.front().stamp);
      folder.mounts = {
          {start, "imu", "velodyne", read_kitti_mount(scans, folder.diagnostics), true}};
    }
  } else {
    folder.files = stamp_files(path, {path}, folder.diagnostics);
  }
  folder.read = read_kitti_bin;
  return read_scan_folder(std::move(folder), options);
}

}  // namespace scanfuse::io
