#include "bind.hpp"
#include "scanfuse/pipeline/classes.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/pipeline/perception.hpp"

namespace scanfuse::python {
namespace {

using pipeline::PerceptionOptions;

/// A section of a configuration as an attribute: `options.track`.
template <class Part>
void add_section(py::class_<PerceptionOptions>& options, const char* name,
                 Part& (*part)(PerceptionOptions&)) {
  options.def_property_readonly(name, part, py::return_value_policy::reference_internal);
}

void bind_sections(py::module_& module) {
  bind_options<pipeline::PipelineOptions>(module, "PipelineOptions", "The chain as a whole.");
  bind_options<preprocess::PreprocessOptions>(module, "PreprocessOptions",
                                              "From a scan to one point a bearing.");
  bind_options<segment::SegmentOptions>(module, "SegmentOptions", "How a scan is cut.");
  bind_options<segment::PagOptions>(module, "PagOptions", "Polar adaptive grid.");
  bind_options<segment::PagLiteralOptions>(module, "PagLiteralOptions", "As printed in [Lu2018].");
  bind_options<segment::SurfaceOptions>(module, "SurfaceOptions", "Surface continuation.");
  bind_options<segment::BreakpointOptions>(module, "BreakpointOptions", "Adaptive breakpoints.");
  bind_options<segment::AdaptiveOptions>(module, "AdaptiveOptions", "Two lambdas, as in [Guo].");
  bind_options<segment::DistanceThresholdOptions>(module, "DistanceThresholdOptions",
                                                  "A fixed distance.");
  bind_options<segment::EuclideanOptions>(module, "EuclideanOptions", "Euclidean clusters.");
  bind_options<shape::OutlineOptions>(module, "OutlineOptions", "Lines and boxes of clusters.");
  bind_options<shape::IepfOptions>(module, "IepfOptions", "Cutting points into lines.");
  bind_options<shape::FaceFitOptions>(module, "FaceFitOptions", "Fitting the seen faces.");
  bind_options<shape::OcclusionOptions>(module, "OcclusionOptions", "Which ends are hidden.");
  bind_options<shape::JoinOptions>(module, "JoinOptions", "Pieces of one object.");
  bind_options<classify::RecognizerOptions>(module, "RecognizerOptions", "What outlines are.");
  bind_options<track::TrackerOptions>(module, "TrackerOptions", "From detections to tracks.");
}

void bind_whole(py::module_& module) {
  py::class_<PerceptionOptions> options(
      module, "Options",
      "Everything the chain can be told: one attribute a section of the configuration file.");
  options.def(py::init([](const std::string& preset, const std::vector<std::string>& set) {
                auto chosen = value_or_throw(pipeline::preset(preset));
                for (const auto& text : set) value_or_throw(set_config(chosen, text));
                return chosen;
              }),
              py::arg("preset") = "vehicle-pag", py::arg("set") = std::vector<std::string>{},
              "Options of a preset; `set` holds texts like 'track.confirm_hits=3', as the command "
              "line's --set.");
  using O = PerceptionOptions;
  add_section<pipeline::PipelineOptions>(options, "pipeline",
                                         [](O& o) -> auto& { return o.pipeline; });
  add_section<preprocess::PreprocessOptions>(options, "preprocess",
                                             [](O& o) -> auto& { return o.preprocess; });
  add_section<segment::SegmentOptions>(options, "segment", [](O& o) -> auto& { return o.segment; });
  add_section<segment::PagOptions>(options, "pag", [](O& o) -> auto& { return o.segment.pag; });
  add_section<segment::PagLiteralOptions>(options, "pag_literal",
                                          [](O& o) -> auto& { return o.segment.pag_literal; });
  add_section<segment::SurfaceOptions>(options, "surface",
                                       [](O& o) -> auto& { return o.segment.surface; });
  add_section<segment::BreakpointOptions>(options, "breakpoint",
                                          [](O& o) -> auto& { return o.segment.breakpoint; });
  add_section<segment::AdaptiveOptions>(options, "adaptive",
                                        [](O& o) -> auto& { return o.segment.adaptive; });
  add_section<segment::DistanceThresholdOptions>(
      options, "distance_threshold", [](O& o) -> auto& { return o.segment.distance_threshold; });
  add_section<segment::EuclideanOptions>(options, "euclidean",
                                         [](O& o) -> auto& { return o.segment.euclidean; });
  add_section<shape::OutlineOptions>(options, "outline",
                                     [](O& o) -> auto& { return o.shape.outline; });
  add_section<shape::IepfOptions>(options, "iepf", [](O& o) -> auto& { return o.shape.iepf; });
  add_section<shape::FaceFitOptions>(options, "faces", [](O& o) -> auto& { return o.shape.faces; });
  add_section<shape::OcclusionOptions>(options, "occlusion",
                                       [](O& o) -> auto& { return o.shape.occlusion; });
  add_section<shape::JoinOptions>(options, "join", [](O& o) -> auto& { return o.shape.join; });
  add_section<classify::RecognizerOptions>(options, "classify",
                                           [](O& o) -> auto& { return o.classify; });
  add_section<track::TrackerOptions>(options, "track", [](O& o) -> auto& { return o.track; });
  options
      .def(
          "set", [](O& o, const std::string& text) { value_or_throw(set_config(o, text)); },
          py::arg("assignment"), "As the command line's --set: 'section.option=value'.")
      .def(
          "describe",
          [](const O& o) {
            py::list rows;
            for (const auto& view : view_config(o)) {
              py::dict row = dict_of(view);
              row["section"] = view.section;
              rows.append(row);
            }
            return rows;
          },
          "Every option of every section, as text.")
      .def("__copy__", [](const O& o) { return o; })
      .def("__deepcopy__", [](const O& o, const py::dict&) { return o; });
  module.def("preset_names", &pipeline::preset_names);
}

/// Options that hold what the method asks for: classes are loaded where it needs them.
PerceptionOptions with_classes(PerceptionOptions options) {
  value_or_throw(load_classes(options));
  return options;
}

void bind_pipeline(py::module_& module) {
  using pipeline::Perception;
  py::class_<Perception>(module, "Pipeline",
                         "The whole chain: scans in, detections and tracks out. One object a "
                         "stream and thread; long calls let other threads run.")
      .def(py::init(
               [](const PerceptionOptions& options) { return Perception(with_classes(options)); }),
           py::arg("options"))
      .def(py::init([](const std::string& preset) {
             return Perception(value_or_throw(pipeline::preset(preset)));
           }),
           py::arg("preset") = "vehicle-pag")
      .def(
          "step",
          [](Perception& chain, const pipeline::PosedScan& posed) { return chain.step(posed); },
          py::arg("scan"), py::call_guard<py::gil_scoped_release>(),
          "Folds in one scan; scans come in order of time.")
      .def(
          "step",
          [](Perception& chain, const Scan& scan) {
            pipeline::PosedScan posed;
            posed.scan = scan;
            return chain.step(posed);
          },
          py::arg("scan"), py::call_guard<py::gil_scoped_release>(),
          "The same of a sensor that stands still at the origin.")
      .def_property_readonly(
          "virtual_scan", [](const Perception& chain) { return chain.virtual_scan(); },
          "What the last step worked on.")
      .def_property_readonly("outlines",
                             [](const Perception& chain) {
                               const auto outlines = chain.outlines();
                               return std::vector<Outline>(outlines.begin(), outlines.end());
                             })
      .def_property_readonly("diagnostics",
                             [](const Perception& chain) { return dict_of(chain.diagnostics()); });
}

void bind_outline(py::module_& module) {
  py::class_<LineSegment>(module, "LineSegment", "A straight run of points.")
      .def_readonly("first_m", &LineSegment::first_m)
      .def_readonly("last_m", &LineSegment::last_m)
      .def_readonly("rms_m", &LineSegment::rms_m)
      .def_readonly("points", &LineSegment::points);
  py::class_<Outline>(module, "Outline", "Lines and box of a cluster; levelled sensor frame.")
      .def_readonly("lines", &Outline::lines)
      .def_readonly("box", &Outline::box)
      .def_readonly("covariance", &Outline::covariance)
      .def_readonly("faces_seen", &Outline::faces_seen)
      .def_readonly("left_end_occluded", &Outline::left_end_occluded)
      .def_readonly("right_end_occluded", &Outline::right_end_occluded)
      .def_readonly("points", &Outline::points)
      .def_readonly("residual_m", &Outline::residual_m)
      .def_readonly("cluster", &Outline::cluster);
}

/// A cluster's number a point, -1 for noise.
py::array_t<std::int32_t> labels_of(const Clusters& clusters, std::size_t points) {
  std::vector<std::int32_t> labels(points, -1);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (const auto index : clusters[k]) labels[index] = static_cast<std::int32_t>(k);
  }
  return array_of(labels);
}

Clusters clusters_of(
    const py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>& labels,
    std::size_t points) {
  if (labels.ndim() != 1 || static_cast<std::size_t>(labels.size()) != points) {
    throw Failure(
        {Error::Code::kMalformed, fmt::format("{} labels for {} points", labels.size(), points)});
  }
  std::vector<std::vector<std::uint32_t>> members;
  for (std::uint32_t k = 0; k < points; ++k) {
    const std::int32_t label = labels.data()[k];
    if (label < 0) continue;
    if (static_cast<std::size_t>(label) >= points) {
      throw Failure({Error::Code::kOutOfRange,
                     fmt::format("label {} of point {}: labels count from 0", label, k)});
    }
    if (static_cast<std::size_t>(label) >= members.size()) {
      members.resize(static_cast<std::size_t>(label) + 1);
    }
    members[static_cast<std::size_t>(label)].push_back(k);
  }
  Clusters clusters;
  for (const auto& group : members) {
    clusters.indices.insert(clusters.indices.end(), group.begin(), group.end());
    clusters.close();
  }
  return clusters;
}

void bind_stages(py::module_& module) {
  module.def(
      "flatten",
      [](const Scan& scan, const PerceptionOptions& options,
         const std::optional<Eigen::Matrix4d>& ego_from_sensor) {
        preprocess::VirtualScanBuilder builder(options.preprocess);
        return builder(scan, ego_from_sensor ? pose_of(*ego_from_sensor) : Pose3{});
      },
      py::arg("scan"), py::arg("options") = PerceptionOptions{},
      py::arg("ego_from_sensor") = py::none(), "One point a bearing, ground taken away.");
  module.def(
      "segment",
      [](const VirtualScan& scan, const PerceptionOptions& options) {
        segment::Segmenter segmenter(options.segment);
        return labels_of(segmenter(scan), scan.points.size());
      },
      py::arg("scan"), py::arg("options") = PerceptionOptions{},
      "The number of the cluster of each point, int32; -1 is noise.");
  module.def(
      "outline",
      [](const VirtualScan& scan,
         const py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>& labels,
         const PerceptionOptions& options) {
        shape::OutlineExtractor extract(options.shape);
        const auto clusters = clusters_of(labels, scan.points.size());
        const auto outlines = extract(scan, clusters);
        return std::vector<Outline>(outlines.begin(), outlines.end());
      },
      py::arg("scan"), py::arg("labels"), py::arg("options") = PerceptionOptions{},
      "Lines and box of each cluster; pieces of one object are joined.");
  module.def(
      "classify",
      [](const std::vector<Outline>& outlines, const PerceptionOptions& options) {
        classify::Recognizer recognize(with_classes(options).classify);
        const auto detections = recognize(outlines);
        return std::vector<Detection>(detections.begin(), detections.end());
      },
      py::arg("outlines"), py::arg("options") = PerceptionOptions{},
      "What the outlines are; those that are nothing tracked are left out.");
  py::class_<track::Tracker>(module, "Tracker", "Detections in, tracks out, scan after scan.")
      .def(py::init([](const PerceptionOptions& options) {
             return track::Tracker(with_classes(options).track);
           }),
           py::arg("options") = PerceptionOptions{})
      .def(
          "step",
          [](track::Tracker& tracker, double stamp_s, const std::vector<Detection>& detections) {
            return tracker.step(time_of(stamp_s), detections);
          },
          py::arg("stamp_s"), py::arg("detections"),
          "Detections of one scan, in a frame that does not move; returns the tracks.")
      .def_property_readonly("diagnostics", [](const track::Tracker& tracker) {
        return dict_of(tracker.diagnostics());
      });
}

}  // namespace

void bind_chain(py::module_& module) {
  bind_sections(module);
  bind_whole(module);
  bind_outline(module);
  bind_pipeline(module);
  bind_stages(module);
}

}  // namespace scanfuse::python
