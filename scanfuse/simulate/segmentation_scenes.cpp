#include "scanfuse/simulate/segmentation_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scanfuse/core/random.hpp"

namespace scanfuse::simulate {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr std::array kSceneLanes{-3.4, 0.3, 3.8};

/// Where the ray from the origin along `d` meets the segment; kNothing where it does not.
double ray_to_segment(const Eigen::Vector2d& d, const Eigen::Vector2d& a,
                      const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double cross = d.x() * along.y() - d.y() * along.x();
  if (std::abs(cross) < 1e-12) return kNothing;
  const double range = (a.x() * along.y() - a.y() * along.x()) / cross;
  const double share = (a.x() * d.y() - a.y() * d.x()) / cross;
  return range > 0 && share >= 0 && share <= 1 ? range : kNothing;
}

double ray_to_circle(const Eigen::Vector2d& d, const Eigen::Vector2d& centre, double radius) {
  const double along = d.dot(centre);
  const double inside = radius * radius - (centre.squaredNorm() - along * along);
  return along > 0 && inside >= 0 ? along - std::sqrt(inside) : kNothing;
}

double ray_to_object(const Eigen::Vector2d& d, const SceneObject& object) {
  if (object.object_class == ObjectClass::kPedestrian) {
    return ray_to_circle(d, object.box.centre_m, object.box.width_m / 2);
  }
  const auto corners = object.box.corners();
  double nearest = kNothing;
  for (std::size_t i = 0; i < 4; ++i) {
    nearest = std::min(nearest, ray_to_segment(d, corners[i], corners[(i + 1) % 4]));
  }
  return nearest;
}

double ray_to_barriers(const Eigen::Vector2d& d) {
  return std::min(ray_to_segment(d, {-10, 8}, {200, 8}), ray_to_segment(d, {-10, -8}, {200, -8}));
}

SceneObject scene_object(ObjectClass object_class, double x, double y, double heading,
                         double length, double width) {
  return {object_class, {{x, y}, heading, length, width}, 0};
}

void add_scene_vehicles(std::vector<SceneObject>& objects, RandomStream& random) {
  for (int i = 0; i < 8; ++i) {
    const bool truck = random.chance(0.15);
    const double length = truck ? 12 : random.uniform(3.8, 4.9);
    const double width = truck ? 2.5 : random.uniform(1.7, 1.95);
    const double lane = kSceneLanes[random.below(kSceneLanes.size())];
    const double y = random.normal(lane, 0.2), heading = random.normal(0, 0.06);
    const double x = random.uniform(7, 65);
    const bool free = std::none_of(objects.begin(), objects.end(), [&](const SceneObject& other) {
      return std::abs(other.box.centre_m.y() - y) < 2.5 &&
             std::abs(other.box.centre_m.x() - x) < (other.box.length_m + length) / 2 + 1.5;
    });
    if (free && x - length / 2 > 3) {
      objects.push_back(scene_object(ObjectClass::kVehicle, x, y, heading, length, width));
    }
  }
}

void add_scene_people(std::vector<SceneObject>& objects, RandomStream& random) {
  for (int i = 0; i < 6; ++i) {
    const double y = (random.chance(0.5) ? 1 : -1) * random.uniform(5.6, 7.2);
    const double size = 2 * random.uniform(0.2, 0.3);
    objects.push_back(
        scene_object(ObjectClass::kPedestrian, random.uniform(5, 35), y, 0, size, size));
  }
  for (int i = 0; i < 3; ++i) {
    const double y = random.chance(0.5) ? 6.2 : -6.2;
    objects.push_back(scene_object(ObjectClass::kCyclist, random.uniform(8, 45), y, 0, 1.8, 0.5));
  }
}

void add_scene_point(SegmentationScene& scene, double range, double bearing, int column,
                     std::int32_t label) {
  const double x = range * std::cos(bearing), y = range * std::sin(bearing);
  const auto source = static_cast<std::uint32_t>(scene.scan.points.size());
  scene.scan.points.push_back({static_cast<float>(x), static_cast<float>(y), 0,
                               static_cast<float>(range), static_cast<float>(bearing), 0, column,
                               source, 1});
  scene.label.push_back(label);
  if (label >= 0) ++scene.objects[static_cast<std::size_t>(label)].points;
}

struct Sight {
  double range = kNothing;
  std::int32_t label = -1;
};

Sight look(const Eigen::Vector2d& d, const std::vector<SceneObject>& objects) {
  Sight sight{ray_to_barriers(d), -1};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double range = ray_to_object(d, objects[i]);
    if (range < sight.range) sight = {range, static_cast<std::int32_t>(i)};
  }
  return sight;
}

/// The beam nearest the middle that sees nothing; the middle one where all see something.
int stray_column(const std::vector<Sight>& sights, double max_range_m) {
  const int count = static_cast<int>(sights.size()), middle = count / 2;
  for (int away = 0; away < count; ++away) {
    for (const int column : {middle - away, middle + away}) {
      if (column < 0 || column >= count) continue;
      if (sights[static_cast<std::size_t>(column)].range > max_range_m) return column;
    }
  }
  return middle;
}

SegmentationScene look_at(std::vector<SceneObject> objects, RandomStream random,
                          const SegmentationSceneOptions& options) {
  SegmentationScene scene;
  scene.objects = std::move(objects);
  scene.scan.step_rad = options.field_of_view_rad / (options.beams - 1);
  scene.scan.sigma_range_m = options.range_noise_m;
  const auto bearing_of = [&](int column) {
    return -options.field_of_view_rad / 2 + column * scene.scan.step_rad;
  };
  std::vector<Sight> sights;
  for (int column = 0; column < options.beams; ++column) {
    const double bearing = bearing_of(column);
    sights.push_back(look({std::cos(bearing), std::sin(bearing)}, scene.objects));
  }
  const int stray = options.stray_return ? stray_column(sights, options.max_range_m) : -1;
  for (int column = 0; column < options.beams; ++column) {
    const auto& [range, label] = sights[static_cast<std::size_t>(column)];
    const double noise = options.range_noise_m * random.normal();
    if (column == stray) {
      add_scene_point(scene, 195, bearing_of(column), column, -1);
    } else if (range <= options.max_range_m) {
      add_scene_point(scene, range + noise, bearing_of(column), column, label);
    }
  }
  return scene;
}

}  // namespace

SegmentationScene segmentation_scene(std::uint64_t seed, const SegmentationSceneOptions& options) {
  RandomStream random(seed, 0x5e6);
  std::vector<SceneObject> objects;
  add_scene_vehicles(objects, random);
  add_scene_people(objects, random);
  return look_at(std::move(objects), RandomStream(seed, 0x5e7), options);
}

SegmentationScene range_ladder_scene(double range_m, std::uint64_t seed,
                                     const SegmentationSceneOptions& options) {
  RandomStream random(seed, 0x1add);
  const double length = random.uniform(3.8, 4.9), width = random.uniform(1.7, 1.95);
  const double y = random.normal(kSceneLanes[random.below(kSceneLanes.size())], 0.2);
  const double heading = random.normal(0, 0.06);
  return look_at({scene_object(ObjectClass::kVehicle, range_m, y, heading, length, width)},
                 RandomStream(seed, 0x1ade), options);
}

}  // namespace scanfuse::simulate
