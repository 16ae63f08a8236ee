#include "scanfuse/io/kitti/kitti_ego.hpp"

#include <optional>

#include "scanfuse/io/kitti/oxts.hpp"
#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

using std::filesystem::path;

bool is_folder(const path& p) {
  std::error_code ignored;
  return std::filesystem::is_directory(p, ignored);
}

bool is_file(const path& p) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(p, ignored);
}

/// The scan folder and the two above it, nearest first.
std::vector<path> around(const path& scan_folder) {
  std::error_code ignored;
  const path whole = std::filesystem::absolute(scan_folder, ignored).lexically_normal();
  const path nearest = whole.has_filename() ? whole : whole.parent_path();
  return {nearest, nearest.parent_path(), nearest.parent_path().parent_path()};
}

/// Turns packets into samples; a line that cannot be read is damage.
class OxtsCollector {
 public:
  OxtsCollector(const std::vector<ScanFile>& scans, Diagnostics& diagnostics)
      : scans_(scans), diagnostics_(diagnostics) {}

  void take(std::string_view line, const std::string& where, std::optional<Time> stamp) {
    const std::size_t number = number_++;
    if (!stamp && number < scans_.size()) stamp = scans_[number].stamp;
    if (!stamp) {
      diagnostics_.note("oxts packets beyond the last scan dropped", where);
      return;
    }
    const auto packet = parse_oxts(line);
    if (!packet) {
      diagnostics_.damage("bad oxts packet skipped",
                          fmt::format("{}: {}", where, packet.error().message));
      return;
    }
    if (!poses_.empty() && *stamp < poses_.back().stamp) {
      diagnostics_.damage("oxts packet out of order skipped", where);
      return;
    }
    poses_.push_back({*stamp, "world", "imu", projection_.world_from_imu(*packet),
                      packet->forward_m_per_s, packet->yaw_rate_rad_per_s});
  }
  std::vector<PoseSample> finish() { return std::move(poses_); }

 private:
  const std::vector<ScanFile>& scans_;
  Diagnostics& diagnostics_;
  OxtsProjection projection_;
  std::vector<PoseSample> poses_;
  std::size_t number_ = 0;
};

/// One packet a file, beside a timestamps.txt.
void collect_oxts_folder(const path& folder, OxtsCollector& collector, Diagnostics& diagnostics) {
  auto stamps = read_stamps(folder / "timestamps.txt", diagnostics);
  if (stamps.empty()) stamps = read_stamps(folder.parent_path() / "timestamps.txt", diagnostics);
  std::size_t number = 0;
  for (const path& file : files_of(folder, ".txt")) {
    if (file.filename() == "timestamps.txt") continue;
    auto lines = LineReader::open(file);
    const auto stamp = number < stamps.size() ? stamps[number] : std::nullopt;
    ++number;
    const auto line = lines ? lines->next(diagnostics) : std::nullopt;
    collector.take(line.value_or(""), file.string(), stamp);
  }
}

void collect_oxts_file(const path& file, OxtsCollector& collector, Diagnostics& diagnostics) {
  auto lines = LineReader::open(file);
  if (!lines) return;
  while (const auto line = lines->next(diagnostics)) {
    if (!trimmed(*line).empty()) collector.take(*line, lines->where(), std::nullopt);
  }
}

/// The numbers behind `key` in a calibration file, where there are `wanted` of them.
std::optional<std::vector<double>> calibration_row(const path& file, std::string_view key,
                                                   std::size_t wanted) {
  Diagnostics ignored;
  auto lines = LineReader::open(file);
  if (!lines) return std::nullopt;
  while (const auto line = lines->next(ignored)) {
    std::string_view rest = trimmed(*line);
    if (!rest.starts_with(key)) continue;
    rest.remove_prefix(key.size());
    if (rest.starts_with(':')) rest.remove_prefix(1);
    if (!rest.starts_with(' ')) continue;
    std::vector<double> values;
    while (!(rest = trimmed(rest)).empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const auto number = parse_number(rest.substr(0, end));
      if (!number) return std::nullopt;
      values.push_back(*number);
      rest.remove_prefix(end);
    }
    if (values.size() == wanted) return values;
  }
  return std::nullopt;
}

/// Row-major 3 x 3 and a translation; nothing where the former is no rotation.
std::optional<Pose3> pose_from_rows(const std::vector<double>& r, const Eigen::Vector3d& t) {
  Eigen::Matrix3d rotation;
  rotation << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
  const bool orthonormal =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3;
  if (!orthonormal || !(rotation.determinant() > 0)) return std::nullopt;
  return Pose3{Eigen::Quaterniond(rotation).normalized(), t};
}

std::optional<Pose3> velodyne_from_imu_in(const path& folder, const path& scan_name) {
  const path raw = folder / "calib_imu_to_velo.txt";
  const auto r = calibration_row(raw, "R", 9), t = calibration_row(raw, "T", 3);
  if (r && t) return pose_from_rows(*r, {(*t)[0], (*t)[1], (*t)[2]});
  for (const path& file :
       {folder / "calib.txt", folder / "calib" / (scan_name.string() + ".txt")}) {
    const auto m = calibration_row(file, "Tr_imu_velo", 12);
    if (!m) continue;
    return pose_from_rows(
        {(*m)[0], (*m)[1], (*m)[2], (*m)[4], (*m)[5], (*m)[6], (*m)[8], (*m)[9], (*m)[10]},
        {(*m)[3], (*m)[7], (*m)[11]});
  }
  return std::nullopt;
}

}  // namespace

std::vector<PoseSample> read_kitti_poses(const path& scan_folder,
                                         const std::vector<ScanFile>& scans,
                                         Diagnostics& diagnostics) {
  OxtsCollector collector(scans, diagnostics);
  const auto folders = around(scan_folder);
  for (const path& folder : folders) {
    const path name = folders.front().filename();
    if (is_folder(folder / "oxts" / "data")) {
      collect_oxts_folder(folder / "oxts" / "data", collector, diagnostics);
      break;
    }
    const path in_sequence = folder / "oxts" / (name.string() + ".txt");
    if (is_file(in_sequence) || is_file(folder / "oxts.txt")) {
      collect_oxts_file(is_file(in_sequence) ? in_sequence : folder / "oxts.txt", collector,
                        diagnostics);
      break;
    }
    if (is_folder(folder / "oxts")) {
      collect_oxts_folder(folder / "oxts", collector, diagnostics);
      break;
    }
  }
  return collector.finish();
}

Pose3 read_kitti_mount(const path& scan_folder, Diagnostics& diagnostics) {
  const auto folders = around(scan_folder);
  for (const path& folder : folders) {
    if (const auto pose = velodyne_from_imu_in(folder, folders.front().filename())) {
      return pose->inverse();
    }
  }
  diagnostics.note("no calibration of lidar and imu: nominal mounting", scan_folder.string());
  return {Eigen::Quaterniond::Identity(), {0.81, -0.32, 0.80}};
}

}  // namespace scanfuse::io
