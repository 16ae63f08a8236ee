#include "scanfuse/simulate/mesh.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::simulate {
namespace {

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                  const Surface& surface) {
  mesh.triangles.push_back({a, b, c});
  mesh.surfaces.push_back(surface);
}

Eigen::Vector3d random_direction(RandomStream& random) {
  const double z = random.uniform(-1, 1);
  const double angle = random.uniform(0, 2 * kPi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace

Polygon rounded_rectangle(double length_m, double width_m, double front_radius_m,
                          double rear_radius_m, int arcs) {
  Polygon polygon;
  const auto corner = [&](double sx, double sy, double radius, double from_rad) {
    const Eigen::Vector2d centre(sx * (length_m / 2 - radius), sy * (width_m / 2 - radius));
    for (int i = 0; i <= arcs; ++i) {
      const double a = from_rad + kPi / 2 * i / arcs;
      polygon.emplace_back(centre + radius * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
  };
  corner(1, 1, front_radius_m, 0);
  corner(-1, 1, rear_radius_m, kPi / 2);
  corner(-1, -1, rear_radius_m, kPi);
  corner(1, -1, front_radius_m, 3 * kPi / 2);
  return polygon;
}

Polygon ellipse(double length_m, double width_m, int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * kPi * i / corners;
    polygon.emplace_back(length_m / 2 * std::cos(a), width_m / 2 * std::sin(a));
  }
  return polygon;
}

Polygon inset(const Polygon& polygon, const Eigen::Vector2d& by_m) {
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
  for (const auto& p : polygon) half = half.cwiseMax(p.cwiseAbs());
  const Eigen::Vector2d scale = (half - by_m).cwiseQuotient(half);
  Polygon smaller = polygon;
  for (auto& p : smaller) p = p.cwiseProduct(scale);
  return smaller;
}

Polygon shifted(Polygon polygon, const Eigen::Vector2d& by_m) {
  for (auto& p : polygon) p += by_m;
  return polygon;
}

void add_loft(Mesh& mesh, const Polygon& low, double z_low_m, const Polygon& high, double z_high_m,
              const Surface& surface) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto n = static_cast<std::uint32_t>(std::min(low.size(), high.size()));
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.vertices.emplace_back(Eigen::Vector3d(low[i].x(), low[i].y(), z_low_m).cast<float>());
    mesh.vertices.emplace_back(Eigen::Vector3d(high[i].x(), high[i].y(), z_high_m).cast<float>());
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
    add_triangle(mesh, a, b, b + 1, surface);
    add_triangle(mesh, a, b + 1, a + 1, surface);
    if (i >= 2) {
      add_triangle(mesh, first, a, a - 2, surface);
      add_triangle(mesh, first + 1, a - 1, a + 1, surface);
    }
  }
}

void add_box(Mesh& mesh, const Pose3& pose, const Eigen::Vector3d& size_m, const Surface& surface) {
  const auto first = mesh.vertices.size();
  const double l = size_m.x() / 2, w = size_m.y() / 2, h = size_m.z() / 2;
  const Polygon base{{l, w}, {-l, w}, {-l, -w}, {l, -w}};
  add_loft(mesh, base, -h, base, h, surface);
  for (auto i = first; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] = (pose * mesh.vertices[i].cast<double>()).cast<float>();
  }
}

void add_leaves(Mesh& mesh, const Eigen::Vector3d& centre_m, const Eigen::Vector3d& radii_m,
                int facets, double facet_m, const Surface& surface, RandomStream& random) {
  for (int i = 0; i < facets; ++i) {
    const double depth = std::cbrt(random.uniform(0.1, 1.0));
    const Eigen::Vector3d at = centre_m + depth * random_direction(random).cwiseProduct(radii_m);
    const Eigen::Vector3d u = random_direction(random);
    const Eigen::Vector3d v = u.cross(random_direction(random)).normalized();
    const double size = facet_m * random.uniform(0.6, 1.4);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back((at + size * u).cast<float>());
    mesh.vertices.emplace_back((at - size / 2 * u + size * v).cast<float>());
    mesh.vertices.emplace_back((at - size / 2 * u - size * v).cast<float>());
    add_triangle(mesh, first, first + 1, first + 2, surface);
  }
}

}  // namespace scanfuse::simulate
