#include "bind.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// One value a point into the member that `set` writes.
template <class Array, class Set>
void fill(std::vector<Return>& returns, const std::optional<Array>& values, const char* name,
          Set&& set) {
  if (!values) return;
  if (values->ndim() != 1 || static_cast<std::size_t>(values->size()) != returns.size()) {
    throw Failure({Error::Code::kMalformed, fmt::format("{}: {} values for {} points", name,
                                                        values->size(), returns.size())});
  }
  const auto numbers = values->template unchecked<1>();
  for (py::ssize_t k = 0; k < numbers.shape(0); ++k)
    set(returns[static_cast<std::size_t>(k)], numbers(k));
}

Scan scan_of_points(const Floats& xyz, double stamp_s, std::int64_t frame,
                    const std::string& sensor, const std::optional<Floats>& intensity,
                    const std::optional<Integers>& layer, const std::optional<Integers>& beam,
                    const std::optional<Floats>& time_offset_s) {
  if (xyz.ndim() != 2 || xyz.shape(1) < 2 || xyz.shape(1) > 3) {
    throw Failure({Error::Code::kMalformed, "points are an array of shape (N, 2) or (N, 3)"});
  }
  Scan scan;
  scan.stamp = time_of(stamp_s);
  scan.frame = frame;
  scan.sensor = sensor;
  scan.returns.resize(static_cast<std::size_t>(xyz.shape(0)));
  const auto p = xyz.unchecked<2>();
  for (py::ssize_t k = 0; k < p.shape(0); ++k) {
    auto& r = scan.returns[static_cast<std::size_t>(k)];
    r.x_m = p(k, 0);
    r.y_m = p(k, 1);
    r.z_m = p.shape(1) == 3 ? p(k, 2) : 0;
  }
  fill(scan.returns, intensity, "intensity", [](Return& r, float v) { r.intensity = v; });
  fill(scan.returns, layer, "layer",
       [](Return& r, std::int64_t v) { r.layer = static_cast<std::int16_t>(v); });
  fill(scan.returns, beam, "beam",
       [](Return& r, std::int64_t v) { r.beam = static_cast<std::int32_t>(v); });
  fill(scan.returns, time_offset_s, "time_offset_s",
       [](Return& r, float v) { r.time_offset_s = v; });
  std::erase_if(scan.returns, [](const Return& r) {
    return !(std::isfinite(r.x_m) && std::isfinite(r.y_m) && std::isfinite(r.z_m));
  });
  return scan;
}

Scan scan_of_ranges(const Floats& ranges, double angle_min_rad, double angle_increment_rad,
                    double stamp_s, std::int64_t frame, const std::string& sensor,
                    double range_min_m, double range_max_m, double time_increment_s,
                    const std::optional<Floats>& intensity) {
  if (ranges.ndim() != 1 || ranges.size() == 0) {
    throw Failure({Error::Code::kMalformed, "ranges are an array of shape (N,), one a beam"});
  }
  if (!(std::abs(angle_increment_rad) > 1e-9) || !std::isfinite(angle_min_rad)) {
    throw Failure(
        {Error::Code::kOutOfRange, "angle_min_rad must be finite and angle_increment_rad not 0"});
  }
  if (intensity && intensity->size() != ranges.size()) {
    throw Failure({Error::Code::kMalformed, fmt::format("intensity: {} values for {} beams",
                                                        intensity->size(), ranges.size())});
  }
  Scan scan;
  scan.stamp = time_of(stamp_s);
  scan.frame = frame;
  scan.sensor = sensor;
  const int columns = static_cast<int>(ranges.size());
  const bool clockwise = angle_increment_rad < 0;
  scan.beams =
      BeamPattern{clockwise ? angle_min_rad + (columns - 1) * angle_increment_rad : angle_min_rad,
                  std::abs(angle_increment_rad),
                  columns,
                  1,
                  range_min_m,
                  range_max_m};
  for (int k = 0; k < columns; ++k) {
    const float range = ranges.data()[k];
    if (!(range >= range_min_m && range <= range_max_m)) continue;
    const double angle = angle_min_rad + k * angle_increment_rad;
    Return r;
    r.x_m = static_cast<float>(range * std::cos(angle));
    r.y_m = static_cast<float>(range * std::sin(angle));
    r.beam = clockwise ? columns - 1 - k : k;
    r.time_offset_s = static_cast<float>(k * time_increment_s);
    if (intensity) r.intensity = intensity->data()[k];
    scan.returns.push_back(r);
  }
  return scan;
}

