#include "scanfuse/simulate/bodies.hpp"

#include <cmath>

namespace scanfuse::simulate {
namespace {

Pose3 at(double x_m, double y_m, double z_m, double pitch_rad = 0) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY())),
          {x_m, y_m, z_m}};
}

void add_wheels(Mesh& mesh, double length_m, double width_m) {
  const Surface tyre{0.08F, 0.2F, false};
  for (const double x : {-0.29 * length_m, 0.31 * length_m}) {
    for (const double side : {-1.0, 1.0}) {
      add_box(mesh, at(x, side * (width_m / 2 - 0.15), 0.28), {0.5, 0.2, 0.54}, tyre);
    }
  }
}

/// A limb that hangs from a joint and swings about it.
Part limb(const Eigen::Vector3d& joint_m, double length_m, double thickness_m, double swing_rad,
          double rate_rad_per_s, double phase_rad, const Surface& surface) {
  Part part;
  const Polygon section = ellipse(thickness_m, thickness_m, 8);
  add_loft(part.mesh, inset(section, {0.02, 0.02}), -length_m, section, 0, surface);
  part.pose = [=](double t_s) {
    const double angle = swing_rad * std::sin(rate_rad_per_s * t_s + phase_rad);
    return at(joint_m.x(), joint_m.y(), joint_m.z(), angle);
  };
  return part;
}

void add_rim(Mesh& mesh, double x_m, double radius_m, const Surface& surface) {
  constexpr int kPieces = 14;
  for (int i = 0; i < kPieces; ++i) {
    const double a = 2 * kPi * i / kPieces;
    add_box(mesh, at(x_m + radius_m * std::cos(a), 0, radius_m + radius_m * std::sin(a), -a),
            {0.05, 0.045, 2.1 * radius_m * std::sin(kPi / kPieces)}, surface);
  }
  add_box(mesh, at(x_m, 0, radius_m), {0.08, 0.1, 0.08}, surface);
}

}  // namespace

CarSize random_car_size(RandomStream& random) {
  return {random.uniform(3.8, 4.9), random.uniform(1.65, 1.95), random.uniform(1.4, 1.7)};
}

Actor make_car(std::int64_t id, const CarSize& size, RandomStream& random) {
  const double l = size.length_m, w = size.width_m;
  const Surface paint{static_cast<float>(random.uniform(0.25, 0.75)), 0.12F, false};
  const Surface glass{0.12F, 0.05F, false};
  const bool hatchback = random.chance(0.5);
  const double belt = std::max(0.9, 0.6 * size.height_m);

  Actor car{id, ObjectClass::kVehicle, l, w, size.height_m, {}, {}, {}, {}};
  car.footprint = rounded_rectangle(l, w, random.uniform(0.25, 0.4), random.uniform(0.15, 0.3));
  Part body;
  add_loft(body.mesh, inset(car.footprint, {0.06, 0.06}), 0.2, car.footprint, 0.4, paint);
  add_loft(body.mesh, car.footprint, 0.4, car.footprint, 0.65, paint);
  add_loft(body.mesh, car.footprint, 0.65, inset(car.footprint, {0.06, 0.04}), belt, paint);
  const double rear = hatchback ? -0.48 * l : -0.38 * l;
  const double roof_rear = hatchback ? -0.44 * l : -0.26 * l;
  const double front = 0.22 * l, roof_front = 0.04 * l;
  const auto cabin = rounded_rectangle(front - rear, 0.9 * w, 0.12, 0.12);
  const auto roof = rounded_rectangle(roof_front - roof_rear, 0.76 * w, 0.12, 0.12);
  add_loft(body.mesh, shifted(cabin, {(front + rear) / 2, 0}), belt,
           shifted(roof, {(roof_front + roof_rear) / 2, 0}), size.height_m, glass);
  add_wheels(body.mesh, l, w);
  car.parts.push_back(std::move(body));
  return car;
}

Actor make_van(std::int64_t id, RandomStream& random) {
  const double l = random.uniform(4.4, 6.0), w = random.uniform(1.85, 2.1);
  const double h = random.uniform(1.9, 2.7);
  const Surface paint{static_cast<float>(random.uniform(0.25, 0.75)), 0.12F, false};
  Actor van{id, ObjectClass::kVehicle, l, w, h, {}, {}, {}, {}};
  van.footprint = rounded_rectangle(l, w, random.uniform(0.2, 0.35), random.uniform(0.05, 0.15));
  Part body;
  add_loft(body.mesh, inset(van.footprint, {0.05, 0.05}), 0.2, van.footprint, 0.4, paint);
  add_loft(body.mesh, van.footprint, 0.4, van.footprint, 1.0, paint);
  const double slope = random.uniform(0.5, 1.1);  // of the windscreen
  const auto roof = rounded_rectangle(l - slope, 0.92 * w, 0.2, 0.1);
  add_loft(body.mesh, van.footprint, 1.0, shifted(roof, {-slope / 2, 0}), h, paint);
  add_wheels(body.mesh, l, w);
  van.parts.push_back(std::move(body));
  return van;
}

