#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"
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

/// Where the targets of a scan are, by what its bearings name them.
using Places = std::map<std::int64_t, Eigen::Vector3d>;

/// How far lines of sight are drawn that end at no target: past all sensors and targets.
double reach_of(const PassiveScene& scene, const Places& places) {
  double reach = 1;
  for (const auto& a : scene.sensors) {
    const Eigen::Vector3d from = a.world_from_sensor.translation_m;
    for (const auto& b : scene.sensors) {
      reach = std::max(reach, (b.world_from_sensor.translation_m - from).norm());
    }
    for (const auto& [id, place] : places) {
      reach = std::max(reach, (place - from).head<2>().norm());
    }
  }
  return 1.2 * reach;
}

/// `target_of_bearing`: -1 for none.
std::vector<serve::ShownRay> rays_of(const PassiveScene& scene, const BearingScan& scan,
                                     const std::vector<std::int64_t>& target_of_bearing,
                                     const Places& places) {
  const double reach = reach_of(scene, places);
  std::vector<serve::ShownRay> rays;
  for (std::size_t i = 0; i < scan.bearings.size(); ++i) {
    const Bearing& bearing = scan.bearings[i];
    const auto& sensor = scene.sensors[static_cast<std::size_t>(bearing.sensor)];
    const Eigen::Vector3d from = sensor.world_from_sensor.translation_m;
    const auto target = places.find(i < target_of_bearing.size() ? target_of_bearing[i] : -1);
    const bool is_aimed = target != places.end();
    const double length = is_aimed ? (target->second - from).norm() : reach;
    rays.push_back({from, from + length * direction(sensor, bearing),
                    static_cast<std::uint32_t>(bearing.sensor),
                    is_aimed ? static_cast<std::int32_t>(target->first) : -1});
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
    Places places;
    for (const Track& track : shown.step.tracks) {
      places.emplace(track.id,
                     Eigen::Vector3d(track.box.centre_m.x(), track.box.centre_m.y(), track.z_m));
    }
    shown.rays = rays_of(scene_, scan, found->track_of_bearing, places);
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

Detection as_detection(const Fix& fix) {
  Detection detection;
  detection.object_class = ObjectClass::kUnknown;
  detection.score = fix.existence_probability;
  detection.box.centre_m = fix.position_m.head<2>();
  detection.z_m = fix.position_m.z();
  detection.covariance.topLeftCorner<2, 2>() = fix.covariance_m2.topLeftCorner<2, 2>();
  return detection;
}

/// Fixes of each scan by itself.
class FixShow {
 public:
  FixShow(PassiveScene scene, std::vector<BearingScan> scans,
          triangulate::AssociationOptions options, int threads)
      : scene_(std::move(scene)), scans_(std::move(scans)), options_(options), threads_(threads) {}

  serve::ShownFrame operator()(const pipeline::PosedScan&) {
    serve::ShownFrame shown;
    const BearingScan& scan = scans_[next_++];
    shown.step.stamp = scan.stamp;
    shown.step.frame = scan.scan;
    const auto found = triangulate::associate_scan(scan, scene_, options_, threads_);
    if (!found) return shown;  // more hypotheses than allowed: `associate` says so
    Places places;
    for (const Fix& fix : found->fixes) {
      shown.step.detections.push_back(as_detection(fix));
      places.emplace(fix.target, fix.position_m);
    }
    shown.rays = rays_of(scene_, scan, found->target_of_bearing, places);
    return shown;
  }

 private:
  PassiveScene scene_;
  std::vector<BearingScan> scans_;
  triangulate::AssociationOptions options_;
  int threads_;
  std::size_t next_ = 0;
};

}  // namespace

Result<std::unique_ptr<serve::Workbench>> open_passive_bench(const ViewRequest& view, int threads) {
  const TrackRequest& request = view.track;
  auto scene = io::read_sensors(request.sensors);
  if (!scene) return tl::unexpected(scene.error());
  Diagnostics ignored;  // `track` tells them
  auto scans = io::read_bearings(request.input, *scene, &ignored);
  if (!scans) return tl::unexpected(scans.error());
  serve::WorkbenchOptions bench;
  bench.title = std::filesystem::path(request.input).filename().string();
  bench.preset = request.preset;
  auto source = std::make_unique<BearingTimes>(*scans);
  serve::ShowScan show;
  if (view.association) {
    show = FixShow(std::move(*scene), std::move(*scans), *view.association, threads);
  } else {
    show = PassiveShow(std::move(*scene), std::move(*scans));
  }
  return serve::Workbench::create(std::move(source), std::move(show), std::move(bench));
}

}  // namespace scanfuse::app
