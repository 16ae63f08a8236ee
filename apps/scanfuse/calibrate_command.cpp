#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate_json.hpp"
#include "command.hpp"
#include "scanfuse/calibrate/pose.hpp"
#include "scanfuse/calibrate/rig_error.hpp"
#include "scanfuse/calibrate/turntable.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/image.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"
#include "scanfuse/report/turntable_report.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

using calibrate::TurntableCalibration;
using calibrate::TurntableOptions;
using pipeline::LoadedSession;

struct CalibrateArguments {
  std::string session;
  std::string out;
  std::string report;
  std::string method;
  std::string first_board;
  std::vector<std::string> sets;
  int position = 0;
  bool json = false;
  bool view = false;
};

/// Settings of three sections: calibrate, boards, stripes.
Result<void> apply_calibrate_settings(const CalibrateArguments& arguments,
                                      TurntableOptions& options,
                                      pipeline::SessionLoadOptions& load) {
  for (const auto& [name, value] :
       {std::pair{"method", arguments.method}, {"first_board", arguments.first_board}}) {
    if (value.empty()) continue;
    if (auto done = set_option(options, name, value); !done) return done;
  }
  for (const std::string& set : arguments.sets) {
    const auto setting = split_setting(set);
    if (setting && setting->section == "stripes") {
      if (auto done = set_option(load.stripes, setting->name, setting->value); !done) return done;
    } else if (setting && setting->section == "boards") {
      if (auto done = set_option(load.boards, setting->name, setting->value); !done) return done;
    } else if (setting && setting->section == "camera") {
      if (auto done = set_option(load.camera, setting->name, setting->value); !done) return done;
    } else if (auto done = apply_settings(options, "calibrate", {set}); !done) {
      return done;
    }
  }
  return {};
}

Result<LoadedSession> load(const CalibrateArguments& arguments, const CommonOptions& common,
                           pipeline::SessionLoadOptions options) {
  Progress progress("finding stripes", common.quiet);
  options.threads = common.threads;
  options.thumbnail_width_px = arguments.report.empty() ? 0 : 200;
  options.progress = [&](std::size_t done, std::size_t all) {
    progress.update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(all));
    return interrupted.load();
  };
  return pipeline::load_turntable_session(arguments.session, options);
}

void print_calibration(const TurntableCalibration& calibration, const LoadedSession& session,
                       const CalibrateArguments& arguments) {
  const Rig& rig = calibration.rig;
  const auto sigma = [&](int first, int count) {
    return std::sqrt(rig.covariance.diagonal().segment(first, count).sum());
  };
  const auto& n = rig.axis_direction;
  const Eigen::Vector3d p = rig.axis_point_m * 1e3;
  const Eigen::Vector3d c = rig.camera_from_lidar.translation_m * 1e3;
  fmt::print("{}\n", arguments.session);
  fmt::print("  {:<18} {} of {}\n", "positions used", calibration.positions_used,
             calibration.positions.size());
  fmt::print("  {:<18} ({:.6f}, {:.6f}, {:.6f}) +- {:.4f} deg\n", "axis direction", n.x(), n.y(),
             n.z(), degrees(sigma(0, 2)));
  fmt::print("  {:<18} ({:.3f}, {:.3f}, {:.3f}) mm +- {:.3f} mm\n", "axis point", p.x(), p.y(),
             p.z(), sigma(2, 2) * 1e3);
  fmt::print("  {:<18} ({:.3f}, {:.3f}, {:.3f}) mm +- {:.3f} mm\n", "lidar centre", c.x(), c.y(),
             c.z(), sigma(7, 3) * 1e3);
  fmt::print("  {:<18} {:.3f} mm\n", "range bias", rig.range_bias_m * 1e3);
  fmt::print("  {:<18} corners {:.3f} px, stripe {:.3f} px, lidar {:.3f} mm\n", "rms",
             calibration.rms.corner_px, calibration.rms.stripe_px, calibration.rms.lidar_mm);
  fmt::print("  {:<18} {:.3f} to {:.3f} deg\n", "calibrated arc", degrees(rig.first_turntable_rad),
             degrees(rig.last_turntable_rad));
  fmt::print("  {:<18} files {:.2f} s, boards {:.2f} s, stripes {:.2f} s\n", "time",
             session.seconds_files, session.seconds_boards, session.seconds_stripes);
  for (const auto& path : {arguments.out, arguments.report}) {
    if (!path.empty()) fmt::print("  {:<18} {}\n", "wrote", path);
  }
}

