#include "scanfuse/simulate/turntable_scene.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::simulate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Integral from 0 of the square wave that is +1 on [0, 1), -1 on [1, 2), and so on.
double wave_integral(double t) {
  const double phase = t - 2 * std::floor(t / 2);
  return phase < 1 ? phase : 2 - phase;
}

/// Mean of the square wave over [t - half, t + half].
double wave_mean(double t, double half) {
  return (wave_integral(t + half) - wave_integral(t - half)) / (2 * half);
}

/// Share of [t - half, t + half] that lies in [low, high].
double share_within(double t, double half, double low, double high) {
  const double overlap = std::min(t + half, high) - std::max(t - half, low);
  return std::clamp(overlap / (2 * half), 0.0, 1.0);
}

}  // namespace

TurntableScene::Surface TurntableScene::surface_of(const WorldRectangle& rectangle, double albedo) {
  const Eigen::Matrix3d R = rectangle.camera_from_rectangle.rotation.toRotationMatrix();
  return {rectangle.camera_from_rectangle.translation_m,
          R.col(0),
          R.col(1),
          R.col(2),
          rectangle.low_m,
          rectangle.high_m,
          0,
          albedo};
}

TurntableScene::TurntableScene(const TurntableWorld& world, const SceneAlbedo& albedo,
                               const WorldDisc* disc)
    : boards_(world.boards), albedo_(albedo) {
  for (std::size_t b = 0; b < 2; ++b) {
    surfaces_.push_back(surface_of(world.board_rectangle(b), albedo.white));
  }
  for (const auto& rectangle : world.surroundings) {
    surfaces_.push_back(surface_of(rectangle, albedo.rest));
  }
  if (disc == nullptr) return;
  // In front of the bare wall, as the target was measured: the rest is carried away.
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (i != 2) surfaces_[i].high = surfaces_[i].low.array() - 1;
  }
  const Vector2d corner = Vector2d::Constant(disc->radius_m);
  surfaces_.push_back(surface_of({disc->camera_from_disc, -corner, corner}, disc->albedo));
  surfaces_.back().radius_m = disc->radius_m;
}

double TurntableScene::distance(const Surface& s, const Vector3d& origin,
                                const Vector3d& ray) const {
  const double distance = s.normal.dot(s.origin - origin) / s.normal.dot(ray);
  if (!(distance > 0)) return std::numeric_limits<double>::infinity();
  const Vector3d at = origin + distance * ray - s.origin;
  const Vector2d p(s.x.dot(at), s.y.dot(at));
  const bool inside =
      s.radius_m > 0 ? p.norm() <= s.radius_m
                     : (p.array() >= s.low.array()).all() && (p.array() <= s.high.array()).all();
  return inside ? distance : std::numeric_limits<double>::infinity();
}

TurntableScene::Hit TurntableScene::cast(const Vector3d& origin, const Vector3d& ray) const {
  Hit hit{std::numeric_limits<double>::infinity(), -1};
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double d = distance(surfaces_[i], origin, ray);
    if (d < hit.distance_m) hit = {d, static_cast<int>(i)};
  }
  return hit.surface < 0 ? Hit{} : hit;
}

bool TurntableScene::sees(const Vector3d& from, const Vector3d& to) const {
  const Vector3d step = to - from;
  const double length = step.norm();
  const Hit hit = cast(from, step / length);
  return hit.surface < 0 || hit.distance_m > length - 1e-4;
}

double TurntableScene::albedo(int surface, const Vector3d& point, const Vector2d& spread_m) const {
  const Surface& s = surfaces_[static_cast<std::size_t>(surface)];
  if (surface > 1) return s.albedo;
  const BoardSpec& board = boards_[static_cast<std::size_t>(surface)];
  const Vector3d at = point - s.origin;
  const double u = s.x.dot(at) / board.square_m, v = s.y.dot(at) / board.square_m;
  const Vector2d half = (spread_m / board.square_m).cwiseMax(1e-6);
  // The square between the first four corners is black.
  const double checker = wave_mean(u, half.x()) * wave_mean(v, half.y());
  const double on_squares =
      share_within(u, half.x(), -1, board.columns) * share_within(v, half.y(), -1, board.rows);
  const double black = on_squares * (0.5 + 0.5 * checker);
  return albedo_.white + (albedo_.black - albedo_.white) * black;
}

Vector3d TurntableScene::normal(int surface) const {
  return surfaces_[static_cast<std::size_t>(surface)].normal;
}

}  // namespace scanfuse::simulate
