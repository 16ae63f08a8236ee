#include "scanfuse/io/session/camera_table.hpp"

#include <array>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

struct CameraNumber {
  const char* key;
  double Camera::* member;
  double low, high;
  bool needed;
};
constexpr std::array<CameraNumber, 9> kCameraNumbers{{{"fx_px", &Camera::fx_px, 1, 1e6, true},
                                                      {"fy_px", &Camera::fy_px, 1, 1e6, true},
                                                      {"cx_px", &Camera::cx_px, -1e5, 1e5, true},
                                                      {"cy_px", &Camera::cy_px, -1e5, 1e5, true},
                                                      {"k1", &Camera::k1, -100, 100, false},
                                                      {"k2", &Camera::k2, -1000, 1000, false},
                                                      {"p1", &Camera::p1, -10, 10, false},
                                                      {"p2", &Camera::p2, -10, 10, false},
                                                      {"k3", &Camera::k3, -1e4, 1e4, false}}};

}  // namespace

const std::vector<std::string>& camera_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> names{"width_px", "height_px"};
    for (const CameraNumber& number : kCameraNumbers) names.emplace_back(number.key);
    return names;
  }();
  return keys;
}

Result<Camera> read_camera(const DocumentTable& table) {
  Camera camera;
  const auto width = table.whole("width_px", 1, 100000);
  if (!width) return tl::unexpected(width.error());
  const auto height = table.whole("height_px", 1, 100000);
  if (!height) return tl::unexpected(height.error());
  camera.width_px = *width;
  camera.height_px = *height;
  for (const CameraNumber& number : kCameraNumbers) {
    if (!number.needed && !table.has(number.key)) continue;
    const auto value = table.number(number.key, number.low, number.high);
    if (!value) return tl::unexpected(value.error());
    camera.*number.member = *value;
  }
  return camera;
}

std::string camera_text(const Camera& camera) {
  std::string text =
      fmt::format("width_px = {}\nheight_px = {}\n", camera.width_px, camera.height_px);
  for (const CameraNumber& number : kCameraNumbers) {
    text += fmt::format("{} = {}\n", number.key, print_number(camera.*number.member));
  }
  return text;
}

}  // namespace scanfuse::io
