#include "scanfuse/simulate/scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scanfuse::simulate {
namespace {

// A beam is sampled by its middle and four rays around it: offsets in parts of the full divergence
// (azimuth, elevation), and the share of the light they carry.
struct SubRay {
  double azimuth, elevation, share;
};
constexpr std::array<SubRay, 5> kSubRays{{{0, 0, 0.36},
                                          {0.35, 0.35, 0.16},
                                          {-0.35, 0.35, 0.16},
                                          {-0.35, -0.35, 0.16},
                                          {0.35, -0.35, 0.16}}};
constexpr std::size_t kRaysPerBeam = kSubRays.size();
constexpr double kPureShare = 0.8;
constexpr double kThresholdScatter = 0.25;

Eigen::Vector3d direction(double azimuth_rad, double elevation_rad) {
  const double c = std::cos(elevation_rad);
  return {c * std::cos(azimuth_rad), c * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

/// What comes back of one beam from about one range.
struct Echo {
  double range_m = 0;
  double energy = 0;   ///< light, 1 for a white wall at 1 m
  double visible = 0;  ///< reflectivity as seen, before the range takes its part
  double last_m = 0;
  std::int32_t label = kBackground;
};

struct Glint {
  double range_m, energy, visible;
  std::int32_t label;
};

std::int32_t main_label(std::span<const Glint> glints) {
  double total = 0;
  for (const auto& g : glints) total += g.energy;
  for (const auto& g : glints) {
    double same = 0;
    for (const auto& other : glints) same += other.label == g.label ? other.energy : 0;
    if (same >= kPureShare * total) return g.label;
  }
  return kMixed;
}

Echo echo_of(std::span<const Glint> glints) {
  Echo echo;
  for (const auto& g : glints) {
    echo.range_m += g.energy * g.range_m;
    echo.energy += g.energy;
    echo.visible += g.visible;
  }
  echo.range_m /= echo.energy;
  echo.label = main_label(glints);
  return echo;
}

}  // namespace

Scanner::Scanner(const World& world, const SensorModel& model, const SimulateOptions& options,
                 std::uint64_t seed)
    : world_(&world),
      model_(model),
      options_(options),
      seed_(seed),
      vibration_(options.vibration, RandomStream(seed, 0x71b)) {
  if (options.range_noise_m >= 0) model_.sigma_range_m = options.range_noise_m;
  model_.divergence_azimuth_rad *= options.divergence;
  model_.divergence_elevation_rad *= options.divergence;
  for (int column = 0; column < model_.pattern.columns; ++column) {
    for (int layer = 0; layer < static_cast<int>(model_.layers.size()); ++layer) {
      const auto& l = model_.layers[static_cast<std::size_t>(layer)];
      const double azimuth = model_.azimuth_rad(column);
      if (azimuth >= l.from_rad && azimuth <= l.to_rad) beams_.push_back({column, layer});
    }
  }
  rays_.resize(kRaysPerBeam * beams_.size());
}

void Scanner::aim(double stamp_s) {
  const double sweep_s = std::max(model_.sweep_s(), 1e-9);
  Pose3 sensor;
  int posed = -1;
  for (std::size_t b = 0; b < beams_.size(); ++b) {
    const auto& [column, layer] = beams_[b];
    const double offset_s = model_.time_offset_s(column);
    if (column != posed) {
      const double t = stamp_s + offset_s;
      sensor = Pose3::from_planar(world_->ego.pose(t)) * vibration_.at(t) * model_.ego_from_sensor;
      posed = column;
    }
    const double azimuth = model_.azimuth_rad(column);
    const double elevation = model_.layers[static_cast<std::size_t>(layer)].elevation_rad;
    for (std::size_t i = 0; i < kRaysPerBeam; ++i) {
      const auto& sub = kSubRays[i];
      const Eigen::Vector3d d =
          sensor.rotation * direction(azimuth + sub.azimuth * model_.divergence_azimuth_rad,
                                      elevation + sub.elevation * model_.divergence_elevation_rad);
      rays_[kRaysPerBeam * b + i] = {sensor.translation_m.cast<float>(),
                                     d.normalized().cast<float>(),
                                     static_cast<float>(offset_s / sweep_s)};
    }
  }
}

// Energy of a ray's reflection: share * reflectivity * cos / r^2. An echo is found when the energy
// of its rays exceeds that of a 10 % surface at `reach_m`, give or take. Nearer rays are met first;
// rays closer together than `merge_m` are one echo at the mean of their ranges, weighted by energy:
// so returns at an edge lie between the two sides.
void Scanner::receive(std::size_t beam, std::span<const Hit> hits, std::int64_t frame,
                      RandomStream& random, Sweep& sweep) const {
  const bool lost = random.chance(options_.dropout);
  std::array<Glint, kRaysPerBeam> glints{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < kRaysPerBeam; ++i) {
    const Hit& hit = hits[i];
    if (hit.range_m < model_.pattern.min_range_m) continue;
    std::int32_t label = hit.surface.ground ? kGround : kBackground;
    if (hit.actor >= 0) {
      const auto& actor = world_->actors[static_cast<std::size_t>(hit.actor)];
      const auto& missed = actor.missed_frames;
      if (std::find(missed.begin(), missed.end(), frame) != missed.end()) continue;
      label = static_cast<std::int32_t>(actor.id);
    }
    const double visible =
        kSubRays[i].share * hit.surface.reflectivity * std::max(hit.cosine, hit.surface.rough);
    const double range = hit.range_m;
    glints[count++] = {range, visible / (range * range), visible, label};
  }
  std::sort(glints.begin(), glints.begin() + count,
            [](const Glint& a, const Glint& b) { return a.range_m < b.range_m; });
  const double threshold = 0.1 / (model_.reach_m * model_.reach_m);
  const auto& [column, layer] = beams_[beam];
  const double azimuth = model_.azimuth_rad(column);
  const Eigen::Vector3d along =
      direction(azimuth, model_.layers[static_cast<std::size_t>(layer)].elevation_rad);
  int told = 0;
  for (std::size_t first = 0, last = 0; first < count && told < model_.echoes; first = last) {
    for (last = first + 1; last < count; ++last) {
      if (glints[last].range_m - glints[last - 1].range_m > model_.merge_m) break;
    }
    const Echo echo = echo_of(std::span(glints).subspan(first, last - first));
    const double luck = std::exp(kThresholdScatter * random.normal());
    const double range = random.normal(echo.range_m, model_.sigma_range_m);
    if (lost || echo.energy * luck < threshold || range > model_.pattern.max_range_m ||
        range < model_.pattern.min_range_m) {
      continue;
    }
    const Eigen::Vector3f p = (range * along).cast<float>();
    sweep.returns.push_back({p.x(), p.y(), p.z(), static_cast<float>(100 * echo.visible),
                             static_cast<float>(model_.time_offset_s(column)), column,
                             static_cast<std::int16_t>(layer), static_cast<std::uint8_t>(told)});
    sweep.label.push_back(echo.label);
    ++told;
  }
}

// The share of the centre rays through an object's upright box that were stopped before it by
// something else. Rays that pass the object within its box are aimed at it and not stopped.
void Scanner::judge_occlusion(std::span<const Hit> hits, double stamp_s, Sweep& sweep) const {
  for (std::size_t a = 0; a < world_->actors.size(); ++a) {
    const auto& actor = world_->actors[a];
    const Pose2 from_world = actor.motion.pose(stamp_s + model_.sweep_s() / 2).inverse();
    const double c = std::cos(from_world.heading_rad), s = std::sin(from_world.heading_rad);
    const Eigen::Vector3d half(actor.length_m / 2, actor.width_m / 2, actor.height_m / 2);
    int aimed = 0, stopped = 0;
    for (std::size_t b = 0; b < beams_.size(); ++b) {
      const Ray& ray = rays_[kRaysPerBeam * b];
      const Eigen::Vector3d d = ray.direction.cast<double>();
      const Eigen::Vector2d o = from_world * ray.origin_m.head<2>().cast<double>();
      const Eigen::Vector3d origin(o.x(), o.y(), ray.origin_m.z() - half.z());
      const Eigen::Vector3d local(c * d.x() - s * d.y(), s * d.x() + c * d.y(), d.z());
      double enter = 0, leave = model_.pattern.max_range_m;
      for (int axis = 0; axis < 3 && enter < leave; ++axis) {
        const double inverse = 1 / (std::abs(local[axis]) > 1e-12 ? local[axis] : 1e-12);
        const double t0 = (-half[axis] - origin[axis]) * inverse;
        const double t1 = (half[axis] - origin[axis]) * inverse;
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
      }
      if (enter >= leave) continue;
      const Hit& hit = hits[kRaysPerBeam * b];
      ++aimed;
      stopped += hit.range_m > 0 && hit.actor != static_cast<int>(a) && hit.range_m < enter;
    }
    sweep.occluded.push_back(aimed == 0 ? 0.0 : static_cast<double>(stopped) / aimed);
  }
}

Sweep Scanner::scan(std::int64_t frame) {
  const double t = stamp_s(frame);
  if (!caster_) caster_.emplace(*world_);
  caster_->move_to(t, t + std::max(model_.sweep_s(), 1e-9));
  aim(t);
  const auto hits = caster_->cast(rays_, model_.pattern.max_range_m);
  Sweep sweep;
  RandomStream random(seed_, 0x5ca0000 + static_cast<std::uint64_t>(frame));
  for (std::size_t b = 0; b < beams_.size(); ++b) {
    receive(b, std::span(hits).subspan(kRaysPerBeam * b, kRaysPerBeam), frame, random, sweep);
  }
  sweep.visible_points.assign(world_->actors.size(), 0);
  for (std::size_t a = 0; a < world_->actors.size(); ++a) {
    sweep.visible_points[a] =
        static_cast<int>(std::count(sweep.label.begin(), sweep.label.end(), world_->actors[a].id));
  }
  judge_occlusion(hits, t, sweep);
  return sweep;
}

}  // namespace scanfuse::simulate
