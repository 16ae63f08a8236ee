#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "scanfuse/calibrate/cloud/measure.hpp"
#include "scanfuse/io/cloud/cloud_file.hpp"
#include "scanfuse/io/session/rig_toml.hpp"

namespace scanfuse::app {
namespace {

using calibrate::CropBox;
using calibrate::Measured;

struct MeasureArguments {
  std::string cloud;
  std::string rig;
  std::vector<std::string> crops;
  std::vector<std::string> sets;
  double spot_mm = 0;
  bool json = false;
};

/// What all measures start from.
struct MeasureInput {
  Cloud cloud;
  std::optional<Rig> rig;
  std::vector<CropBox> crops;
  calibrate::MeasureOptions options;
  Diagnostics diagnostics;
};

Result<CropBox> parse_crop(const std::string& text) {
  const auto wrong = [&] {
    return fail(Error::Code::kMalformed,
                "--crop {}: write X0,X1,Y0,Y1,Z0,Z1 in metres, each pair ascending", text);
  };
  std::array<double, 6> values{};
  std::string_view rest = text;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto comma = rest.find(',');
    if ((comma == rest.npos) != (k == 5)) return wrong();
    const auto value = scanfuse::detail::parse<double>(rest.substr(0, comma));
    if (!value || !std::isfinite(*value)) return wrong();
    values[k] = *value;
    rest.remove_prefix(comma == rest.npos ? rest.size() : comma + 1);
  }
  CropBox box;
  for (int k = 0; k < 3; ++k) {
    const auto place = static_cast<std::size_t>(2 * k);
    if (!(values[place] < values[place + 1])) return wrong();
    box.low_m[k] = values[place];
    box.high_m[k] = values[place + 1];
  }
  return box;
}

Result<MeasureInput> read_input(const MeasureArguments& arguments) {
  MeasureInput input;
  if (auto done = apply_settings(input.options, "measure", arguments.sets); !done) {
    return tl::unexpected(done.error());
  }
  if (arguments.spot_mm > 0) input.options.spot_m = arguments.spot_mm * 1e-3;
  for (const auto& text : arguments.crops) {
    const auto box = parse_crop(text);
    if (!box) return tl::unexpected(box.error());
    input.crops.push_back(*box);
  }
  if (!arguments.rig.empty()) {
    const auto rig = io::read_rig(arguments.rig);
    if (!rig) return tl::unexpected(rig.error());
    input.rig = rig->rig;
  }
  auto cloud = io::read_cloud(arguments.cloud, input.diagnostics);
  if (!cloud) return tl::unexpected(cloud.error());
  input.cloud = std::move(*cloud);
  return input;
}

nlohmann::json vector_json(const Eigen::Vector3d& v, double scale = 1) {
  return {v.x() * scale, v.y() * scale, v.z() * scale};
}

nlohmann::json measured_json(const Measured& m, double scale) {
  return {{"value", m.value * scale},
          {"sigma", m.sigma() * scale},
          {"sigma_points", m.sigma_points * scale},
          {"sigma_rig", m.sigma_rig * scale}};
}

nlohmann::json plane_json(const calibrate::PlaneMeasure& plane) {
  return {{"normal", vector_json(plane.normal)},
          {"center_mm", vector_json(plane.centre_m, 1e3)},
          {"distance_mm", measured_json(plane.distance_m, 1e3)},
          {"tilt_sigma_deg", degrees(plane.tilt_rad.sigma())},
          {"rms_mm", plane.rms_m * 1e3},
          {"points", plane.points},
          {"points_left_out", plane.left_out}};
}

std::string with_sigma(const Measured& m) {
  std::string text = fmt::format("{:.3f} mm +- {:.3f} mm", m.value * 1e3, m.sigma() * 1e3);
  if (m.sigma_rig > 0) {
    text += fmt::format(" (points {:.3f}, rig {:.3f})", m.sigma_points * 1e3, m.sigma_rig * 1e3);
  }
  return text;
}

/// Rows of text and the JSON object of one measure.
struct MeasureResult {
  std::vector<std::pair<std::string, std::string>> rows;
  nlohmann::json object;
};

CropBox first_crop(const MeasureInput& input) {
  return input.crops.empty() ? CropBox{} : input.crops.front();
}

void add_plane_rows(const calibrate::PlaneMeasure& plane, MeasureResult& result) {
  result.rows.emplace_back(
      "normal", fmt::format("({:.5f}, {:.5f}, {:.5f}) +- {:.4f} deg", plane.normal.x(),
                            plane.normal.y(), plane.normal.z(), degrees(plane.tilt_rad.sigma())));
  result.rows.emplace_back("distance", with_sigma(plane.distance_m));
  result.rows.emplace_back("rms", fmt::format("{:.3f} mm over {} points, {} left out",
                                              plane.rms_m * 1e3, plane.points, plane.left_out));
}

Result<MeasureResult> plane_result(const MeasureInput& input) {
  const auto plane =
      calibrate::measure_plane(input.cloud, first_crop(input), input.options, input.rig);
  if (!plane) return tl::unexpected(plane.error());
  MeasureResult result{{}, plane_json(*plane)};
  add_plane_rows(*plane, result);
  return result;
}

Result<MeasureResult> disc_result(const MeasureInput& input) {
  const auto disc =
      calibrate::measure_disc(input.cloud, first_crop(input), input.options, input.rig);
  if (!disc) return tl::unexpected(disc.error());
  MeasureResult result;
  result.object = {{"diameter_mm", measured_json(disc->diameter_m, 1e3)},
                   {"center_mm", vector_json(disc->centre_m, 1e3)},
                   {"center_sigma_mm", disc->centre_sigma_m * 1e3},
                   {"normal", vector_json(disc->plane.normal)},
                   {"plane_rms_mm", disc->plane.rms_m * 1e3},
                   {"points", disc->plane.points},
                   {"spot_mm", disc->spot_m * 1e3},
                   {"edge_shift_mm", disc->edge_shift_m * 1e3},
                   {"edge_beams", disc->edge_beams},
                   {"unbacked_share", disc->unbacked_share},
                   {"by_area", disc->by_area},
                   {"outermost_diameter_mm", disc->outermost_diameter_m * 1e3},
                   {"area_diameter_mm", disc->area_diameter_m * 1e3}};
  result.rows.emplace_back("diameter", with_sigma(disc->diameter_m));
  const Eigen::Vector3d c = disc->centre_m * 1e3;
  result.rows.emplace_back("centre",
                           fmt::format("({:.2f}, {:.2f}, {:.2f}) mm", c.x(), c.y(), c.z()));
  result.rows.emplace_back("plane", fmt::format("rms {:.3f} mm over {} points",
                                                disc->plane.rms_m * 1e3, disc->plane.points));
  if (disc->by_area) {
    result.rows.emplace_back("method", "by area: the cloud does not know its beams");
  } else {
    result.rows.emplace_back(
        "for comparison",
        fmt::format("circle through the outermost points {:.3f} mm, by area {:.3f} mm",
                    disc->outermost_diameter_m * 1e3, disc->area_diameter_m * 1e3));
  }
  return result;
}

Result<MeasureResult> distance_result(const MeasureInput& input) {
  if (input.crops.size() != 2) {
    return fail(Error::Code::kMalformed,
                "a distance needs two parts: give --crop twice, the plane first");
  }
  const auto distance = calibrate::measure_distance(input.cloud, input.crops[0], input.crops[1],
                                                    input.options, input.rig);
  if (!distance) return tl::unexpected(distance.error());
  MeasureResult result;
  result.object = {{"distance_mm", measured_json(distance->perpendicular_m, 1e3)},
                   {"centers_mm", measured_json(distance->centres_m, 1e3)},
                   {"from", plane_json(distance->from)}};
  result.rows.emplace_back("distance", with_sigma(distance->perpendicular_m));
  result.rows.emplace_back("between centres", with_sigma(distance->centres_m));
  return result;
}

Result<MeasureResult> size_result(const MeasureInput& input) {
  const auto size =
      calibrate::measure_size(input.cloud, first_crop(input), input.options, input.rig);
  if (!size) return tl::unexpected(size.error());
  MeasureResult result;
  result.object = {{"length_mm", measured_json(size->length_m, 1e3)},
                   {"width_mm", measured_json(size->width_m, 1e3)},
                   {"length_axis", vector_json(size->length_axis)},
                   {"plane", plane_json(size->plane)}};
  result.rows.emplace_back("length", with_sigma(size->length_m));
  result.rows.emplace_back("width", with_sigma(size->width_m));
  return result;
}

using MeasureKind = Result<MeasureResult> (*)(const MeasureInput&);

int run_measure(const MeasureArguments& arguments, const CommonOptions& common, MeasureKind kind) {
  const auto input = read_input(arguments);
  if (!input) return report_error(input.error());
  const auto result = kind(*input);
  if (!result) {
    return report_error({result.error().code, arguments.cloud + ": " + result.error().message});
  }
  if (arguments.json) {
    fmt::print("{}\n", result->object.dump(2));
  } else {
    fmt::print("{}\n", arguments.cloud);
    for (const auto& [name, value] : result->rows) fmt::print("  {:<18} {}\n", name, value);
  }
  return report_diagnostics(input->diagnostics, common.quiet);
}

void add_kind(CLI::App& measure, const Tool& tool, const std::string& name, const std::string& doc,
              const std::string& example, MeasureKind kind) {
  auto arguments = std::make_shared<MeasureArguments>();
  auto* app = measure.add_subcommand(name, doc);
  app->add_option("cloud", arguments->cloud, "Cloud: .ply or .pcd")->required();
  app->add_option("--crop", arguments->crops, "Only this part: X0,X1,Y0,Y1,Z0,Z1 in metres")
      ->allow_extra_args(false);
  app->add_option("--rig", arguments->rig,
                  "The rig that assembled the cloud; its uncertainty is carried over");
  app->add_option("--spot-mm", arguments->spot_mm, "Diameter of the laser's spot on the target")
      ->check(CLI::Range(0.0, 1000.0));
  app->add_option("--set", arguments->sets, "Change a setting: measure.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->footer("Settings (--set measure.NAME=VALUE):\n" +
              settings_help(view_options("measure", calibrate::MeasureOptions{})) +
              "Example:\n  scanfuse measure " + example + "\n");
  app->callback(
      [arguments, tool, kind] { *tool.exit_code = run_measure(*arguments, *tool.common, kind); });
}

}  // namespace

void add_measure(Tool& tool) {
  auto* app = tool.app->add_subcommand(
      "measure", "Measure a disc, plane, distance or size in a cloud, with its uncertainty");
  app->require_subcommand(1);
  add_kind(*app, tool, "disc", "Diameter, centre and plane of a round flat target",
           "disc cloud.ply --rig rig.toml", disc_result);
  add_kind(*app, tool, "plane", "Normal and distance of a plane",
           "plane cloud.ply --crop -0.1,0.1,-0.1,0.1,1,2", plane_result);
  add_kind(*app, tool, "distance", "From the plane of one part to another part",
           "distance cloud.ply --crop -1,0,-1,1,0,3 --crop 0,1,-1,1,0,3", distance_result);
  add_kind(*app, tool, "size", "Sides of a flat rectangle",
           "size cloud.ply --crop -0.1,0.1,-0.1,0.1,1,2", size_result);
}

}  // namespace scanfuse::app
