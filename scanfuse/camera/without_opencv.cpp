// Stands in for find_corners.cpp and calibrate_camera.cpp in a build without OpenCV.
#include "scanfuse/camera/calibrate_camera.hpp"

namespace scanfuse::camera {
namespace {

tl::unexpected<Error> absent() {
  return fail(Error::Code::kUnsupported,
              "this build finds no chessboards: build with SCANFUSE_WITH_CAMERA=ON (OpenCV)");
}

}  // namespace

Result<DetectedBoard> find_board(const Image& /*image*/, const BoardSpec& /*spec*/,
                                 const BoardOptions& /*options*/) {
  return absent();
}

Result<std::array<DetectedBoard, 2>> find_two_boards(const Image& /*image*/,
                                                     const std::array<BoardSpec, 2>& /*specs*/,
                                                     const BoardOptions& /*options*/) {
  return absent();
}

Result<CameraCalibration> calibrate_camera(std::span<const DetectedBoard> /*boards*/,
                                           int /*width_px*/, int /*height_px*/,
                                           const CameraCalibrationOptions& /*options*/) {
  return absent();
}

}  // namespace scanfuse::camera
