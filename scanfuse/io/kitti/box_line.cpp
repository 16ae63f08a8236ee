#include "scanfuse/io/kitti/box_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::int64_t kLastFrame = 100'000'000;  // its time fits at any frame rate
constexpr double kLargestNumber = 1e6;

/// The words of a line in the order of an object label, whatever its layout.
enum Field : std::size_t { kType, kOccluded = 2, kHeight = 8, kWidth, kLength, kX, kY, kZ, kTurn };
constexpr std::size_t kFields = 15;  // a score may follow

constexpr std::size_t kTableColumns = 15;
constexpr std::size_t kTableScore = 6;

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

std::string_view type_of_code(std::string_view code) {
  const auto number = parse_whole(code);
  if (number == 1) return "Pedestrian";
  if (number == 2) return "Car";
  return number == 3 ? "Cyclist" : "";
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

/// The words of layout kTable in the order of an object label with a score.
std::vector<std::string_view> as_object(const std::vector<std::string_view>& c) {
  return {type_of_code(c[1]),
          "0",
          "0",
          c[14],
          c[2],
          c[3],
          c[4],
          c[5],
          c[7],
          c[8],
          c[9],
          c[10],
          c[11],
          c[12],
          c[13],
          c[kTableScore]};
}

std::optional<double> sound_number(std::string_view word) {
  const auto number = parse_number(word);
  return number && std::abs(*number) <= kLargestNumber ? number : std::nullopt;
}

std::optional<KittiBox> box_of(const std::vector<std::string_view>& words,
                               const Pose3& laser_from_camera) {
  KittiBox box;
  if (words[kType] == "DontCare") {
    box.dont_care = true;
    return box;
  }
  std::array<double, kFields> v{};
  for (std::size_t i = kType + 1; i < kFields; ++i) {
    const auto number = sound_number(words[i]);
    if (!number) return std::nullopt;
    v[i] = *number;
  }
  if (words.size() > kFields) {
    box.score = sound_number(words[kFields]);
    if (!box.score) return std::nullopt;
  }
  const Eigen::Vector3d bottom(v[kX], v[kY], v[kZ]), up(0, -v[kHeight] / 2, 0);
  const Eigen::Vector3d ahead =
      laser_from_camera.rotation * Eigen::Vector3d(std::cos(v[kTurn]), 0, -std::sin(v[kTurn]));
  box.object_class = class_of_type(words[kType]);
  box.centre_m = laser_from_camera * Eigen::Vector3d(bottom + up);
  box.heading_rad = std::atan2(ahead.y(), ahead.x());
  box.length_m = v[kLength];
  box.width_m = v[kWidth];
  box.height_m = v[kHeight];
  box.occluded = v[kOccluded];
  return box;
}

bool is_table(const std::vector<std::string_view>& cells) {
  return cells.size() == kTableColumns && parse_whole(cells[0]) && !type_of_code(cells[1]).empty();
}

}  // namespace

std::vector<std::string_view> kitti_words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0;;) {
    const std::size_t begin = line.find_first_not_of(" \t\r", i);
    if (begin == line.npos) return words;
    i = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, i - begin));
  }
}

KittiLayout kitti_layout(std::string_view line) {
  const auto words = kitti_words(line);
  const std::size_t n = words.size();
  if ((n == kFields || n == kFields + 1) && is_known_type(words[0])) return KittiLayout::kObject;
  if ((n == kFields + 2 || n == kFields + 3) && parse_whole(words[0]) && is_known_type(words[2])) {
    return KittiLayout::kTracking;
  }
  return is_table(cells_of(line)) ? KittiLayout::kTable : KittiLayout::kNone;
}

std::optional<KittiLine> parse_kitti_line(std::string_view line, KittiLayout layout,
                                          const Pose3& laser_from_camera) {
  auto words = layout == KittiLayout::kTable ? cells_of(line) : kitti_words(line);
  const bool tracking = layout == KittiLayout::kTracking;
  if (words.size() < kFields + (tracking ? 2 : 0)) return std::nullopt;
  KittiLine result;
  if (layout != KittiLayout::kObject) {
    const auto frame = parse_whole(words[0]);
    if (!frame || *frame < 0 || *frame > kLastFrame) return std::nullopt;
    result.frame = *frame;
  }
  if (layout == KittiLayout::kTable) {
    if (!is_table(words)) return std::nullopt;
    words = as_object(words);
  }
  std::optional<std::int64_t> track = -1;
  if (tracking) {
    track = parse_whole(words[1]);
    words.erase(words.begin(), words.begin() + 2);
  }
  if (!track) return result;
  result.box = box_of(words, laser_from_camera);
  if (result.box) result.box->track = *track;
  return result;
}

}  // namespace scanfuse::io
