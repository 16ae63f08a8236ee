#include <filesystem>
#include <memory>

#include "command.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/session/features_json.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/io/session/session_folder.hpp"
#include "scanfuse/simulate/turntable_scans.hpp"
#include "turntable_files.hpp"

namespace scanfuse::app {
namespace {

namespace fs = std::filesystem;
using simulate::SimulatedTurntable;

struct TurntableArguments {
  std::string out;
  bool features_only = false;
  bool laser_off = false;
  std::vector<std::string> sets;
  simulate::TurntableWorldOptions world;
  simulate::TurntableNoise noise;
  simulate::TurntableImageOptions images;
  simulate::TurntableScanOptions scans;
  int discs = 1;
};

Result<void> apply_turntable_settings(TurntableArguments& arguments) {
  for (const std::string& set : arguments.sets) {
    const auto setting = split_setting(set);
    if (!setting) {
      return fail(Error::Code::kMalformed,
                  "--set {}: write world.name=value, noise.name=value, images.name=value or "
                  "scans.name=value",
                  set);
    }
    Result<void> done;
    if (setting->section == "world") {
      done = set_option(arguments.world, setting->name, setting->value);
    } else if (setting->section == "noise") {
      done = set_option(arguments.noise, setting->name, setting->value);
    } else if (setting->section == "images") {
      done = set_option(arguments.images, setting->name, setting->value);
    } else if (setting->section == "scans") {
      done = set_option(arguments.scans, setting->name, setting->value);
    } else {
      done = fail(Error::Code::kNotFound,
                  "--set {}: the sections are world, noise, images and scans", set);
    }
    if (!done) return done;
  }
  return {};
}

/// Scans of a disc at each placement: scan/, scan_1/, ..., each with disc.toml, the truth.
Result<void> write_discs(const fs::path& folder, const SimulatedTurntable& made,
                         const TurntableArguments& arguments, const CommonOptions& common) {
  const auto sweeps = simulate::simulate_disc_sweeps(made.world, arguments.scans, arguments.discs,
                                                     common.seed, common.threads);
  const io::LidarConventions conventions;
  for (std::size_t d = 0; d < sweeps.size(); ++d) {
    const auto& sweep = sweeps[d];
    const fs::path place = folder / (d == 0 ? "scan" : fmt::format("scan_{}", d));
    if (auto done = make_folder(place); !done) return done;
    for (std::size_t k = 0; k < sweep.scans.size(); ++k) {
      auto wrote = io::write_whole(place / io::numbered_name("scan", k, ".csv"),
                                   io::scan_table_text(sweep.scans[k], conventions));
      if (!wrote) return wrote;
    }
    io::SessionFile session;
    session.turntable_rad = sweep.turntable_rad;
    const Eigen::Vector3d c = sweep.disc.camera_from_disc.translation_m * 1e3;
    const auto truth = fmt::format("diameter_mm = {}\ncenter_mm = [{}, {}, {}]\n",
                                   2e3 * sweep.disc.radius_m, c.x(), c.y(), c.z());
    for (const auto& done :
         {io::write_whole(place / "session.toml", io::session_file_text(session)),
          io::write_whole(place / "disc.toml", truth)}) {
      if (!done) return done;
    }
  }
  return {};
}

int run_simulate_turntable(TurntableArguments arguments, const CommonOptions& common) {
  catch_interrupts();
  if (auto done = apply_turntable_settings(arguments); !done) return report_error(done.error());
  const fs::path folder = arguments.out;
  if (auto made = make_folder(folder); !made) return report_error(made.error());
  auto made = simulate::simulate_turntable_features(arguments.world, arguments.noise, common.seed);
  if (!arguments.features_only) {
    auto scans = simulate::simulate_scans(made.world, arguments.scans, common.seed, made.turned_rad,
                                          common.threads);
    for (std::size_t k = 0; k < scans.size(); ++k) {
      made.features.positions[k].scan = std::move(scans[k]);
    }
  }
  auto wrote = write_session_scans(folder, made);
  if (wrote && arguments.features_only) {
    wrote = io::write_whole(folder / "features.json", io::features_text(made.features));
  } else if (wrote) {
    Progress progress("rendering", common.quiet);
    const auto tell = [&](std::size_t done, std::size_t all) {
      progress.update(static_cast<std::int64_t>(done), static_cast<std::int64_t>(all));
      return interrupted.load();
    };
    wrote = write_session_images(
        folder, made, {arguments.images, arguments.laser_off, common.seed, common.threads, tell});
  }
  if (wrote && !interrupted) wrote = write_discs(folder, made, arguments, common);
  if (!wrote) return report_error(wrote.error());
  if (interrupted) return kInterrupted;
  if (auto done = write_session_about(folder, made); !done) return report_error(done.error());
  return kDone;
}

std::string turntable_help() {
  return "Settings (--set SECTION.NAME=VALUE):\n" +
         settings_help(view_options("world", simulate::TurntableWorldOptions{})) +
         settings_help(view_options("noise", simulate::TurntableNoise{})) +
         settings_help(view_options("images", simulate::TurntableImageOptions{})) +
         settings_help(view_options("scans", simulate::TurntableScanOptions{})) +
         "Example:\n  scanfuse simulate turntable -o session --seed 3\n"
         "  scanfuse calibrate turntable session -o rig.toml --report report.html\n";
}

}  // namespace

void add_simulate_turntable(CLI::App& simulate, const Tool& tool) {
  auto arguments = std::make_shared<TurntableArguments>();
  auto* app = simulate.add_subcommand(
      "turntable", "A session of a lidar on a turntable before two chessboards, with truth.toml");
  app->add_option("-o,--output", arguments->out, "Folder to write")->required();
  app->add_flag("--features-only", arguments->features_only,
                "Corners and stripe points in features.json, no images");
  app->add_flag("--laser-off", arguments->laser_off, "Also images with the laser off");
  app->add_option("--positions", arguments->world.positions, "Angles of the turntable")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app->add_option("--discs", arguments->discs,
                  "Placements of a disc of 140 mm to scan: folders scan, scan_1, ...")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app->add_option("--set", arguments->sets, "Change a setting: section.name=value")
      ->allow_extra_args(false);
  app->footer(turntable_help());
  app->callback(
      [arguments, tool] { *tool.exit_code = run_simulate_turntable(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