Actor make_truck(std::int64_t id, RandomStream& random) {
  const double l = random.uniform(7, 12), w = 2.5, h = random.uniform(3, 3.8);
  const Surface paint{static_cast<float>(random.uniform(0.3, 0.7)), 0.12F, false};
  Actor truck{id, ObjectClass::kVehicle, l, w, h, {}, {}, {}, {}};
  truck.footprint = rounded_rectangle(l, w, 0.15, 0.05);
  Part body;
  add_box(body.mesh, at(-1.1, 0, (0.9 + h) / 2), {l - 2.2, w, h - 0.9}, paint);
  add_loft(body.mesh, shifted(rounded_rectangle(2.0, w, 0.15, 0.05), {l / 2 - 1, 0}), 0.35,
           shifted(rounded_rectangle(2.0, w - 0.1, 0.15, 0.05), {l / 2 - 1, 0}), 0.8 * h, paint);
  add_box(body.mesh, at(-1.1, 0, 0.7), {l - 2.6, w - 0.5, 0.4}, paint);
  add_box(body.mesh, at(-l / 2 + 0.15, 0, 0.5), {0.1, w - 0.2, 0.2}, paint);
  add_wheels(body.mesh, l, w);
  truck.parts.push_back(std::move(body));
  return truck;
}

Actor make_pedestrian(std::int64_t id, double steps_per_s, RandomStream& random) {
  const double h = random.uniform(1.55, 1.9), hip = 0.5 * h, shoulder = 0.82 * h;
  const Surface cloth{static_cast<float>(random.uniform(0.15, 0.6)), 0.3F, false};
  Actor person{id, ObjectClass::kPedestrian, 0.5, 0.6, h, ellipse(0.5, 0.6), {}, {}, {}};
  Part torso;
  add_loft(torso.mesh, ellipse(0.24, 0.36), hip, ellipse(0.28, 0.46), shoulder, cloth);
  add_loft(torso.mesh, ellipse(0.18, 0.16), shoulder, ellipse(0.16, 0.14), h, cloth);
  person.parts.push_back(std::move(torso));
  const double rate = kPi * steps_per_s, phase = random.uniform(0, 2 * kPi);
  const double swing = steps_per_s > 0 ? radians(24) : 0;
  for (const double side : {-1.0, 1.0}) {
    const double turn = phase + (side > 0 ? kPi : 0);
    person.parts.push_back(limb({0, side * 0.1, hip}, hip, 0.16, swing, rate, turn, cloth));
    person.parts.push_back(
        limb({0, side * 0.26, shoulder}, 0.38 * h, 0.1, swing, rate, turn + kPi, cloth));
  }
  return person;
}

Actor make_cyclist(std::int64_t id, RandomStream& random) {
  const double h = random.uniform(1.6, 1.8), wheel = 0.34, half = 0.54;
  const Surface metal{0.35F, 0.2F, false};
  const Surface cloth{static_cast<float>(random.uniform(0.2, 0.6)), 0.3F, false};
  Actor rider{id, ObjectClass::kCyclist, 2 * (half + wheel), 0.55, h, ellipse(1.76, 0.55), {}, {},
              {}};
  Part bike;
  add_rim(bike.mesh, -half, wheel, metal);
  add_rim(bike.mesh, half, wheel, metal);
  add_box(bike.mesh, at(0, 0, 0.72), {0.75, 0.05, 0.06}, metal);
  add_box(bike.mesh, at(0.1, 0, 0.5, 0.7), {0.06, 0.05, 0.6}, metal);
  add_box(bike.mesh, at(-0.15, 0, 0.55, 0.25), {0.06, 0.05, 0.65}, metal);
  add_box(bike.mesh, at(0.45, 0, 0.65, -0.3), {0.05, 0.05, 0.7}, metal);
  add_box(bike.mesh, at(0.38, 0, 1.0), {0.05, 0.54, 0.05}, metal);
  add_box(bike.mesh, at(0.02, 0, 1.15, 0.45), {0.24, 0.42, 0.62}, cloth);
  add_loft(bike.mesh, shifted(ellipse(0.2, 0.17), {0.2, 0}), h - 0.28,
           shifted(ellipse(0.18, 0.15), {0.2, 0}), h, cloth);
  rider.parts.push_back(std::move(bike));
  const double cadence = 2 * kPi * random.uniform(0.8, 1.3), phase = random.uniform(0, 2 * kPi);
  for (const double side : {-1.0, 1.0}) {
    rider.parts.push_back(limb({-0.12, side * 0.11, 0.92}, 0.75, 0.15, radians(28), cadence,
                               phase + (side > 0 ? kPi : 0), cloth));
  }
  return rider;
}

}  // namespace scanfuse::simulate
