#include "bind.hpp"
#include "scanfuse/core/assignment.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::python {
namespace {

void bind_evaluate(py::module_& module) {
  bind_options<evaluate::EvaluateOptions>(module, "EvaluateOptions", "How tracks are scored.");
  module.def(
      "evaluate",
      [](const std::vector<StepResult>& results, const std::vector<TruthFrame>& truth,
         const evaluate::EvaluateOptions& options) {
        std::string json;
        {
          const py::gil_scoped_release release;
          json = to_json(evaluate::evaluate(results, truth, options));
        }
        return py::module_::import("json").attr("loads")(json);
      },
      py::arg("results"), py::arg("truth"), py::arg("options") = evaluate::EvaluateOptions{},
      "CLEAR-MOT, identity, HOTA, GOSPA, errors and consistency, with the keys of `scanfuse "
      "evaluate --json`; what cannot be computed is None.");
  module.def(
      "assign",
      [](const Eigen::Ref<const Eigen::MatrixXd>& cost) {
        AssignmentSolver solve;
        const auto columns = solve(cost);
        return array_of(std::vector<std::int32_t>(columns.begin(), columns.end()));
      },
      py::arg("cost"),
      "The cheapest assignment of rows to columns: the column of each row, -1 for none; infinity "
      "forbids a pair.");
}

void bind_simulate(py::module_& module) {
  using simulate::SimulatedFrame;
  using simulate::Simulation;
  bind_options<simulate::SimulateOptions>(module, "SimulateOptions", "The lidar and its noise.");
  py::class_<SimulatedFrame>(module, "SimulatedFrame", "A simulated scan with its truth.")
      .def_readonly("scan", &SimulatedFrame::scan)
      .def_readonly("truth", &SimulatedFrame::truth)
      .def_property_readonly("world_from_ego",
                             [](const SimulatedFrame& f) { return matrix_of(f.ego.pose); })
      .def_property_readonly(
          "label",
          [](const py::object& self) {
            return view_of(self.cast<const SimulatedFrame&>().label, self);
          },
          "What each return came from: the id of the object, 0 background, -1 ground, -2 mixed; "
          "int32 of shape (N,), sharing memory.");
  py::class_<Simulation>(module, "Simulation",
                         "A scenario as an iterator of SimulatedFrame; the same seed gives the "
                         "same bytes.")
      .def(py::init([](const std::string& scenario, std::uint64_t seed,
                       const simulate::SimulateOptions& options) {
             return value_or_throw(Simulation::create(scenario, seed, options));
           }),
           py::arg("scenario"), py::arg("seed") = 1,
           py::arg("options") = simulate::SimulateOptions{})
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__len__", &Simulation::frames)
      .def("__next__",
           [](Simulation& simulation) {
             std::optional<SimulatedFrame> frame;
             {
               const py::gil_scoped_release release;
               frame = simulation.next();
             }
             if (!frame) throw py::stop_iteration();
             return std::move(*frame);
           })
      .def_property_readonly(
          "ego_from_sensor",
          [](const Simulation& simulation) { return matrix_of(simulation.ego_from_sensor()); })
      .def(
          "posed",
          [](const Simulation& simulation, const SimulatedFrame& frame) {
            pipeline::PosedScan posed;
            posed.scan = frame.scan;
            posed.world_from_ego = frame.ego.pose;
            posed.ego_from_sensor = simulation.ego_from_sensor();
            posed.twist.speed_m_per_s = frame.ego.speed_m_per_s.value_or(0);
            posed.twist.yaw_rate_rad_per_s = frame.ego.yaw_rate_rad_per_s.value_or(0);
            return posed;
          },
          py::arg("frame"), "What a Pipeline takes.");
  module.def(
      "scenarios",
      [] {
        py::dict names;
        for (const auto& info : simulate::scenarios()) {
          names[py::str(std::string(info.name))] = std::string(info.doc);
        }
        return names;
      },
      "Name and description of every scenario.");
}

}  // namespace

void bind_scoring(py::module_& module) {
  bind_evaluate(module);
  bind_simulate(module);
}

}  // namespace scanfuse::python
