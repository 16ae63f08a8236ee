#include <algorithm>
#include <filesystem>

#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/session_folder.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

using Eigen::Vector3d;
using serve::RigPart;
using serve::ShownEdge;

constexpr std::size_t kMostPoints = 100'000;
constexpr double kCameraDepthM = 0.15;
constexpr double kAxisHalfM = 0.5;
constexpr double kLidarReachM = 0.3;

/// The page's world: x ahead of the camera, y to its left, z up.
Pose3 world_from_camera() {
  Eigen::Matrix3d turn;
  turn << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(turn), Vector3d::Zero()};
}

/// Stands for the scans of a session: the lidar's pose at each position, a tenth of a second apart.
class RigPositions final : public serve::ScanSource {
 public:
  explicit RigPositions(const std::vector<CloudProfile>& profiles) {
    for (const auto& profile : profiles) poses_.push_back(profile.cloud_from_lidar);
  }
  [[nodiscard]] Result<std::optional<pipeline::PosedScan>> next() override {
    if (next_ == poses_.size()) return std::optional<pipeline::PosedScan>{};
    pipeline::PosedScan posed;
    posed.scan.sensor = "lidar";
    posed.scan.frame = static_cast<std::int64_t>(next_);
    posed.scan.stamp = Time(std::chrono::milliseconds(100 * next_));
    posed.world_from_ego = world_from_camera() * poses_[next_++];
    return std::optional(std::move(posed));
  }

 private:
  std::vector<Pose3> poses_;
  std::size_t next_ = 0;
};

/// The cloud as far as it has been scanned, and the rig as it stands.
class RigShow {
 public:
  RigShow(const RigScene& scene, Cloud cloud) : cloud_(std::move(cloud)) {
    // Profiles before the one that is shown are thinned, so that a frame stays small.
    stride_ = 1 + cloud_.points.size() / kMostPoints;
    add_camera(scene);
    const Vector3d n = scene.rig.axis_direction;
    const Vector3d centre = scene.rig.camera_from_lidar.translation_m;
    const Vector3d foot = scene.rig.axis_point_m + n * n.dot(centre - scene.rig.axis_point_m);
    add(foot - kAxisHalfM * n, foot + kAxisHalfM * n, RigPart::kAxis);
    for (const auto& [board, camera_from_board] : scene.boards) add_board(board, camera_from_board);
    find_arc(scene);
  }

  serve::ShownFrame operator()(const pipeline::PosedScan& posed) {
    serve::ShownFrame shown;
    shown.step.stamp = posed.scan.stamp;
    shown.step.frame = posed.scan.frame;
    shown.step.world_from_ego = posed.world_from_ego;
    shown.edges = fixed_;
    const auto profile = static_cast<int>(posed.scan.frame);
    for (std::size_t i = 0; i < cloud_.points.size(); ++i) {
      const CloudPoint& point = cloud_.points[i];
      if (point.profile > profile) break;  // ascending
      const bool is_new = point.profile == profile;
      if (!is_new && i % stride_ != 0) continue;
      serve::ShownPoint to;
      to.position_m = world_ * point.position_m;
      to.intensity = std::isfinite(point.intensity) ? static_cast<float>(point.intensity) : 0;
      to.cluster = is_new ? 1 : 0;
      shown.points.push_back(to);
    }
    shown.detection_of_cluster = {-1};
    const Vector3d from = posed.world_from_ego.translation_m;
    for (const double angle : {first_rad_, last_rad_}) {
      const Vector3d ray(kLidarReachM * std::cos(angle), kLidarReachM * std::sin(angle), 0);
      shown.edges.push_back({from, posed.world_from_ego * ray, RigPart::kLidar});
    }
    return shown;
  }

 private:
  void add(const Vector3d& from_m, const Vector3d& to_m, RigPart part) {
    fixed_.push_back({world_ * from_m, world_ * to_m, part});
  }
  void add_camera(const RigScene& scene) {
    const Camera& camera = scene.camera;
    if (!(camera.fx_px > 0) || !(camera.fy_px > 0)) return;  // a rig without its camera
    std::array<Vector3d, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const double u = i == 1 || i == 2 ? camera.width_px : 0, v = i >= 2 ? camera.height_px : 0;
      corners[i] = kCameraDepthM * Vector3d((u - camera.cx_px) / camera.fx_px,
                                            (v - camera.cy_px) / camera.fy_px, 1);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      add(Vector3d::Zero(), corners[i], RigPart::kCamera);
      add(corners[i], corners[(i + 1) % 4], RigPart::kCamera);
    }
  }
  /// With the border of one square around its inner corners.
  void add_board(const BoardSpec& board, const Pose3& camera_from_board) {
    const double s = board.square_m, right = s * board.columns, bottom = s * board.rows;
    const std::array<Vector3d, 4> corners{
        {{-s, -s, 0}, {right, -s, 0}, {right, bottom, 0}, {-s, bottom, 0}}};
    for (std::size_t i = 0; i < 4; ++i) {
      add(camera_from_board * corners[i], camera_from_board * corners[(i + 1) % 4],
          RigPart::kBoard);
    }
  }
  void find_arc(const RigScene& scene) {
    for (const auto& position : scene.positions) {
      if (position.scan.empty()) continue;
      first_rad_ = position.scan.front().angle_rad;
      last_rad_ = position.scan.back().angle_rad;
      return;
    }
  }

  Pose3 world_ = world_from_camera();
  Cloud cloud_;
  std::size_t stride_ = 1;
  std::vector<ShownEdge> fixed_;
  double first_rad_ = 0, last_rad_ = 0;
};

}  // namespace

Result<RigScene> read_rig_scene(const std::string& session, const std::string& rig_path) {
  auto rig = io::read_rig(rig_path);
  if (!rig) return tl::unexpected(rig.error());
  const auto folder = io::open_session(session);
  if (!folder) return tl::unexpected(folder.error());
  auto content = io::read_session_content(*folder);
  if (!content) return tl::unexpected(content.error());
  return RigScene{session,
                  std::move(content->features.positions),
                  rig->rig,
                  rig->camera.value_or(Camera{}),
                  {}};
}

Result<std::unique_ptr<serve::Workbench>> open_rig_bench(const RigScene& scene) {
  auto made = calibrate::assemble(scene.positions, scene.rig);
  if (!made) return fail(made.error().code, "{}: {}", scene.session, made.error().message);
  serve::WorkbenchOptions bench;
  bench.title = fmt::format("{}: {} positions, {} returns",
                            std::filesystem::path(scene.session).filename().string(),
                            made->cloud.profiles.size(), made->cloud.points.size());
  auto source = std::make_unique<RigPositions>(made->cloud.profiles);
  return serve::Workbench::create(std::move(source), RigShow(scene, std::move(made->cloud)),
                                  std::move(bench));
}

}  // namespace scanfuse::app
