#include "bind.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::python {
namespace {

/// A class by its name; an unknown one is an error that lists the known ones.
ObjectClass class_of(const std::string& name) {
  return value_or_throw(detail::parse<ObjectClass>(name));
}

py::dict probabilities_of(const ClassProbabilities& probabilities) {
  py::dict dict;
  for (const auto& [name, choice] : choices(ObjectClass{})) {
    dict[name] = probabilities[static_cast<std::size_t>(choice)];
  }
  return dict;
}

void bind_box(py::module_& module) {
  py::class_<Box2>(module, "Box", "A rectangle in the plane; the heading is that of its long axis.")
      .def(
          py::init([](double x_m, double y_m, double heading_rad, double length_m, double width_m) {
            return Box2{{x_m, y_m}, heading_rad, length_m, width_m};
          }),
          py::arg("x_m") = 0.0, py::arg("y_m") = 0.0, py::arg("heading_rad") = 0.0,
          py::arg("length_m") = 0.0, py::arg("width_m") = 0.0)
      .def_readwrite("centre_m", &Box2::centre_m)
      .def_readwrite("heading_rad", &Box2::heading_rad)
      .def_readwrite("length_m", &Box2::length_m)
      .def_readwrite("width_m", &Box2::width_m)
      .def_property_readonly(
          "corners_m",
          [](const Box2& box) {
            Eigen::Matrix<double, 4, 2> corners;
            for (int k = 0; k < 4; ++k) corners.row(k) = box.corners()[static_cast<std::size_t>(k)];
            return corners;
          },
          "Front left, rear left, rear right, front right; shape (4, 2).");
}

void bind_detection(py::module_& module) {
  py::class_<Detection>(module, "Detection",
                        "One object seen in one scan. Give a Tracker your own, in a frame that "
                        "does not move.")
      .def(py::init([](const Box2& box, const std::string& object_class, double score,
                       const std::optional<Eigen::Matrix3d>& covariance) {
             Detection detection;
             detection.box = box;
             detection.object_class = class_of(object_class);
             detection.score = score;
             detection.covariance = covariance.value_or(
                 Eigen::Vector3d(0.09, 0.09, 0.04).asDiagonal().toDenseMatrix());
             return detection;
           }),
           py::arg("box"), py::arg("object_class") = "vehicle", py::arg("score") = 1.0,
           py::arg("covariance") = py::none(),
           "`covariance`: of x, y (m) and heading (rad); none: 0.3 m and 0.2 rad.")
      .def_readwrite("box", &Detection::box)
      .def_property(
          "object_class", [](const Detection& d) { return std::string(to_string(d.object_class)); },
          [](Detection& d, const std::string& name) { d.object_class = class_of(name); })
      .def_property_readonly(
          "class_probability",
          [](const Detection& d) { return probabilities_of(d.class_probability); },
          "By class, adding up to 1; all 0: the recogniser tells none.")
      .def_readwrite("score", &Detection::score)
      .def_readwrite("covariance", &Detection::covariance)
      .def_readwrite("var_length_m2", &Detection::var_length_m2)
      .def_readwrite("var_width_m2", &Detection::var_width_m2)
      .def_readwrite("length_seen", &Detection::length_seen)
      .def_readwrite("width_seen", &Detection::width_seen)
      .def_readwrite("z_m", &Detection::z_m)
      .def_readwrite("height_m", &Detection::height_m)
      .def_readwrite("points", &Detection::points)
      .def_readwrite("seen_from_m", &Detection::seen_from_m, "The sensor, in the same frame.")
      .def("__repr__", [](const Detection& d) {
        return fmt::format("<scanfuse.Detection {} at ({:.2f}, {:.2f}) m, score {:.2f}>",
                           to_string(d.object_class), d.box.centre_m.x(), d.box.centre_m.y(),
                           d.score);
      });
}

void bind_track(py::module_& module) {
  py::class_<Track>(module, "Track", "What is known of one object after one scan.")
      .def_readonly("id", &Track::id)
      .def_property_readonly("object_class",
                             [](const Track& t) { return std::string(to_string(t.object_class)); })
      .def_readonly("class_probability", &Track::class_probability)
      .def_property_readonly(
          "status", [](const Track& t) { return detail::print(t.status); },
          "tentative, confirmed or coasting")
      .def_readonly("box", &Track::box)
      .def_readonly("z_m", &Track::z_m)
      .def_readonly("height_m", &Track::height_m)
      .def_property_readonly(
          "position_m",
          [](const Track& t) { return Eigen::Vector2d(t.state.mean(0), t.state.mean(2)); })
      .def_property_readonly(
          "velocity_m_per_s",
          [](const Track& t) { return Eigen::Vector2d(t.state.mean(1), t.state.mean(3)); })
      .def_property_readonly(
          "state", [](const Track& t) { return t.state.mean; },
          "x, vx, y, vy (m, m/s), over ground: the order of [Lu2018]")
      .def_property_readonly(
          "covariance", [](const Track& t) { return t.state.covariance; },
          "of `state`, shape (4, 4)")
      .def_readonly("speed_m_per_s", &Track::speed_m_per_s)
      .def_readonly("moving_probability", &Track::moving_probability)
      .def_readonly("accel_m_per_s2", &Track::accel_m_per_s2)
      .def_readonly("yaw_rate_rad_per_s", &Track::yaw_rate_rad_per_s)
      .def_readonly("age_frames", &Track::age_frames)
      .def_readonly("missed_frames", &Track::missed_frames)
      .def_readonly("detection", &Track::detection,
                    "index of the detection folded in at this scan, -1 when none")
      .def_readonly("nis", &Track::nis, "of that detection; 2 degrees of freedom")
      .def("__repr__", [](const Track& t) {
        return fmt::format("<scanfuse.Track {} {} {} at ({:.2f}, {:.2f}) m, {:.1f} m/s>", t.id,
                           detail::print(t.status), to_string(t.object_class), t.box.centre_m.x(),
                           t.box.centre_m.y(), t.speed_m_per_s);
      });
}

void bind_step(py::module_& module) {
  py::class_<StepResult>(module, "StepResult", "Everything that one scan gave.")
      .def_property_readonly("stamp_s", [](const StepResult& r) { return to_seconds(r.stamp); })
      .def_property_readonly("stamp_ns", [](const StepResult& r) { return to_nanos(r.stamp); })
      .def_readonly("frame", &StepResult::frame)
      .def_readonly("sensor", &StepResult::sensor)
      .def_readonly("coordinate_frame", &StepResult::coordinate_frame, "world or ego")
      .def_property_readonly("world_from_ego",
                             [](const StepResult& r) { return matrix_of(r.world_from_ego); })
      .def_readonly("detections", &StepResult::detections)
      .def_readonly("tracks", &StepResult::tracks)
      .def("__repr__", [](const StepResult& r) {
        return fmt::format("<scanfuse.StepResult frame {}, {} detections, {} tracks>", r.frame,
                           r.detections.size(), r.tracks.size());
      });
}

void bind_truth(py::module_& module) {
  py::class_<TruthObject>(module, "TruthObject", "Where an object really was.")
      .def(py::init([](std::int64_t id, const std::string& object_class,
                       const Eigen::Vector2d& position_m, std::optional<double> heading_rad,
                       std::optional<double> length_m, std::optional<double> width_m) {
             TruthObject object;
             object.id = id;
             object.object_class = class_of(object_class);
             object.position_m = position_m;
             object.heading_rad = heading_rad;
             object.length_m = length_m;
             object.width_m = width_m;
             return object;
           }),
           py::arg("id"), py::arg("object_class"), py::arg("position_m"),
           py::arg("heading_rad") = py::none(), py::arg("length_m") = py::none(),
           py::arg("width_m") = py::none())
      .def_readwrite("id", &TruthObject::id)
      .def_property_readonly(
          "object_class",
          [](const TruthObject& o) { return std::string(to_string(o.object_class)); })
      .def_readwrite("position_m", &TruthObject::position_m)
      .def_readwrite("heading_rad", &TruthObject::heading_rad)
      .def_readwrite("velocity_m_per_s", &TruthObject::velocity_m_per_s)
      .def_readwrite("length_m", &TruthObject::length_m)
      .def_readwrite("width_m", &TruthObject::width_m)
      .def_readwrite("visible_points", &TruthObject::visible_points)
      .def_readwrite("occluded", &TruthObject::occluded);
  py::class_<TruthFrame>(module, "TruthFrame", "What was really there at one scan.")
      .def(py::init([](std::int64_t frame, double stamp_s, std::vector<TruthObject> objects,
                       std::string coordinate_frame) {
             TruthFrame truth;
             truth.frame = frame;
             truth.stamp = time_of(stamp_s);
             truth.objects = std::move(objects);
             truth.coordinate_frame = std::move(coordinate_frame);
             return truth;
           }),
           py::arg("frame"), py::arg("stamp_s"), py::arg("objects"),
           py::arg("coordinate_frame") = "world")
      .def_readonly("frame", &TruthFrame::frame)
      .def_property_readonly("stamp_s", [](const TruthFrame& f) { return to_seconds(f.stamp); })
      .def_readonly("coordinate_frame", &TruthFrame::coordinate_frame)
      .def_readonly("objects", &TruthFrame::objects);
}

}  // namespace

void bind_results(py::module_& module) {
  bind_box(module);
  bind_detection(module);
  bind_track(module);
  bind_step(module);
  bind_truth(module);
}

}  // namespace scanfuse::python
