#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::simulate {

/// What a triangle is made of: decides how much light comes back and what its label is.
struct Surface {
  float reflectivity = 0.3F;  ///< of a Lambertian surface seen straight on, 0..1
  float rough = 0.1F;         ///< lower bound of the cosine at grazing incidence
  bool ground = false;
};

/// Triangles in metres. `surfaces` has one entry per triangle.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Surface> surfaces;
};

/// Corners of a convex polygon in the plane, counter-clockwise.
using Polygon = std::vector<Eigen::Vector2d>;

/// A rectangle around the origin, long along x, with rounded corners of their own radius in front
/// (x > 0) and behind.
[[nodiscard]] Polygon rounded_rectangle(double length_m, double width_m, double front_radius_m,
                                        double rear_radius_m, int arcs = 3);
[[nodiscard]] Polygon ellipse(double length_m, double width_m, int corners = 10);
/// Shrunk about the origin by as many metres along each axis as stand in `by_m`.
[[nodiscard]] Polygon inset(const Polygon& polygon, const Eigen::Vector2d& by_m);
[[nodiscard]] Polygon shifted(Polygon polygon, const Eigen::Vector2d& by_m);

/// The solid between two convex polygons with equally many corners at two heights.
void add_loft(Mesh& mesh, const Polygon& low, double z_low_m, const Polygon& high, double z_high_m,
              const Surface& surface);
/// A box of the given full size, centred on `pose`.
void add_box(Mesh& mesh, const Pose3& pose, const Eigen::Vector3d& size_m, const Surface& surface);
/// A loose cloud of small randomly turned facets inside an ellipsoid: leaves. Rays enter it to
/// various depths and some pass.
void add_leaves(Mesh& mesh, const Eigen::Vector3d& centre_m, const Eigen::Vector3d& radii_m,
                int facets, double facet_m, const Surface& surface, RandomStream& random);

}  // namespace scanfuse::simulate
