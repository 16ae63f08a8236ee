#include "scanfuse/core/parallel.hpp"
#include "scanfuse/io/image.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"

namespace scanfuse::pipeline {

Result<CameraFromImages> calibrate_camera_from(const std::vector<std::filesystem::path>& images,
                                               const BoardSpec& board,
                                               const SessionLoadOptions& options) {
  struct View {
    std::optional<camera::DetectedBoard> board;
    int width_px = 0, height_px = 0;
    std::string fault;
  };
  std::vector<View> views(images.size());
  parallel_for(images.size(), options.threads, [&](std::size_t k) {
    const auto image = io::read_image(images[k]);
    if (!image) {
      views[k].fault = image.error().message;
      return;
    }
    views[k].width_px = image->width_px;
    views[k].height_px = image->height_px;
    auto found = camera::find_board(*image, board, options.boards);
    if (found) {
      views[k].board = std::move(*found);
    } else {
      views[k].fault = images[k].string() + ": " + found.error().message;
    }
  });
  CameraFromImages result;
  std::vector<camera::DetectedBoard> boards;
  int width = 0, height = 0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    if (!views[k].board) {
      result.left_out.push_back(views[k].fault);
      continue;
    }
    if (boards.empty()) width = views[k].width_px, height = views[k].height_px;
    if (views[k].width_px != width || views[k].height_px != height) {
      return fail(Error::Code::kMalformed, "{}: {} x {} pixels; the images before it have {} x {}",
                  images[k].string(), views[k].width_px, views[k].height_px, width, height);
    }
    boards.push_back(std::move(*views[k].board));
    result.used.push_back(images[k]);
  }
  auto calibration = camera::calibrate_camera(boards, width, height, options.camera);
  if (!calibration) {
    const std::string why = result.left_out.empty() ? "" : "; " + result.left_out.front();
    return fail(calibration.error().code, "{} ({} of {} images show the board{})",
                calibration.error().message, boards.size(), images.size(), why);
  }
  result.calibration = std::move(*calibration);
  return result;
}

}  // namespace scanfuse::pipeline
