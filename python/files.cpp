#include "bind.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"

namespace scanfuse::python {
namespace {

using pipeline::PosedScan;
using pipeline::ScanFeed;

/// A recording as Python reads it: scans with poses, one after the other; truth is kept as it
/// comes.
class Recording {
 public:
  Recording(const std::filesystem::path& path, std::vector<std::string> topics,
            std::string ego_topic, const std::optional<std::filesystem::path>& ego,
            const std::optional<Eigen::Matrix4d>& mount, bool paper_axes, bool standing) {
    pipeline::FeedOptions feed;
    feed.ego_topic = std::move(ego_topic);
    feed.may_move = !standing;
    if (mount) feed.mount = pose_of(*mount);
    if (ego) feed.ego = value_or_throw(io::read_ego(*ego));
    feed_.emplace(value_or_throw(io::open_recording(path, {std::move(topics), paper_axes})),
                  std::move(feed));
  }

  [[nodiscard]] std::optional<PosedScan> next() {
    auto scan = value_or_throw(feed_->next());
    for (auto& frame : feed_->take_truth()) truth_.push_back(std::move(frame));
    return scan;
  }
  [[nodiscard]] const std::vector<TruthFrame>& truth() const { return truth_; }
  [[nodiscard]] const ScanFeed& feed() const { return *feed_; }

 private:
  std::optional<ScanFeed> feed_;
  std::vector<TruthFrame> truth_;
};

py::list topics_of(const io::RecordingInfo& info) {
  py::list topics;
  for (const auto& topic : info.topics) {
    topics.append(py::dict(py::arg("name") = topic.name, py::arg("type") = topic.type,
                           py::arg("messages") = topic.messages, py::arg("is_scan") = topic.is_scan,
                           py::arg("decoded") = topic.decoded));
  }
  return topics;
}

void bind_recording(py::module_& module) {
  py::class_<Recording>(module, "Recording",
                        "A recording of any format that scanfuse reads, as an iterator of "
                        "PosedScan; never loaded whole.")
      .def(py::init<const std::filesystem::path&, std::vector<std::string>, std::string,
                    const std::optional<std::filesystem::path>&,
                    const std::optional<Eigen::Matrix4d>&, bool, bool>(),
           py::arg("path"), py::kw_only(), py::arg("topics") = std::vector<std::string>{},
           py::arg("ego_topic") = "", py::arg("ego") = py::none(), py::arg("mount") = py::none(),
           py::arg("paper_axes") = false, py::arg("standing") = false,
           "`mount`: ego_from_sensor, 4 x 4; `ego`: a CSV of poses beside the recording; "
           "`standing`: look for no ego motion in the scans where nothing tells it.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__",
           [](Recording& recording) {
             std::optional<PosedScan> scan;
             {
               const py::gil_scoped_release release;
               scan = recording.next();
             }
             if (!scan) throw py::stop_iteration();
             return std::move(*scan);
           })
      .def_property_readonly("truth", &Recording::truth,
                             "TruthFrames that came along with the scans read so far.")
      .def_property_readonly("format", [](const Recording& r) { return r.feed().info().format; })
      .def_property_readonly("topics",
                             [](const Recording& r) { return topics_of(r.feed().info()); })
      .def_property_readonly("diagnostics",
                             [](const Recording& r) { return dict_of(r.feed().diagnostics()); });
}

/// Writes results scan by scan; the file has its name when `close` was called.
class TrackWriter {
 public:
  explicit TrackWriter(const std::filesystem::path& path)
      : writer_(value_or_throw(io::open_result_writer(path))) {}
  void write(const StepResult& step, const Scan& scan) { value_or_throw(open().write(step, scan)); }
  void close() {
    value_or_throw(open().finish());
    writer_.reset();
  }
  void discard() { writer_.reset(); }

 private:
  io::ResultWriter& open() {
    if (!writer_) throw Failure({Error::Code::kUnsupported, "this writer is closed"});
    return *writer_;
  }
  std::unique_ptr<io::ResultWriter> writer_;
};

void bind_writer(py::module_& module) {
  py::class_<TrackWriter>(module, "TrackWriter",
                          "Writes tracks to .mcap, .csv or .jsonl. With `with`: the file appears "
                          "at the end, and not at all after an exception.")
      .def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def("write", &TrackWriter::write, py::arg("result"), py::arg("scan") = Scan{},
           py::call_guard<py::gil_scoped_release>())
      .def("close", &TrackWriter::close)
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__",
           [](TrackWriter& writer, const py::object& type, const py::object&, const py::object&) {
             if (type.is_none()) {
               writer.close();
             } else {
               writer.discard();
             }
           });
}

void bind_detection_frames(py::module_& module) {
  using io::DetectionFrame;
  py::class_<DetectionFrame>(module, "DetectionFrame", "The detections of one scan.")
      .def(py::init([](double stamp_s, std::int64_t frame, std::vector<Detection> detections) {
             return DetectionFrame{time_of(stamp_s), frame, "", std::move(detections)};
           }),
           py::arg("stamp_s"), py::arg("frame"), py::arg("detections"))
      .def_property_readonly("stamp_s", [](const DetectionFrame& f) { return to_seconds(f.stamp); })
      .def_readonly("frame", &DetectionFrame::frame)
      .def_readonly("sensor", &DetectionFrame::sensor)
      .def_readonly("detections", &DetectionFrame::detections);
}

void bind_tables(py::module_& module) {
  using Path = std::filesystem::path;
  module.def(
      "read_tracks", [](const Path& path) { return value_or_throw(io::read_tracks(path)); },
      py::arg("path"), "StepResults from tracks that were written to .csv, .jsonl or .mcap.");
  module.def(
      "read_truth", [](const Path& path) { return value_or_throw(io::read_truth(path)); },
      py::arg("path"), "TruthFrames from a truth CSV or KITTI labels.");
  module.def(
      "read_detections", [](const Path& path) { return value_or_throw(io::read_detections(path)); },
      py::arg("path"), "DetectionFrames from a CSV or KITTI boxes.");
  module.def(
      "write_detections",
      [](const Path& path, const std::vector<io::DetectionFrame>& frames) {
        value_or_throw(io::write_detections(path, frames));
      },
      py::arg("path"), py::arg("frames"));
  module.def(
      "write_truth",
      [](const Path& path, const std::vector<TruthFrame>& frames) {
        value_or_throw(io::write_truth_csv(path, frames));
      },
      py::arg("path"), py::arg("frames"));
}

}  // namespace

void bind_files(py::module_& module) {
  bind_recording(module);
  bind_writer(module);
  bind_detection_frames(module);
  bind_tables(module);
}

}  // namespace scanfuse::python