void bind_scan(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Return, x_m, y_m, z_m, intensity, time_offset_s, beam, layer, echo);
  py::class_<Scan>(module, "Scan",
                   "One sweep of one sensor, in the sensor's frame: x forward, y left, z up; m.\n\n"
                   "Points that are not finite are dropped.")
      .def(py::init(&scan_of_points), py::arg("points"), py::kw_only(), py::arg("stamp_s") = 0.0,
           py::arg("frame") = 0, py::arg("sensor") = "", py::arg("intensity") = py::none(),
           py::arg("layer") = py::none(), py::arg("beam") = py::none(),
           py::arg("time_offset_s") = py::none(),
           "From points of shape (N, 2) or (N, 3); the other arrays have one value a point.")
      .def_static("from_ranges", &scan_of_ranges, py::arg("ranges_m"), py::kw_only(),
                  py::arg("angle_min_rad"), py::arg("angle_increment_rad"),
                  py::arg("stamp_s") = 0.0, py::arg("frame") = 0, py::arg("sensor") = "",
                  py::arg("range_min_m") = 0.01, py::arg("range_max_m") = 1e4,
                  py::arg("time_increment_s") = 0.0, py::arg("intensity") = py::none(),
                  "From the ranges of a planar lidar, one a beam, as in a LaserScan message; NaN, "
                  "inf and what lies outside the limits is no return.")
      .def_property_readonly(
          "returns",
          [](const py::object& self) { return view_of(self.cast<const Scan&>().returns, self); },
          "All that is known of each return: a structured array that shares the scan's memory.")
      .def_property_readonly(
          "xyz",
          [](const py::object& self) {
            const auto& returns = self.cast<const Scan&>().returns;
            return column_of(returns, returns.empty() ? nullptr : &returns[0].x_m, self, 3);
          },
          "Points, float32 of shape (N, 3), sharing the scan's memory.")
      .def_property_readonly("stamp_s", [](const Scan& scan) { return to_seconds(scan.stamp); })
      .def_property_readonly(
          "stamp_ns", [](const Scan& scan) { return to_nanos(scan.stamp); },
          "Nanoseconds since 1970, exact.")
      .def_readwrite("frame", &Scan::frame)
      .def_readwrite("sensor", &Scan::sensor)
      .def_readwrite("frame_id", &Scan::frame_id)
      .def("__len__", [](const Scan& scan) { return scan.returns.size(); })
      .def("__repr__", [](const Scan& scan) {
        return fmt::format("<scanfuse.Scan frame {} of '{}', {} returns, {:.6f} s>", scan.frame,
                           scan.sensor, scan.returns.size(), to_seconds(scan.stamp));
      });
}

void bind_posed_scan(py::module_& module) {
  using pipeline::PosedScan;
  py::class_<PosedScan>(module, "PosedScan", "A scan and where it was taken.")
      .def(py::init([](Scan scan, const std::optional<Eigen::Matrix4d>& world_from_ego,
                       const std::optional<Eigen::Matrix4d>& ego_from_sensor, double speed_m_per_s,
                       double yaw_rate_rad_per_s) {
             PosedScan posed;
             posed.scan = std::move(scan);
             if (world_from_ego) posed.world_from_ego = pose_of(*world_from_ego);
             if (ego_from_sensor) posed.ego_from_sensor = pose_of(*ego_from_sensor);
             posed.twist.speed_m_per_s = speed_m_per_s;
             posed.twist.yaw_rate_rad_per_s = yaw_rate_rad_per_s;
             return posed;
           }),
           py::arg("scan"), py::kw_only(), py::arg("world_from_ego") = py::none(),
           py::arg("ego_from_sensor") = py::none(), py::arg("speed_m_per_s") = 0.0,
           py::arg("yaw_rate_rad_per_s") = 0.0, "Poses are 4 x 4 matrices; none: the identity.")
      .def_readonly("scan", &PosedScan::scan)
      .def_property_readonly("world_from_ego",
                             [](const PosedScan& posed) { return matrix_of(posed.world_from_ego); })
      .def_property_readonly("ego_from_sensor", [](const PosedScan& posed) {
        return matrix_of(posed.ego_from_sensor);
      });
}

}  // namespace

void bind_data(py::module_& module) {
  bind_scan(module);
  bind_posed_scan(module);
  PYBIND11_NUMPY_DTYPE(PlanarPoint, x_m, y_m, z_m, range_m, bearing_rad, time_offset_s, column,
                       source, support, z_low_m, z_high_m, depth_m);
  py::class_<VirtualScan>(module, "VirtualScan",
                          "A sweep flattened to one point a bearing, in order of bearing; levelled "
                          "sensor frame.")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            return view_of(self.cast<const VirtualScan&>().points, self);
          },
          "A structured array that shares memory; `source` is an index into the scan's returns.")
      .def_property_readonly(
          "xy",
          [](const py::object& self) {
            const auto& points = self.cast<const VirtualScan&>().points;
            return column_of(points, points.empty() ? nullptr : &points[0].x_m, self, 2);
          },
          "float32 of shape (N, 2), sharing memory.")
      .def_readonly("step_rad", &VirtualScan::step_rad)
      .def_readonly("full_circle", &VirtualScan::full_circle)
      .def("__len__", [](const VirtualScan& scan) { return scan.points.size(); });
}

}  // namespace scanfuse::python
