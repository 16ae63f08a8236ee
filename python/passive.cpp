#include "scanfuse/io/passive/passive.hpp"

#include "bind.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"
#include "scanfuse/triangulate/passive_tracker.hpp"

namespace scanfuse::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

/// Yaw, pitch, roll as `sensors.toml` has them.
Eigen::Quaterniond rotation_of(const Eigen::Vector3d& yaw_pitch_roll) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw_pitch_roll(0), Eigen::Vector3d::UnitZ()) *
                            Eigen::AngleAxisd(yaw_pitch_roll(1), Eigen::Vector3d::UnitY()) *
                            Eigen::AngleAxisd(yaw_pitch_roll(2), Eigen::Vector3d::UnitX()));
}

BearingScan scan_of(const Integers& sensor, const Doubles& azimuth_rad,
                    const std::optional<Doubles>& elevation_rad, std::int64_t scan,
                    double stamp_s) {
  const auto count = azimuth_rad.size();
  if (azimuth_rad.ndim() != 1 || sensor.ndim() != 1 || sensor.size() != count ||
      (elevation_rad && elevation_rad->size() != count)) {
    throw Failure({Error::Code::kMalformed,
                   "sensor, azimuth_rad and elevation_rad are arrays of one shape (N,)"});
  }
  BearingScan bearings;
  bearings.scan = scan;
  bearings.stamp = time_of(stamp_s);
  for (py::ssize_t k = 0; k < count; ++k) {
    Bearing bearing;
    bearing.sensor = sensor.data()[k];
    bearing.measurement = k;
    bearing.azimuth_rad = azimuth_rad.data()[k];
    bearing.elevation_rad = elevation_rad ? elevation_rad->data()[k] : 0;
    if (!(std::abs(bearing.azimuth_rad) <= 2 * kPi && std::abs(bearing.elevation_rad) <= kPi / 2)) {
      throw Failure({Error::Code::kOutOfRange,
                     fmt::format("bearing {}: azimuth {} or elevation {} is no angle in radians", k,
                                 bearing.azimuth_rad, bearing.elevation_rad)});
    }
    bearings.bearings.push_back(bearing);
  }
  return bearings;
}

void check_sensors(const BearingScan& scan, const PassiveScene& scene) {
  for (const auto& bearing : scan.bearings) {
    if (bearing.sensor < 0 || static_cast<std::size_t>(bearing.sensor) >= scene.sensors.size()) {
      throw Failure({Error::Code::kOutOfRange,
                     fmt::format("bearing {} is of sensor {}; the scene has {}",
                                 bearing.measurement, bearing.sensor, scene.sensors.size())});
    }
  }
}

void bind_scene(py::module_& module) {
  py::class_<PassiveSensor>(module, "PassiveSensor", "A sensor that tells directions, no ranges.")
      .def(py::init([](std::string name, const Eigen::Vector3d& position_m,
                       const Eigen::Vector3d& orientation_rad, double sigma_azimuth_rad,
                       std::optional<double> sigma_elevation_rad, double detection_probability,
                       double clutter_density) {
             PassiveSensor sensor;
             sensor.name = std::move(name);
             sensor.world_from_sensor = {rotation_of(orientation_rad), position_m};
             sensor.sigma_azimuth_rad = sigma_azimuth_rad;
             sensor.sigma_elevation_rad = sigma_elevation_rad;
             sensor.detection_probability = detection_probability;
             sensor.clutter_density = clutter_density;
             return sensor;
           }),
           py::arg("name"), py::arg("position_m"), py::kw_only(),
           py::arg("orientation_rad") = Eigen::Vector3d(0, 0, 0),
           py::arg("sigma_azimuth_rad") = 0.005, py::arg("sigma_elevation_rad") = py::none(),
           py::arg("detection_probability") = 0.9, py::arg("clutter_density") = 0.0,
           "`orientation_rad`: yaw, pitch, roll; without `sigma_elevation_rad` it tells azimuth "
           "only; `clutter_density`: false alarms per scan and steradian (azimuth only: radian).")
      .def_readonly("name", &PassiveSensor::name)
      .def_property_readonly("world_from_sensor", [](const PassiveSensor& sensor) {
        return matrix_of(sensor.world_from_sensor);
      });
  py::class_<PassiveScene>(module, "PassiveScene", "Sensors, and what is known of the scene.")
      .def(py::init([](std::vector<PassiveSensor> sensors,
                       const std::optional<PassiveScene::Volume>& volume_m,
                       std::optional<double> expected_targets) {
             if (sensors.size() < 2) {
               throw Failure({Error::Code::kMalformed,
                              "one sensor alone cannot locate: a scene has two or more"});
             }
             return PassiveScene{std::move(sensors), volume_m, expected_targets};
           }),
           py::arg("sensors"), py::arg("volume_m") = py::none(),
           py::arg("expected_targets") = py::none(),
           "`volume_m`: [[x0, x1], [y0, y1], [z0, z1]]; what is left out is estimated.")
      .def_readonly("sensors", &PassiveScene::sensors);
  py::class_<BearingScan>(module, "BearingScan", "What all sensors saw at one time.")
      .def(py::init(&scan_of), py::arg("sensor"), py::arg("azimuth_rad"),
           py::arg("elevation_rad") = py::none(), py::kw_only(), py::arg("scan") = 0,
           py::arg("stamp_s") = 0.0,
           "Arrays of one value a bearing; `sensor` is the place in PassiveScene.sensors.")
      .def_readonly("scan", &BearingScan::scan)
      .def_property_readonly("stamp_s", [](const BearingScan& s) { return to_seconds(s.stamp); })
      .def("__len__", [](const BearingScan& s) { return s.bearings.size(); });
  module.def(
      "read_sensors",
      [](const std::filesystem::path& path) { return value_or_throw(io::read_sensors(path)); },
      py::arg("path"), "A PassiveScene from sensors.toml.");
  module.def(
      "read_bearings",
      [](const std::filesystem::path& path, const PassiveScene& scene) {
        return value_or_throw(io::read_bearings(path, scene));
      },
      py::arg("path"), py::arg("scene"), "BearingScans from a CSV.");
}

