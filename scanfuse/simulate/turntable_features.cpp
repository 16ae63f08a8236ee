#include "scanfuse/simulate/turntable_features.hpp"

#include <optional>

#include "scanfuse/core/random.hpp"

namespace scanfuse::simulate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// An error that the points of one line share: an offset, and a tilt of the same size at its ends.
struct LineError {
  double offset = 0;
  double tilt = 0;
  /// `along` runs from -1 to 1.
  [[nodiscard]] double at(double along) const { return offset + tilt * along; }
};

LineError draw(double sigma, RandomStream& random) {
  const double offset = random.normal(0, sigma);
  return {offset, random.normal(0, sigma)};
}

std::vector<Vector2d> corners_of(const TurntableWorld& world, std::size_t b, double sigma_px,
                                 RandomStream& random) {
  std::vector<Vector2d> corners;
  const BoardSpec& board = world.boards[b];
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      const Vector3d at(column * board.square_m, row * board.square_m, 0);
      const Vector2d noise(random.normal(0, sigma_px), random.normal(0, sigma_px));
      corners.push_back(world.camera.project(world.camera_from_board[b] * at) + noise);
    }
  }
  return corners;
}

struct Segment {
  Vector3d from;
  Vector3d to;
};

/// Where the scan plane of `lidar` cuts the squares of a board.
std::optional<Segment> stripe_on(const TurntableWorld& world, std::size_t b, const Pose3& lidar) {
  WorldRectangle squares = world.board_rectangle(b);
  squares.low_m.array() += world.margin_m;
  squares.high_m.array() -= world.margin_m;
  const Pose3 board_from_lidar = squares.camera_from_rectangle.inverse() * lidar;
  const Vector3d normal = board_from_lidar.rotation * Vector3d::UnitZ();
  // normal . (p - t) = 0 within z = 0: the line a x + b y = c.
  const Vector2d across = normal.head<2>();
  if (across.norm() < 1e-9) return std::nullopt;
  const Vector2d foot = across * normal.dot(board_from_lidar.translation_m) / across.squaredNorm();
  const Vector2d along(-across.y() / across.norm(), across.x() / across.norm());
  double low = -1e9, high = 1e9;
  for (int k = 0; k < 2; ++k) {
    const double a = (squares.low_m[k] - foot[k]) / along[k];
    const double c = (squares.high_m[k] - foot[k]) / along[k];
    if (!std::isfinite(a) || !std::isfinite(c)) {
      if (foot[k] < squares.low_m[k] || foot[k] > squares.high_m[k]) return std::nullopt;
      continue;
    }
    low = std::max(low, std::min(a, c));
    high = std::min(high, std::max(a, c));
  }
  if (low >= high) return std::nullopt;
  const auto at = [&](double s) -> Vector3d {
    const Vector2d p = foot + s * along;
    return squares.camera_from_rectangle * Vector3d(p.x(), p.y(), 0);
  };
  return Segment{at(low), at(high)};
}

/// One point a pixel along the image of the segment, with noise across it.
std::vector<Vector2d> stripe_points(const TurntableWorld& world, const Segment& segment,
                                    const TurntableNoise& noise, RandomStream& random) {
  const Camera& camera = world.camera;
  const LineError shared = draw(noise.stripe_line_px, random);
  const double length = (camera.project(segment.to) - camera.project(segment.from)).norm();
  const int count = static_cast<int>(length);
  std::vector<Vector2d> points;
  for (int i = 0; i <= count; ++i) {
    const double share = count > 0 ? static_cast<double>(i) / count : 0.5;
    // Equal steps in the image are steps of equal homogeneous weight, not of length.
    const double a = share * segment.from.z(), c = (1 - share) * segment.to.z();
    const double t = a / (a + c);
    const auto at = [&](double s) -> Vector3d {
      return segment.from + s * (segment.to - segment.from);
    };
    const Vector2d point = camera.project(at(t));
    const Vector2d along = (camera.project(at(t + 1e-4)) - point).normalized();
    const double across = shared.at(2 * share - 1) + random.normal(0, noise.stripe_px);
    const bool seen = point.x() >= 0 && point.y() >= 0 && point.x() <= camera.width_px - 1 &&
                      point.y() <= camera.height_px - 1;
    if (seen) points.emplace_back(point + across * Vector2d(-along.y(), along.x()));
  }
  return points;
}

