#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/session/camera_table.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"

namespace scanfuse::app {
namespace {

struct CameraArguments {
  std::string images;
  std::string out;
  std::vector<std::string> sets;
  int rows = 14;
  int columns = 20;
  double square_mm = 20;
  bool json = false;
};

nlohmann::json camera_result(const pipeline::CameraFromImages& found) {
  const Camera& c = found.calibration.camera;
  nlohmann::json views = nlohmann::json::array();
  for (std::size_t k = 0; k < found.used.size(); ++k) {
    const auto& view = found.calibration.views[k];
    views.push_back({{"image", found.used[k].filename().string()},
                     {"rms_px", view.rms_px},
                     {"used", view.used}});
  }
  const auto& variance = found.calibration.covariance.diagonal();
  return {{"width_px", c.width_px},
          {"height_px", c.height_px},
          {"fx_px", c.fx_px},
          {"fy_px", c.fy_px},
          {"cx_px", c.cx_px},
          {"cy_px", c.cy_px},
          {"k1", c.k1},
          {"k2", c.k2},
          {"p1", c.p1},
          {"p2", c.p2},
          {"k3", c.k3},
          {"sigma", {{"fx_px", std::sqrt(variance[0])}, {"fy_px", std::sqrt(variance[1])}}},
          {"rms_px", found.calibration.rms_px},
          {"images", views},
          {"images_left_out", found.left_out}};
}

int run_calibrate_camera(const CameraArguments& arguments, const CommonOptions& common) {
  pipeline::SessionLoadOptions options;
  options.threads = common.threads;
  if (auto done = apply_settings(options.camera, "camera", arguments.sets); !done) {
    return report_error(done.error());
  }
  const auto images = io::list_images(arguments.images);
  if (!images) return report_error(images.error());
  const BoardSpec board{arguments.rows, arguments.columns, arguments.square_mm * 1e-3};
  const auto found = pipeline::calibrate_camera_from(*images, board, options);
  if (!found) return report_error(found.error());
  const std::string table = "[camera]\n" + io::camera_text(found->calibration.camera);
  if (!arguments.out.empty()) {
    if (auto wrote = io::write_whole(arguments.out, table); !wrote) {
      return report_error(wrote.error());
    }
  }
  if (arguments.json) {
    fmt::print("{}\n", camera_result(*found).dump(2));
  } else {
    fmt::print("{}", table);
    fmt::print("# rms {:.3f} px over {} of {} images\n", found->calibration.rms_px,
               found->used.size(), images->size());
  }
  if (!common.quiet) {
    for (const auto& left : found->left_out) fmt::print(stderr, "scanfuse: left out {}\n", left);
  }
  return kDone;
}

}  // namespace

void add_calibrate_camera(CLI::App& calibrate, const Tool& tool) {
  auto arguments = std::make_shared<CameraArguments>();
  auto* app = calibrate.add_subcommand("camera", "A camera's intrinsics from chessboard images");
  app->add_option("images", arguments->images, "Folder of images")->required();
  app->add_option("--rows", arguments->rows, "Inner corners, upwards")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app->add_option("--columns", arguments->columns, "Inner corners, sideways")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app->add_option("--square-mm", arguments->square_mm, "Side of a square")
      ->check(CLI::Range(0.01, 1e5))
      ->capture_default_str();
  app->add_option("-o,--output", arguments->out, "A [camera] table to write, for session.toml");
  app->add_option("--set", arguments->sets, "Change a setting: camera.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->footer("Settings (--set camera.NAME=VALUE):\n" +
              settings_help(view_options("camera", camera::CameraCalibrationOptions{})) +
              "Example:\n  scanfuse calibrate camera images --rows 14 --columns 20 "
              "--square-mm 20\n");
  app->callback(
      [arguments, tool] { *tool.exit_code = run_calibrate_camera(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