/// Positions that were left out and warnings, on stderr.
void tell_oddities(const TurntableCalibration& calibration, const LoadedSession& session) {
  for (std::size_t k = 0; k < calibration.positions.size(); ++k) {
    if (calibration.positions[k].used) continue;
    fmt::print(stderr, "scanfuse: left out {} ({:.3f} deg): {}\n", calibration.positions[k].name,
               degrees(calibration.positions[k].turntable_rad), reason_of(calibration, session, k));
  }
  for (const auto& warning : calibration.warnings) {
    fmt::print(stderr, "scanfuse: warning: {}\n", warning);
  }
}

report::ReportPicture picture_of(const pipeline::Thumbnail& small) {
  if (small.image.pixels.empty()) return {};
  auto png = io::print_png(small.image);
  if (!png) return {};
  return {std::move(*png), small.image.width_px, small.image.height_px, small.scale};
}

report::TurntableReport report_of(const TurntableCalibration& calibration,
                                  const LoadedSession& session,
                                  const CalibrateArguments& arguments) {
  report::TurntableReport report;
  report.title = arguments.session;
  report.features = session.features;
  report.rig = calibration.rig;
  report.camera_from_board = calibration.camera_from_board;
  report.method = scanfuse::detail::print(calibration.method);
  report.rms = {calibration.rms.corner_px, calibration.rms.stripe_px, calibration.rms.lidar_mm};
  const auto& table = calibration.table1;
  report.table1 = {{{table.centre_mm.mean, table.centre_mm.max},
                    {table.z_axis_deg.mean, table.z_axis_deg.max},
                    {table.x_axis_deg.mean, table.x_axis_deg.max}}};
  report.warnings = calibration.warnings;
  report.chi2_per_dof = calibration.chi2_per_dof;
  report.board = picture_of(session.board);
  for (std::size_t k = 0; k < calibration.positions.size(); ++k) {
    const auto& from = calibration.positions[k];
    report::ReportedPosition to;
    to.name = from.name;
    to.turntable_rad = from.turntable_rad;
    to.used = from.used;
    to.reason = reason_of(calibration, session, k);
    to.stripe_px = from.stripe_px;
    to.lidar_m = from.lidar_m;
    to.correction_rad = from.turntable_correction_rad;
    to.returns = from.returns;
    if (k < session.stripes.size()) to.picture = picture_of(session.stripes[k]);
    report.positions.push_back(std::move(to));
  }
  report.point_sigma = [rig = calibration.rig](double turntable_rad, double range_m) {
    const auto p = calibrate::point_covariance(rig, turntable_rad, 0, range_m);
    return std::sqrt(std::max(p.trace(), 0.0));
  };
  return report;
}

int view_rig(const TurntableCalibration& calibration, const LoadedSession& session,
             const CalibrateArguments& arguments, const CommonOptions& common) {
  const TurntableFeatures& features = session.features;
  RigScene scene{arguments.session, features.positions, calibration.rig, features.camera, {}};
  for (std::size_t b = 0; b < 2; ++b) {
    scene.boards.emplace_back(features.boards[b], calibration.camera_from_board[b]);
  }
  ViewRequest request;
  request.track.input = arguments.session;
  request.scene = std::move(scene);
  return run_view(std::move(request), common);
}