struct Hit {
  double range_m = std::numeric_limits<double>::quiet_NaN();
  int board = -1;
  int square = -1;
};

Hit cast(const TurntableWorld& world, const std::vector<WorldRectangle>& all, const Pose3& lidar,
         double angle_rad) {
  const Vector3d ray = lidar.rotation * Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0);
  Hit hit;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double range = distance_to(all[k], lidar.translation_m, ray);
    if (!(range < hit.range_m) && !(std::isnan(hit.range_m) && std::isfinite(range))) continue;
    hit = {range, k < 2 ? static_cast<int>(k) : -1, -1};
  }
  if (hit.board >= 0) {
    const auto b = static_cast<std::size_t>(hit.board);
    const Vector3d p =
        world.camera_from_board[b].inverse() * (lidar.translation_m + hit.range_m * ray);
    hit.square = world.square_at(b, p.head<2>());
  }
  return hit;
}

std::vector<BeamReturn> scan_of(const TurntableWorld& world, const Pose3& lidar,
                                const TurntableNoise& noise, RandomStream& random) {
  std::vector<WorldRectangle> all{world.board_rectangle(0), world.board_rectangle(1)};
  all.insert(all.end(), world.surroundings.begin(), world.surroundings.end());
  std::vector<Hit> hits;
  std::array<std::array<double, 2>, 2> span{{{1e9, -1e9}, {1e9, -1e9}}};
  const auto angle = [&](std::size_t i) {
    return world.first_beam_rad + static_cast<double>(i) * world.beam_step_rad;
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(world.beams); ++i) {
    hits.push_back(cast(world, all, lidar, angle(i)));
    if (hits.back().board < 0) continue;
    auto& s = span[static_cast<std::size_t>(hits.back().board)];
    s = {std::min(s[0], angle(i)), std::max(s[1], angle(i))};
  }
  const std::array shared{draw(noise.range_line_m, random), draw(noise.range_line_m, random)};
  std::vector<BeamReturn> scan;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    double range = hits[i].range_m + noise.range_bias_m + random.normal(0, noise.range_m);
    if (hits[i].board >= 0) {
      const auto b = static_cast<std::size_t>(hits[i].board);
      const double width = std::max(span[b][1] - span[b][0], 1e-9);
      range += shared[b].at(2 * (angle(i) - span[b][0]) / width - 1);
      if (hits[i].square >= 0) range += (hits[i].square - 0.5) * noise.square_bias_m;
    }
    if (noise.range_step_m > 0) range = std::round(range / noise.range_step_m) * noise.range_step_m;
    const double intensity = hits[i].square == 1 ? 0.2 : 0.9;
    scan.push_back({angle(i), range, intensity});
  }
  return scan;
}

}  // namespace

SimulatedTurntable simulate_turntable_features(const TurntableWorldOptions& options,
                                               const TurntableNoise& noise, std::uint64_t seed) {
  SimulatedTurntable out;
  out.world = turntable_world(options);
  out.world.rig.range_bias_m = noise.range_bias_m;
  out.world.rig.angle_scale = noise.angle_scale;
  TurntableFeatures& features = out.features;
  features.camera = out.world.camera;
  features.boards = out.world.boards;
  for (std::size_t b = 0; b < 2; ++b) {
    RandomStream random(seed, b);
    features.corners_px[b] = corners_of(out.world, b, noise.corner_px, random);
  }
  for (std::size_t i = 0; i < out.world.turntable_rad.size(); ++i) {
    RandomStream random(seed, 2 + i);
    TurntablePosition position;
    position.name = fmt::format("position {}", i);
    position.turntable_rad = out.world.turntable_rad[i];
    out.turned_rad.push_back(position.turntable_rad + random.normal(0, noise.turntable_rad));
    const Pose3 lidar = out.world.rig.pose(out.turned_rad.back());
    for (std::size_t b = 0; b < 2; ++b) {
      const auto segment = stripe_on(out.world, b, lidar);
      if (segment) position.stripe_px[b] = stripe_points(out.world, *segment, noise, random);
    }
    position.scan = scan_of(out.world, lidar, noise, random);
    features.positions.push_back(std::move(position));
  }
  return out;
}

}  // namespace scanfuse::simulate
