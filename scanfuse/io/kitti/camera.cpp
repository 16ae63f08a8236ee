#include "scanfuse/io/kitti/camera.hpp"

#include <Eigen/LU>
#include <array>
#include <vector>

#include "scanfuse/io/kitti/box_line.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

/// The camera's axes (x right, y down, z forward) in the laser's.
Pose3 usual_laser_from_camera() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(axes), Eigen::Vector3d(0.27, 0, -0.08)};
}

/// The numbers behind `name` or `name:` in a calibration line.
std::optional<std::vector<double>> numbers_after(std::string_view line, std::string_view name) {
  const auto words = kitti_words(line);
  if (words.empty()) return std::nullopt;
  std::string_view first = words[0];
  if (first.ends_with(':')) first.remove_suffix(1);
  if (first != name) return std::nullopt;
  std::vector<double> numbers;
  numbers.reserve(words.size() - 1);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Pose3> calibration_beside(const std::filesystem::path& path,
                                        Diagnostics& diagnostics) {
  const auto folder = path.parent_path();
  const auto name = path.filename().string();
  for (const auto& candidate :
       {folder / "calib.txt", folder / ("calib_" + name), folder / ".." / "calib" / name}) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(candidate, ignored)) continue;
    auto lines = LineReader::open(candidate);
    if (!lines) continue;
    if (auto found = laser_from_camera(std::move(*lines), diagnostics)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Pose3> laser_from_camera(LineReader calibration, Diagnostics& diagnostics) {
  std::optional<Eigen::Matrix3d> rectify;
  std::optional<Eigen::Matrix<double, 3, 4>> camera_from_laser;
  while (const auto line = calibration.next(diagnostics)) {
    for (const char* name : {"R_rect", "R0_rect"}) {
      const auto r = numbers_after(*line, name);
      if (r && r->size() == 9) rectify = Eigen::Map<const Eigen::Matrix3d>(r->data()).transpose();
    }
    for (const char* name : {"Tr_velo_cam", "Tr_velo_to_cam"}) {
      const auto t = numbers_after(*line, name);
      if (t && t->size() == 12) {
        camera_from_laser = Eigen::Map<const Eigen::Matrix<double, 4, 3>>(t->data()).transpose();
      }
    }
  }
  if (!rectify || !camera_from_laser) return std::nullopt;
  const Eigen::Matrix3d rotation = *rectify * camera_from_laser->leftCols<3>();
  if (!(std::abs(rotation.determinant() - 1) < 0.01)) return std::nullopt;
  const Pose3 camera{Eigen::Quaterniond(rotation).normalized(),
                     *rectify * camera_from_laser->col(3)};
  return camera.inverse();
}

Result<Pose3> laser_from_camera_for(const std::filesystem::path& boxes,
                                    const std::filesystem::path& calibration,
                                    Diagnostics& diagnostics) {
  if (!calibration.empty()) {
    auto lines = LineReader::open(calibration);
    if (!lines) return tl::unexpected(lines.error());
    if (const auto found = laser_from_camera(std::move(*lines), diagnostics)) return *found;
    return fail(Error::Code::kMalformed,
                "{}: no KITTI calibration; it needs R_rect (or R0_rect), 9 numbers of a rotation, "
                "and Tr_velo_cam (or Tr_velo_to_cam), 12",
                calibration.string());
  }
  if (const auto found = calibration_beside(boxes, diagnostics)) return *found;
  diagnostics.note("no calibration beside the labels: KITTI's usual camera assumed",
                   boxes.string() + ", x = z_cam + 0.27 m, y = -x_cam, z = -y_cam - 0.08 m");
  return usual_laser_from_camera();
}

}  // namespace scanfuse::io
