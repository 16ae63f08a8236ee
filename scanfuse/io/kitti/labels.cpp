#include "scanfuse/io/kitti/labels.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <map>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kFields = 17;
constexpr double kFrame_s = 0.1;

enum Field : std::size_t {
  kFrame,
  kTrack,
  kType,
  kOccluded = 4,
  kHeight = 10,
  kWidth,
  kLength,
  kX,
  kY,
  kZ,
  kRotation
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0;;) {
    const std::size_t begin = line.find_first_not_of(" \t\r", i);
    if (begin == line.npos) return words;
    i = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, i - begin));
  }
}

ObjectClass class_of_type(std::string_view type) {
  if (type == "Car" || type == "Van" || type == "Truck") return ObjectClass::kVehicle;
  if (type.starts_with("Person") || type == "Pedestrian") return ObjectClass::kPedestrian;
  return type == "Cyclist" ? ObjectClass::kCyclist : ObjectClass::kOther;
}

bool is_known_type(std::string_view type) {
  constexpr std::array kTypes{"Car",    "Van",     "Truck", "Pedestrian", "Person_sitting",
                              "Person", "Cyclist", "Tram",  "Misc",       "DontCare"};
  return std::ranges::find(kTypes, type) != kTypes.end();
}

/// The camera's axes (x right, y down, z forward) in the laser's.
Pose3 usual_laser_from_camera() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(axes), Eigen::Vector3d(0.27, 0, -0.08)};
}

/// The numbers behind `name` or `name:` in a calibration line.
std::optional<std::vector<double>> numbers_after(std::string_view line, std::string_view name) {
  const auto words = words_of(line);
  if (words.empty()) return std::nullopt;
  std::string_view first = words[0];
  if (first.ends_with(':')) first.remove_suffix(1);
  if (first != name) return std::nullopt;
  std::vector<double> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// One label; nothing when a number does not fit.
std::optional<TruthObject> object_of(const std::vector<std::string_view>& words,
                                     const Pose3& laser_from_camera) {
  std::array<double, kFields> v{};
  for (std::size_t i = 0; i < kFields; ++i) {
    if (i == kType) continue;
    const auto number = parse_number(words[i]);
    if (!number || std::abs(*number) > 1e6) return std::nullopt;
    v[i] = *number;
  }
  const Eigen::Vector3d bottom(v[kX], v[kY], v[kZ]), up(0, -v[kHeight] / 2, 0);
  const Eigen::Vector3d centre = laser_from_camera * Eigen::Vector3d(bottom + up);
  const Eigen::Vector3d ahead = laser_from_camera.rotation *
                                Eigen::Vector3d(std::cos(v[kRotation]), 0, -std::sin(v[kRotation]));
  TruthObject object;
  object.id = static_cast<std::int64_t>(v[kTrack]);
  object.object_class = class_of_type(words[kType]);
  object.position_m = centre.head<2>();
  object.z_m = centre.z();
  object.heading_rad = std::atan2(ahead.y(), ahead.x());
  object.length_m = v[kLength];
  object.width_m = v[kWidth];
  object.height_m = v[kHeight];
  object.occluded = v[kOccluded];
  return object;
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

bool is_kitti_label(std::string_view line) {
  const auto words = words_of(line);
  return (words.size() == kFields || words.size() == kFields + 1) && parse_whole(words[kFrame]) &&
         is_known_type(words[kType]);
}

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

Result<std::vector<TruthFrame>> read_kitti_labels(LineReader lines, const Pose3& laser_from_camera,
                                                  Diagnostics& diagnostics) {
  std::map<std::int64_t, TruthFrame> frames;
  while (const auto line = lines.next(diagnostics)) {
    if (trimmed(*line).empty()) continue;
    const auto words = words_of(*line);
    const auto number = words.empty() ? std::nullopt : parse_whole(words[kFrame]);
    if (words.size() < kFields || !number || *number < 0 || *number > INT32_MAX) {
      diagnostics.damage("bad label line skipped", lines.where());
      continue;
    }
    TruthFrame& frame = frames[*number];
    frame.frame = *number;
    frame.stamp = time_from_seconds(kFrame_s * static_cast<double>(*number));
    frame.coordinate_frame = "ego";
    if (words[kType] == "DontCare") continue;
    if (auto object = object_of(words, laser_from_camera)) {
      frame.objects.push_back(std::move(*object));
    } else {
      diagnostics.damage("bad label line skipped", lines.where());
    }
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
  auto calibration = calibration_beside(path, diagnostics);
  if (!calibration) {
    diagnostics.note("no calibration beside the labels: KITTI's usual camera assumed",
                     path.string());
    calibration = usual_laser_from_camera();
  }
  return read_kitti_labels(std::move(*lines), *calibration, diagnostics);
}

}  // namespace scanfuse::io