int run_calibrate_turntable(const CalibrateArguments& arguments, const CommonOptions& common) {
  catch_interrupts();
  TurntableOptions options;
  pipeline::SessionLoadOptions load_options;
  if (auto done = apply_calibrate_settings(arguments, options, load_options); !done) {
    return report_error(done.error());
  }
  const auto session = load(arguments, common, load_options);
  if (!session) return report_error(session.error());
  if (session->stopped || interrupted) return kInterrupted;
  const auto start = std::chrono::steady_clock::now();
  const auto calibration = calibrate::calibrate_turntable(session->features, options);
  if (!calibration) {
    for (const auto& left : session->left_out) {
      fmt::print(stderr, "scanfuse: left out {}: {}\n",
                 session->features.positions[left.position].name, left.reason);
    }
    return report_error(calibration.error());
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (interrupted) return kInterrupted;
  if (!arguments.out.empty()) {
    auto wrote = io::write_rig(arguments.out, {calibration->rig, session->features.camera});
    if (!wrote) return report_error(wrote.error());
  }
  if (!arguments.report.empty()) {
    auto wrote = io::write_whole(
        arguments.report, report::turntable_page(report_of(*calibration, *session, arguments)));
    if (!wrote) return report_error(wrote.error());
  }
  if (arguments.json) {
    auto json = calibration_json(*calibration, *session);
    json["seconds"]["calibration"] = seconds;
    fmt::print("{}\n", json.dump(2));
  } else {
    print_calibration(*calibration, *session, arguments);
  }
  if (!common.quiet) tell_oddities(*calibration, *session);
  Diagnostics diagnostics = session->diagnostics;
  diagnostics.merge(calibration->diagnostics);
  const int code = report_diagnostics(diagnostics, common.quiet);
  if (!arguments.view || (code != kDone && code != kDamagedInput)) return code;
  const int served = view_rig(*calibration, *session, arguments, common);
  return served == kDone ? code : served;
}

nlohmann::json pose_json(const calibrate::FixedPose& pose, const std::string& name) {
  const Eigen::Matrix3d r = pose.camera_from_lidar.rotation.toRotationMatrix();
  const Eigen::Vector3d c = pose.camera_from_lidar.translation_m * 1e3;
  const auto column = [&](int k) { return std::vector<double>{r(0, k), r(1, k), r(2, k)}; };
  return {{"position", name},
          {"center_mm", {c.x(), c.y(), c.z()}},
          {"x_axis", column(0)},
          {"y_axis", column(1)},
          {"z_axis", column(2)},
          {"v_angle_deg", degrees(pose.v_angle_rad)},
          {"rms", {{"stripe_px", pose.stripe_px}, {"lidar_mm", pose.lidar_m * 1e3}}}};
}

int run_calibrate_pose(const CalibrateArguments& arguments, const CommonOptions& common) {
  catch_interrupts();
  TurntableOptions options;
  pipeline::SessionLoadOptions load_options;
  CalibrateArguments settings = arguments;
  settings.method.clear();
  if (auto done = apply_calibrate_settings(settings, options, load_options); !done) {
    return report_error(done.error());
  }
  const auto session = load(arguments, common, load_options);
  if (!session) return report_error(session.error());
  if (session->stopped) return kInterrupted;
  const auto& positions = session->features.positions;
  if (arguments.position < 0 || static_cast<std::size_t>(arguments.position) >= positions.size()) {
    return report_error({Error::Code::kOutOfRange,
                         fmt::format("--position {}: {} has positions 0 to {}", arguments.position,
                                     arguments.session, positions.size() - 1)});
  }
  const auto place = static_cast<std::size_t>(arguments.position);
  const auto method = arguments.method == "liu2023" ? calibrate::PoseMethod::kLiu2023
                                                    : calibrate::PoseMethod::kExact;
  const auto order = options.first_board == calibrate::FirstBoard::kDescending
                         ? calibrate::BoardOrder::kDescending
                         : calibrate::BoardOrder::kAscending;
  const auto pose = calibrate::fixed_pose(session->features, place, method, order);
  if (!pose) {
    for (const auto& left : session->left_out) {
      if (left.position == place) return report_error({pose.error().code, left.reason});
    }
    return report_error(pose.error());
  }
  const auto json = pose_json(*pose, positions[place].name);
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    const Eigen::Vector3d c = pose->camera_from_lidar.translation_m * 1e3;
    fmt::print("{}, {}\n", arguments.session, positions[place].name);
    fmt::print("  {:<18} ({:.3f}, {:.3f}, {:.3f}) mm\n", "lidar centre", c.x(), c.y(), c.z());
    fmt::print("  {:<18} {}\n", "x axis", json["x_axis"].dump());
    fmt::print("  {:<18} {}\n", "z axis", json["z_axis"].dump());
    fmt::print("  {:<18} stripe {:.3f} px, lidar {:.3f} mm\n", "rms", pose->stripe_px,
               pose->lidar_m * 1e3);
  }
  return report_diagnostics(session->diagnostics, common.quiet);
}

