#include <filesystem>
#include <memory>

#include "command.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/io/text/numbers.hpp"
#include "scanfuse/simulate/passive.hpp"

namespace scanfuse::app {
namespace {

struct PassiveArguments {
  std::string out;
  std::string sensors_out;
  double noise_mrad = 5;
  std::vector<std::string> sets;
  simulate::PassiveOptions options;
};

/// BEARINGS.truth.csv: where every target was at every scan.
Result<void> write_passive_truth(const std::filesystem::path& path,
                                 const simulate::PassiveRecording& recording) {
  auto file = io::AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  auto wrote = file->write(
      std::string_view("frame,time_s,object_id,class,x_m,y_m,z_m,vx_m_per_s,vy_m_per_s\n"));
  for (std::size_t k = 0; wrote && k < recording.scans.size(); ++k) {
    std::string rows;
    for (std::size_t t = 0; t < recording.targets[k].size(); ++t) {
      const simulate::PassiveTarget& target = recording.targets[k][t];
      rows += fmt::format(
          "{},{},{},unknown,{},{},{},{},{}\n", recording.scans[k].scan,
          io::print_seconds(recording.scans[k].stamp), t, io::print_number(target.position_m.x()),
          io::print_number(target.position_m.y()), io::print_number(target.position_m.z()),
          io::print_number(target.velocity_m_per_s.x()),
          io::print_number(target.velocity_m_per_s.y()));
    }
    wrote = file->write(rows);
  }
  if (!wrote) return wrote;
  return file->commit();
}

int run_simulate_passive(PassiveArguments arguments, const CommonOptions& common) {
  arguments.options.noise_rad = arguments.noise_mrad * 1e-3;
  if (auto done = apply_settings(arguments.options, "passive", arguments.sets); !done) {
    return report_error(done.error());
  }
  const auto recording = simulate::simulate_passive(arguments.options, common.seed);
  if (!recording) return report_error(recording.error());
  const auto truth = std::filesystem::path(arguments.out).replace_extension(".truth.csv");
  for (const auto& done : {io::write_bearings(arguments.out, recording->scans, recording->scene),
                           io::write_sensors(arguments.sensors_out, recording->scene),
                           write_passive_truth(truth, *recording)}) {
    if (!done) return report_error(done.error());
  }
  return kDone;
}

std::string passive_help() {
  std::string text = "Settings (--set passive.NAME=VALUE):\n";
  for (const auto& view : view_options("passive", simulate::PassiveOptions{})) {
    text += fmt::format("  {:<28} {} [{}; {}]\n", view.name, view.doc, view.fallback, view.range);
  }
  return text +
         "Example:\n  scanfuse simulate passive --targets 20 --spacing 1000 --noise-mrad 5 "
         "-o bearings.csv --sensors-out sensors.toml --seed 1\n";
}

}  // namespace

void add_simulate_passive(CLI::App& simulate, const Tool& tool) {
  auto arguments = std::make_shared<PassiveArguments>();
  auto* app = simulate.add_subcommand("passive", "Bearings of targets seen by passive sensors");
  app->add_option("-o,--output", arguments->out,
                  "Bearings to write: .csv, with .truth.csv beside it")
      ->required();
  app->add_option("--sensors-out", arguments->sensors_out, "Sensors to write: .toml")->required();
  auto& options = arguments->options;
  app->add_option("--targets", options.targets, "How many")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  app->add_option("--spacing", options.spacing_m, "Metres from target to target")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app->add_option("--noise-mrad", arguments->noise_mrad, "Standard deviation of the angles")
      ->check(CLI::Range(1e-4, 1000.0))
      ->capture_default_str();
  app->add_option("--set", arguments->sets, "Change a setting: passive.NAME=VALUE")
      ->allow_extra_args(false);
  app->footer(passive_help());
  app->callback(
      [arguments, tool] { *tool.exit_code = run_simulate_passive(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