void bind_association(py::module_& module) {
  using triangulate::ScanAssociation;
  bind_options<triangulate::AssociationOptions>(module, "AssociationOptions",
                                                "Which bearings belong together.");
  py::class_<Fix>(module, "Fix", "Where the bearings of one target meet.")
      .def_readonly("target", &Fix::target)
      .def_readonly("position_m", &Fix::position_m)
      .def_readonly("covariance_m2", &Fix::covariance_m2)
      .def_readonly("chi2", &Fix::chi2)
      .def_readonly("degrees_of_freedom", &Fix::degrees_of_freedom)
      .def_readonly("existence_probability", &Fix::existence_probability)
      .def_readonly("bearings", &Fix::bearings, "places in the scan");
  py::class_<ScanAssociation>(module, "Association", "A scan's bearings, given to targets.")
      .def_readonly("fixes", &ScanAssociation::fixes)
      .def_property_readonly(
          "target_of_bearing",
          [](const ScanAssociation& a) { return array_of(a.target_of_bearing); },
          "Fix.target of each bearing, -1 for clutter; int64 of shape (N,)")
      .def_property_readonly(
          "probability_of_bearing",
          [](const ScanAssociation& a) { return array_of(a.probability_of_bearing); })
      .def_property_readonly("primal", [](const ScanAssociation& a) { return a.solution.primal; })
      .def_readonly("dual", &ScanAssociation::dual, "no other association weighs more")
      .def_property_readonly("gap", &ScanAssociation::gap)
      .def_readonly("proved", &ScanAssociation::proved);
  module.def(
      "associate",
      [](const BearingScan& scan, const PassiveScene& scene,
         const triangulate::AssociationOptions& options, int threads) {
        check_sensors(scan, scene);
        return value_or_throw(triangulate::associate_scan(scan, scene, options, threads));
      },
      py::arg("scan"), py::arg("scene"), py::arg("options") = triangulate::AssociationOptions{},
      py::arg("threads") = 1, py::call_guard<py::gil_scoped_release>(),
      "Which bearings of a scan belong to one target, where it is, and how good that answer is.");
}

void bind_tracker(py::module_& module) {
  using triangulate::PassiveTrack;
  using triangulate::PassiveTracker;
  using triangulate::PassiveTrackOptions;
  bind_options<PassiveTrackOptions>(module, "PassiveTrackOptions", "Tracks from bearings.");
  py::class_<PassiveTrack>(module, "PassiveTrack", "A target over time, as it is after a scan.")
      .def_readonly("id", &PassiveTrack::id)
      .def_property_readonly(
          "state", [](const PassiveTrack& t) { return t.state.mean; },
          "x, y, z, vx, vy, vz (m, m/s), world frame")
      .def_property_readonly("covariance", [](const PassiveTrack& t) { return t.state.covariance; })
      .def_readonly("confirmed", &PassiveTrack::confirmed)
      .def_readonly("missed_scans", &PassiveTrack::missed_scans)
      .def_readonly("bearings", &PassiveTrack::bearings)
      .def_property_readonly("existence_probability", &PassiveTrack::existence_probability);
  py::class_<PassiveTracker>(module, "PassiveTracker",
                             "Follows targets by bearings, scan after scan.")
      .def(py::init([](PassiveScene scene, const PassiveTrackOptions& options) {
             return PassiveTracker(std::move(scene), options);
           }),
           py::arg("scene"), py::arg("options") = PassiveTrackOptions{})
      .def(
          "step",
          [](PassiveTracker& tracker, const BearingScan& scan, int threads) {
            return value_or_throw(tracker.step(scan, threads)).tracks;
          },
          py::arg("scan"), py::arg("threads") = 1, py::call_guard<py::gil_scoped_release>(),
          "The tracks after this scan, tentative ones too.");
}

}  // namespace

void bind_passive(py::module_& module) {
  bind_scene(module);
  bind_association(module);
  bind_tracker(module);
}

}  // namespace scanfuse::python