std::string calibrate_help() {
  return "Settings (--set SECTION.NAME=VALUE):\n" +
         settings_help(view_options("calibrate", TurntableOptions{})) +
         settings_help(view_options("stripes", camera::StripeOptions{})) +
         settings_help(view_options("boards", camera::BoardOptions{})) +
         "Example:\n  scanfuse simulate turntable -o session\n"
         "  scanfuse calibrate turntable session -o rig.toml --report report.html\n";
}

void add_turntable(CLI::App& calibrate, const Tool& tool) {
  auto arguments = std::make_shared<CalibrateArguments>();
  auto* app = calibrate.add_subcommand(
      "turntable", "Axis and lidar of a turntable from a session of images and scans");
  app->add_option("session", arguments->session, "The session's folder")->required();
  app->add_option("-o,--output", arguments->out, "Rig to write: .toml");
  app->add_option("--report", arguments->report, "A page to look at: .html");
  app->add_option("--method", arguments->method, "liu2023, closed_form or joint");
  app->add_option("--first-board", arguments->first_board,
                  "Which board the scan meets first: automatic, ascending or descending");
  app->add_option("--set", arguments->sets, "Change a setting: section.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->add_flag("--view", arguments->view,
                "Then look at the rig and its cloud in a browser, as `scanfuse view --rig` does");
  app->footer(calibrate_help());
  app->callback(
      [arguments, tool] { *tool.exit_code = run_calibrate_turntable(*arguments, *tool.common); });
}

void add_pose(CLI::App& calibrate, const Tool& tool) {
  auto arguments = std::make_shared<CalibrateArguments>();
  auto* app = calibrate.add_subcommand("pose", "The lidar's pose at one position alone");
  app->add_option("session", arguments->session, "The session's folder")->required();
  app->add_option("--position", arguments->position, "Which, counted from 0")
      ->capture_default_str();
  app->add_option("--method", arguments->method, "exact or liu2023")
      ->check(CLI::IsMember({"exact", "liu2023"}));
  app->add_option("--first-board", arguments->first_board, "ascending or descending");
  app->add_option("--set", arguments->sets, "Change a setting: section.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->footer("Example:\n  scanfuse calibrate pose session --position 0\n");
  app->callback(
      [arguments, tool] { *tool.exit_code = run_calibrate_pose(*arguments, *tool.common); });
}

}  // namespace

void add_calibrate(Tool& tool) {
  auto* app = tool.app->add_subcommand(
      "calibrate", "Calibrate a lidar on a turntable, one pose of it, or a camera");
  app->require_subcommand(1);
  add_turntable(*app, tool);
  add_pose(*app, tool);
  add_calibrate_camera(*app, tool);
}

}  // namespace scanfuse::app
