#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/io/cloud/cloud_file.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/session_folder.hpp"

namespace scanfuse::app {
namespace {

struct AssembleArguments {
  std::string scans;
  std::string rig;
  std::string out;
  std::string frame = "camera";
  std::vector<std::string> sets;
  bool keep_mixed = false;
  bool json = false;
};

Result<calibrate::AssembleOptions> assemble_options(const AssembleArguments& arguments) {
  calibrate::AssembleOptions options;
  options.keep_mixed = arguments.keep_mixed;
  options.frame = arguments.frame == "axis" ? CloudFrame::kAxis : CloudFrame::kCamera;
  if (auto done = apply_settings(options.mixed, "mixed", arguments.sets); !done) {
    return tl::unexpected(done.error());
  }
  return options;
}

void print_assembled(const calibrate::AssembledCloud& made, std::size_t scans,
                     const AssembleArguments& arguments) {
  fmt::print("{}\n", arguments.scans);
  fmt::print("  {:<18} {}\n", "scans", scans);
  fmt::print("  {:<18} {}\n", "returns", made.returns);
  fmt::print("  {:<18} {} {}\n", "mixed", made.mixed, arguments.keep_mixed ? "kept" : "removed");
  fmt::print("  {:<18} {:.2f} mm\n", "range noise", made.range_noise_m * 1e3);
  fmt::print("  {:<18} {} points in the {} frame to {}\n", "wrote", made.cloud.points.size(),
             arguments.frame, arguments.out);
}

int run_assemble(const AssembleArguments& arguments, const CommonOptions& common) {
  const auto options = assemble_options(arguments);
  if (!options) return report_error(options.error());
  const auto rig = io::read_rig(arguments.rig);
  if (!rig) return report_error(rig.error());
  const auto session = io::open_session(arguments.scans);
  if (!session) return report_error(session.error());
  const auto content = io::read_session_content(*session);
  if (!content) return report_error(content.error());
  const auto& positions = content->features.positions;
  const auto made = calibrate::assemble(positions, rig->rig, *options);
  if (!made) {
    return report_error({made.error().code, arguments.scans + ": " + made.error().message});
  }
  if (auto wrote = io::write_cloud(arguments.out, made->cloud); !wrote) {
    return report_error(wrote.error());
  }
  Diagnostics diagnostics = content->diagnostics;
  for (const auto& left : content->left_out) {
    diagnostics.damage("scan left out", left.reason);
  }
  if (made->beyond_arc > 0) {
    diagnostics.note("scan beyond the calibrated arc, where the rig is less sure", "",
                     made->beyond_arc);
  }
  const std::size_t scans = positions.size() - content->left_out.size();
  if (arguments.json) {
    fmt::print("{}\n", nlohmann::json{{"scans", scans},
                                      {"scans_left_out", content->left_out.size()},
                                      {"returns", made->returns},
                                      {"mixed", made->mixed},
                                      {"mixed_kept", arguments.keep_mixed},
                                      {"points", made->cloud.points.size()},
                                      {"scans_beyond_arc", made->beyond_arc},
                                      {"range_noise_mm", made->range_noise_m * 1e3},
                                      {"frame", arguments.frame}}
                           .dump(2));
  } else {
    print_assembled(*made, scans, arguments);
  }
  return report_diagnostics(diagnostics, common.quiet);
}

}  // namespace

void add_assemble(Tool& tool) {
  auto arguments = std::make_shared<AssembleArguments>();
  auto* app = tool.app->add_subcommand(
      "assemble", "Make one 3D cloud of the scans of a calibrated lidar on a turntable");
  app->add_option("scans", arguments->scans,
                  "Folder with session.toml ([turntable], [lidar]) and the scans")
      ->required();
  app->add_option("--rig", arguments->rig, "The calibrated rig: rig.toml")->required();
  app->add_option("-o,--output", arguments->out, "Cloud to write: .ply or .pcd")->required();
  app->add_option("--frame", arguments->frame, "Frame of the cloud: camera or axis")
      ->check(CLI::IsMember({"camera", "axis"}))
      ->capture_default_str();
  app->add_flag("--keep-mixed", arguments->keep_mixed,
                "Keep returns that lie between an edge and what is behind it");
  app->add_option("--set", arguments->sets, "Change a setting: mixed.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->footer("Settings (--set mixed.NAME=VALUE):\n" +
              settings_help(view_options("mixed", calibrate::MixedOptions{})) +
              "Example:\n  scanfuse assemble session/scan --rig rig.toml -o cloud.ply\n");
  app->callback([arguments, tool] { *tool.exit_code = run_assemble(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
