#include <algorithm>
#include <filesystem>
#include <tuple>

#include "scanfuse/io/passive/passive.hpp"
#include "track_passive.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

/// Stands for the scans of bearings: times without returns.
class BearingTimes final : public serve::ScanSource {
 public:
  explicit BearingTimes(const std::vector<BearingScan>& scans) {
    for (const auto& scan : scans) times_.emplace_back(scan.stamp, scan.scan);
  }
  [[nodiscard]] Result<std::optional<pipeline::PosedScan>> next() override {
    if (next_ == times_.size()) return std::optional<pipeline::PosedScan>{};
    pipeline::PosedScan posed;
    posed.scan.sensor = "passive";
    std::tie(posed.scan.stamp, posed.scan.frame) = times_[next_++];
    return std::optional(std::move(posed));
  }

 private:
  std::vector<std::pair<Time, std::int64_t>> times_;
  std::size_t next_ = 0;
};

Eigen::Vector3d direction(const PassiveSensor& sensor, const Bearing& bearing) {
  const double level = std::cos(bearing.elevation_rad);
  return sensor.world_from_sensor.rotation * Eigen::Vector3d(level * std::cos(bearing.azimuth_rad),
                                                             level * std::sin(bearing.azimuth_rad),
                                                             std::sin(bearing.elevation_rad));
}

/// How far lines of sight are drawn that end at no target: past all sensors and tracks.
double reach_of(const PassiveScene& scene, const StepResult& step) {
  double reach = 1;
  for (const auto& a : scene.sensors) {
    const Eigen::Vector3d from = a.world_from_sensor.translation_m;
    for (const auto& b : scene.sensors) {
      reach = std::max(reach, (b.world_from_sensor.translation_m - from).norm());
    }
    for (const auto& track : step.tracks) {
      reach = std::max(reach, (track.box.centre_m - from.head<2>()).norm());
    }
  }
  return 1.2 * reach;
}

std::vector<serve::ShownRay> rays_of(const PassiveScene& scene, const BearingScan& scan,
                                     const triangulate::PassiveStep& found,
                                     const StepResult& step) {
  const double reach = reach_of(scene, step);
  std::vector<serve::ShownRay> rays;
  for (std::size_t i = 0; i < scan.bearings.size(); ++i) {
    const Bearing& bearing = scan.bearings[i];
    const auto& sensor = scene.sensors[static_cast<std::size_t>(bearing.sensor)];
    const Eigen::Vector3d from = sensor.world_from_sensor.translation_m;
    const std::int64_t id = i < found.track_of_bearing.size() ? found.track_of_bearing[i] : -1;
    const auto target = std::ranges::find(step.tracks, id, &Track::id);
    double length = reach;
    if (target != step.tracks.end()) {
      const auto& place = target->box.centre_m;
      length = (Eigen::Vector3d(place.x(), place.y(), target->z_m) - from).norm();
    }
    rays.push_back({from, from + length * direction(sensor, bearing),
                    static_cast<std::uint32_t>(bearing.sensor),
                    target == step.tracks.end() ? -1 : static_cast<std::int32_t>(id)});
  }
  return rays;
}

/// Tracks as the frames are asked for: scan after scan.
class PassiveShow {
 public:
  PassiveShow(PassiveScene scene, std::vector<BearingScan> scans)
      : scene_(scene), scans_(std::move(scans)), tracker_(std::move(scene), {}, association()) {}

  serve::ShownFrame operator()(const pipeline::PosedScan&) {
    serve::ShownFrame shown;
    const BearingScan& scan = scans_[next_++];
    const auto found = tracker_.step(scan);
    shown.step.stamp = scan.stamp;
    shown.step.frame = scan.scan;
    if (!found) return shown;  // more hypotheses than allowed: `track` says so
    shown.step = as_step(scan, *found);
    shown.rays = rays_of(scene_, scan, *found, shown.step);
    return shown;
  }

 private:
  static triangulate::AssociationOptions association() {
    triangulate::AssociationOptions options;
    options.posterior = false;
    return options;
  }
  PassiveScene scene_;
  std::vector<BearingScan> scans_;
  triangulate::PassiveTracker tracker_;
  std::size_t next_ = 0;
};

}  // namespace

Result<std::unique_ptr<serve::Workbench>> open_passive_bench(const TrackRequest& request) {
  auto scene = io::read_sensors(request.sensors);
  if (!scene) return tl::unexpected(scene.error());
  Diagnostics ignored;  // `track` tells them
  auto scans = io::read_bearings(request.input, *scene, &ignored);
  if (!scans) return tl::unexpected(scans.error());
  serve::WorkbenchOptions bench;
  bench.title = std::filesystem::path(request.input).filename().string();
  bench.preset = request.preset;
  auto source = std::make_unique<BearingTimes>(*scans);
  auto show = std::make_shared<PassiveShow>(std::move(*scene), std::move(*scans));
  return serve::Workbench::create(
      std::move(source), [show](const pipeline::PosedScan& posed) { return (*show)(posed); },
      std::move(bench));
}

}  // namespace scanfuse::app
