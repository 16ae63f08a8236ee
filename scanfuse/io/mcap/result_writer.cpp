#include "scanfuse/io/mcap/result_writer.hpp"

#include <utility>

#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/mcap/scene.hpp"
#include "scanfuse/io/mcap/topic_writer.hpp"

namespace scanfuse::io {
namespace {

constexpr const char* kTracksTopic = "/scanfuse/tracks";
constexpr const char* kDetectionsTopic = "/scanfuse/detections";

class McapResultWriter final : public ResultWriter {
 public:
  McapResultWriter(mcap::TopicWriter out, const McapResultOptions& options)
      : out_(std::move(out)), scene_(options.frame) {}

  [[nodiscard]] Result<void> write(const StepResult& step, const Scan& scan) override {
    const std::string sensor_frame = scan.frame_id.empty() ? "sensor" : scan.frame_id;
    if (auto done = write_transforms(step, sensor_frame); !done) return done;
    if (auto done = write_scan(scan, sensor_frame); !done) return done;
    const std::pair<const char*, std::pair<const char*, std::string>> messages[] = {
        {kDetectionsTopic, {"scanfuse.Detections", mcap::detections_json(step)}},
        {kTracksTopic, {"scanfuse.Tracks", mcap::tracks_json(step)}},
        {"/scanfuse/scene", {"foxglove.SceneUpdate", scene_.update(step)}}};
    for (const auto& [topic, message] : messages) {
      if (auto done = out_.write_json(topic, message.first, step.stamp, message.second); !done) {
        return done;
      }
    }
    return {};
  }

  [[nodiscard]] Result<void> write(const TruthFrame& truth) override {
    return out_.write_json("/scanfuse/truth", "scanfuse.Truth", truth.stamp,
                           mcap::truth_json(truth));
  }

  [[nodiscard]] Result<void> finish() override { return out_.finish(); }

 private:
  Result<void> write_transforms(const StepResult& step, const std::string& sensor_frame) {
    auto done = write_transform(step.stamp, "world", "ego", step.world_from_ego);
    if (!done || sensor_frame == "ego" || sensor_frame == "world") return done;
    return write_transform(step.stamp, "ego", sensor_frame, step.ego_from_sensor);
  }

  Result<void> write_transform(Time stamp, const char* parent, const std::string& child,
                               const Pose3& pose) {
    return out_.write_json("/tf", "foxglove.FrameTransform", stamp,
                           mcap::transform_json(stamp, parent, child, pose));
  }

  /// Always as a point cloud, so that a topic has one type.
  Result<void> write_scan(const Scan& scan, const std::string& sensor_frame) {
    Scan cloud = scan;
    cloud.beams.reset();
    cloud.frame_id = sensor_frame;
    return out_.write_cdr(mcap::topic_of(scan.sensor), scan.stamp, ros::encode_cdr(cloud));
  }

  mcap::TopicWriter out_;
  mcap::SceneBuilder scene_;
};

/// Detections wait for the tracks of the same instant, which follow them in the file.
struct WaitingDetections {
  Time time;
  std::vector<Detection> detections;

  [[nodiscard]] std::vector<Detection> take(Time tracks_time) {
    auto taken = std::exchange(detections, {});
    if (time != tracks_time) taken.clear();  // their own tracks were lost to damage
    return taken;
  }
};

}  // namespace

Result<std::unique_ptr<ResultWriter>> open_mcap_result_writer(const std::filesystem::path& path,
                                                              const McapResultOptions& options) {
  auto out = mcap::TopicWriter::create(path);
  if (!out) return tl::unexpected(out.error());
  return std::make_unique<McapResultWriter>(std::move(*out), options);
}

Result<std::vector<StepResult>> read_tracks_mcap(const std::filesystem::path& path,
                                                 Diagnostics* diagnostics) {
  auto source = open_mcap(path, {kTracksTopic, kDetectionsTopic});
  if (!source) return tl::unexpected(source.error());
  std::vector<StepResult> steps;
  WaitingDetections waiting;
  for (;;) {
    auto message = (*source)->next();
    if (!message) return tl::unexpected(message.error());
    if (!*message) break;
    const auto& channel = (*source)->channels()[(*message)->channel];
    if (channel.type == "scanfuse.Detections") {
      auto read = mcap::detections_from_json((*message)->bytes);
      if (!read) return fail(read.error().code, "{}: {}", path.string(), read.error().message);
      waiting = {(*message)->log_time, std::move(*read)};
    } else if (channel.type == "scanfuse.Tracks") {
      auto read = mcap::tracks_from_json((*message)->bytes);
      if (!read) return fail(read.error().code, "{}: {}", path.string(), read.error().message);
      read->detections = waiting.take((*message)->log_time);
      steps.push_back(std::move(*read));
    }
  }
  if (diagnostics != nullptr) diagnostics->merge((*source)->diagnostics());
  if (steps.empty()) {
    return fail(Error::Code::kNotFound, "{}: no messages on {}; was it written by scanfuse track?",
                path.string(), kTracksTopic);
  }
  return steps;
}

}  // namespace scanfuse::io
