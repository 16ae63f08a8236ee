#include "scanfuse/calibrate/turntable.hpp"

#include "bind.hpp"
#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/calibrate/cloud/measure.hpp"
#include "scanfuse/io/cloud/cloud_file.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/session_folder.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"

namespace scanfuse::python {
namespace {

using calibrate::Measured;
using calibrate::TurntableCalibration;
using Path = std::filesystem::path;
using Box = std::optional<Eigen::Matrix<double, 2, 3>>;

calibrate::CropBox crop_of(const Box& box) {
  if (!box) return {};
  return {box->row(0).transpose(), box->row(1).transpose()};
}

void bind_rig(py::module_& module) {
  py::class_<Rig>(module, "Rig", "A 2D lidar on a turntable; camera frame, metres, radians.")
      .def_readonly("axis_direction", &Rig::axis_direction)
      .def_readonly("axis_point_m", &Rig::axis_point_m, "the point nearest to the camera")
      .def_readonly("range_bias_m", &Rig::range_bias_m)
      .def_readonly("angle_scale", &Rig::angle_scale)
      .def_readonly("covariance", &Rig::covariance, "of 12 small changes, shape (12, 12)")
      .def(
          "pose", [](const Rig& rig, double angle) { return matrix_of(rig.pose(angle)); },
          py::arg("turntable_rad"), "camera_from_lidar at an angle of the turntable, 4 x 4.")
      .def(
          "write",
          [](const Rig& rig, const Path& path) {
            value_or_throw(io::write_rig(path, {rig, std::nullopt}));
          },
          py::arg("path"));
  module.def(
      "read_rig", [](const Path& path) { return value_or_throw(io::read_rig(path)).rig; },
      py::arg("path"), "From rig.toml.");
}

void bind_calibration(py::module_& module) {
  bind_options<calibrate::TurntableOptions>(module, "TurntableOptions", "How a rig is estimated.");
  py::class_<TurntableCalibration>(module, "TurntableCalibration", "A rig and how well it fits.")
      .def_readonly("rig", &TurntableCalibration::rig)
      .def_readonly("positions_used", &TurntableCalibration::positions_used)
      .def_property_readonly(
          "positions_left_out",
          [](const TurntableCalibration& c) {
            py::dict reasons;
            for (const auto& position : c.positions) {
              if (!position.used) reasons[py::str(position.name)] = position.reason;
            }
            return reasons;
          },
          "name: reason")
      .def_property_readonly("rms",
                             [](const TurntableCalibration& c) {
                               return py::dict(py::arg("corner_px") = c.rms.corner_px,
                                               py::arg("stripe_px") = c.rms.stripe_px,
                                               py::arg("lidar_mm") = c.rms.lidar_mm);
                             })
      .def_readonly("chi2_per_dof", &TurntableCalibration::chi2_per_dof)
      .def_readonly("covariance_hessian", &TurntableCalibration::covariance_hessian)
      .def_readonly("covariance_jackknife", &TurntableCalibration::covariance_jackknife)
      .def_readonly("warnings", &TurntableCalibration::warnings)
      .def_readonly("converged", &TurntableCalibration::converged);
  module.def(
      "calibrate_turntable",
      [](const Path& session, const calibrate::TurntableOptions& options, int threads) {
        pipeline::SessionLoadOptions load;
        load.threads = threads;
        const auto loaded = value_or_throw(pipeline::load_turntable_session(session, load));
        return value_or_throw(calibrate::calibrate_turntable(loaded.features, options));
      },
      py::arg("session"), py::arg("options") = calibrate::TurntableOptions{},
      py::arg("threads") = 0, py::call_guard<py::gil_scoped_release>(),
      "The rig from a session's folder (docs/turntable-session.md).");
}

void bind_cloud(py::module_& module) {
  py::class_<Cloud>(module, "Cloud", "Points assembled from the scans of a rig.")
      .def_property_readonly(
          "xyz",
          [](const py::object& self) {
            const auto& points = self.cast<const Cloud&>().points;
            const double* first = points.empty() ? nullptr : points[0].position_m.data();
            return column_of(points, first, self, 3);
          },
          "metres, float64 of shape (N, 3), sharing the cloud's memory")
      .def_property_readonly(
          "intensity",
          [](const py::object& self) {
            const auto& points = self.cast<const Cloud&>().points;
            return column_of(points, points.empty() ? nullptr : &points[0].intensity, self);
          },
          "float64 of shape (N,); NaN where there is none")
      .def_property_readonly(
          "frame", [](const Cloud& cloud) { return detail::print(cloud.frame); },
          "camera, axis or unknown")
      .def("__len__", [](const Cloud& cloud) { return cloud.points.size(); })
      .def(
          "write",
          [](const Cloud& cloud, const Path& path) {
            value_or_throw(io::write_cloud(path, cloud));
          },
          py::arg("path"), "To .ply or .pcd.");
  module.def(
      "read_cloud",
      [](const Path& path) {
        Diagnostics diagnostics;
        return value_or_throw(io::read_cloud(path, diagnostics));
      },
      py::arg("path"), "From a PLY or PCD file.");
  module.def(
      "assemble",
      [](const Path& session, const Rig& rig, const std::string& frame, bool keep_mixed) {
        const auto folder = value_or_throw(io::open_session(session));
        const auto content = value_or_throw(io::read_session_content(folder));
        calibrate::AssembleOptions options;
        options.frame = value_or_throw(detail::parse<CloudFrame>(frame));
        options.keep_mixed = keep_mixed;
        return value_or_throw(calibrate::assemble(content.features.positions, rig, options)).cloud;
      },
      py::arg("session"), py::arg("rig"), py::arg("frame") = "camera",
      py::arg("keep_mixed") = false, py::call_guard<py::gil_scoped_release>(),
      "The scans of a session as one cloud, in the frame of the camera or of the axis.");
}

void bind_measures(py::module_& module) {
  bind_options<calibrate::MeasureOptions>(module, "MeasureOptions", "How a cloud is measured.");
  py::class_<Measured>(module, "Measured", "A value with its standard deviation.")
      .def_readonly("value", &Measured::value)
      .def_property_readonly("sigma", &Measured::sigma)
      .def_readonly("sigma_points", &Measured::sigma_points, "from the scatter of the points")
      .def_readonly("sigma_rig", &Measured::sigma_rig, "from the calibration")
      .def("__float__", [](const Measured& m) { return m.value; })
      .def("__repr__", [](const Measured& m) {
        return fmt::format("<scanfuse.Measured {:.6g} +- {:.2g}>", m.value, m.sigma());
      });
  module.def(
      "measure_plane",
      [](const Cloud& cloud, const Box& box, const std::optional<Rig>& rig,
         const calibrate::MeasureOptions& options) {
        const auto plane =
            value_or_throw(calibrate::measure_plane(cloud, crop_of(box), options, rig));
        return py::dict(py::arg("normal") = plane.normal, py::arg("centre_m") = plane.centre_m,
                        py::arg("distance_m") = plane.distance_m, py::arg("rms_m") = plane.rms_m,
                        py::arg("points") = plane.points);
      },
      py::arg("cloud"), py::arg("box") = py::none(), py::arg("rig") = py::none(),
      py::arg("options") = calibrate::MeasureOptions{},
      "`box`: [[x0, y0, z0], [x1, y1, z1]] in the cloud's frame; `rig`: for its part of the "
      "error.");
  module.def(
      "measure_disc",
      [](const Cloud& cloud, const Box& box, const std::optional<Rig>& rig,
         const calibrate::MeasureOptions& options) {
        const auto disc =
            value_or_throw(calibrate::measure_disc(cloud, crop_of(box), options, rig));
        return py::dict(py::arg("diameter_m") = disc.diameter_m,
                        py::arg("centre_m") = disc.centre_m, py::arg("normal") = disc.plane.normal,
                        py::arg("edge_beams") = disc.edge_beams);
      },
      py::arg("cloud"), py::arg("box") = py::none(), py::arg("rig") = py::none(),
      py::arg("options") = calibrate::MeasureOptions{}, "A round flat target.");
}

}  // namespace

void bind_turntable(py::module_& module) {
  bind_rig(module);
  bind_calibration(module);
  bind_cloud(module);
  bind_measures(module);
}

}  // namespace scanfuse::python
