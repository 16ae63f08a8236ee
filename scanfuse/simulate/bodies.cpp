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

/// How a body is built and dressed is drawn from a stream of its own, which leaves the scene's as
/// it was: what stands where does not depend on it.
RandomStream stream_of_build(std::int64_t id, const RandomStream& random) {
  RandomStream copy = random;
  return RandomStream(copy.next(), static_cast<std::uint64_t>(id));
}

/// A pair of limbs, left and right of the body's middle, that swing about their joints.
struct Limbs {
  Eigen::Vector3d left_joint_m;
  double length_m = 0, thickness_m = 0, swing_rad = 0, rate_rad_per_s = 0;
  double right_phase_rad = 0, left_phase_rad = 0;
};

void add_limbs(Actor& actor, const Limbs& pair, const Surface& surface) {
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d joint = pair.left_joint_m.cwiseProduct(Eigen::Vector3d(1, side, 1));
    actor.parts.push_back(limb(joint, pair.length_m, pair.thickness_m, pair.swing_rad,
                               pair.rate_rad_per_s,
                               side > 0 ? pair.left_phase_rad : pair.right_phase_rad, surface));
  }
}

/// Torso and head; a coat or skirt over the thighs and a rucksack as people have them.
Part trunk(double h, const Surface& cloth, RandomStream& build) {
  const double hip = 0.5 * h, shoulder = 0.82 * h;
  const double depth = build.uniform(0.19, 0.34), breadth = build.uniform(0.36, 0.54);
  Part part;
  add_loft(part.mesh, ellipse(0.9 * depth, 0.8 * breadth), hip, ellipse(depth, breadth), shoulder,
           cloth);
  add_loft(part.mesh, ellipse(0.18, 0.16), shoulder, ellipse(0.16, 0.14), h, cloth);
  if (build.chance(0.2)) {
    const double hem = build.uniform(0.12, 0.4) * h, flare = build.uniform(1.0, 1.4);
    add_loft(part.mesh, ellipse(flare * depth, flare * 0.85 * breadth), hem,
             ellipse(0.9 * depth, 0.8 * breadth), hip, cloth);
  }
  if (build.chance(0.2)) {
    const double deep = build.uniform(0.1, 0.25);
    add_box(part.mesh, at(-depth / 2 - deep / 2, 0, 0.68 * h), {deep, 0.3, 0.28 * h}, cloth);
  }
  return part;
}

/// Breadth and thickness are drawn here. One of five does not swing the arms; of these half carry
/// a bag.
void add_arms(Actor& person, Limbs arms, const Surface& cloth, RandomStream& build) {
  arms.thickness_m = build.uniform(0.08, 0.13);
  const double apart = build.uniform(0.2, 0.29), shoulder = arms.left_joint_m.z();
  arms.left_joint_m.y() = apart;
  const bool still = build.chance(0.2);
  if (still) arms.swing_rad = 0;
  add_limbs(person, arms, cloth);
  if (!still || build.chance(0.5)) return;
  Part bag;
  add_box(bag.mesh, at(0, build.chance(0.5) ? apart : -apart, 0.33 * shoulder + 0.1),
          {build.uniform(0.25, 0.45), build.uniform(0.1, 0.22), build.uniform(0.25, 0.5)}, cloth);
  person.parts.push_back(std::move(bag));
}

struct Bicycle {
  double wheel_m = 0.34, half_base_m = 0.54, bar_m = 0.54;
};

/// Frame, wheels, handlebar; bags beside the rear wheel and a basket in front as some have them.
void add_bicycle(Mesh& mesh, const Bicycle& bicycle, RandomStream& build) {
  const Surface metal{0.35F, 0.2F, false}, bag{0.3F, 0.3F, false};
  add_rim(mesh, -bicycle.half_base_m, bicycle.wheel_m, metal);
  add_rim(mesh, bicycle.half_base_m, bicycle.wheel_m, metal);
  add_box(mesh, at(0, 0, 0.72), {0.75, 0.05, 0.06}, metal);
  add_box(mesh, at(0.1, 0, 0.5, 0.7), {0.06, 0.05, 0.6}, metal);
  add_box(mesh, at(-0.15, 0, 0.55, 0.25), {0.06, 0.05, 0.65}, metal);
  add_box(mesh, at(0.45, 0, 0.65, -0.3), {0.05, 0.05, 0.7}, metal);
  add_box(mesh, at(0.38, 0, 1.0), {0.05, bicycle.bar_m, 0.05}, metal);
  if (build.chance(0.3)) {
    for (const double side : {-0.16, 0.16}) {
      add_box(mesh, at(-bicycle.half_base_m, side, 0.6), {0.35, 0.14, 0.35}, bag);
    }
  }
  if (build.chance(0.2)) add_box(mesh, at(0.55, 0, 0.9), {0.3, 0.35, 0.25}, bag);
}

/// From the saddle up: upright on a city bicycle to bent on a racing one, hands on the bar. Gives
/// the height of the crown.
double add_upper_body(Mesh& mesh, const Bicycle& bicycle, double h, const Surface& cloth,
                      RandomStream& build) {
  const double lean = build.uniform(0.1, 0.8), depth = build.uniform(0.2, 0.3);
  const double breadth = build.uniform(0.36, 0.5), torso = 0.6;
  const Eigen::Vector3d seat(-0.15, 0, 0.88), bar(0.38, bicycle.bar_m / 2 - 0.04, 1.02);
  const Eigen::Vector3d neck = seat + torso * Eigen::Vector3d(std::sin(lean), 0, std::cos(lean));
  const Eigen::Vector3d middle = (seat + neck) / 2;
  add_box(mesh, at(middle.x(), 0, middle.z(), lean), {depth, breadth, torso}, cloth);
  const double crown = neck.z() + 0.16 * h;
  add_loft(mesh, shifted(ellipse(0.2, 0.17), {neck.x() + 0.05, 0}), neck.z(),
           shifted(ellipse(0.18, 0.15), {neck.x() + 0.05, 0}), crown, cloth);
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d shoulder(neck.x(), side * breadth / 2, neck.z() - 0.05);
    const Eigen::Vector3d hand(bar.x(), side * bar.y(), bar.z());
    const Eigen::Vector3d arm = hand - shoulder;
    const Eigen::Quaterniond turn = turn_z_to(arm);
    add_box(mesh, {turn, (shoulder + hand) / 2}, {0.09, 0.09, arm.norm()}, cloth);
  }
  return crown;
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
  const double h = random.uniform(1.55, 1.9);
  const Surface cloth{static_cast<float>(random.uniform(0.15, 0.6)), 0.3F, false};
  const double rate = kPi * steps_per_s, phase = random.uniform(0, 2 * kPi);
  RandomStream build = stream_of_build(id, random);
  Actor person{id, ObjectClass::kPedestrian, 0.5, 0.6, h, ellipse(0.5, 0.6), {}, {}, {}};
  person.parts.push_back(trunk(h, cloth, build));
  const double leg_swing = steps_per_s > 0 ? radians(build.uniform(18, 30)) : 0;
  const double leg = build.uniform(0.11, 0.19), hip = 0.5 * h;
  add_limbs(person,
            {{0, build.uniform(0.07, 0.14), hip}, hip, leg, leg_swing, rate, phase, phase + kPi},
            cloth);
  const double arm_swing = steps_per_s > 0 ? radians(build.uniform(5, 30)) : 0;
  const double shoulder = 0.82 * h;
  add_arms(person, {{0, 0, shoulder}, 0.46 * shoulder, 0, arm_swing, rate, phase + kPi, phase},
           cloth, build);
  return person;
}

Actor make_cyclist(std::int64_t id, RandomStream& random) {
  const double h = random.uniform(1.6, 1.8);
  const Surface cloth{static_cast<float>(random.uniform(0.2, 0.6)), 0.3F, false};
  const double cadence = 2 * kPi * random.uniform(0.8, 1.3), phase = random.uniform(0, 2 * kPi);
  RandomStream build = stream_of_build(id, random);
  const Bicycle bicycle{build.uniform(0.3, 0.36), build.uniform(0.48, 0.58),
                        build.uniform(0.42, 0.68)};
  const double length = 2 * (bicycle.half_base_m + bicycle.wheel_m);
  Actor rider{id, ObjectClass::kCyclist, length, 0.55, h, ellipse(length, 0.55), {}, {}, {}};
  Part whole;
  add_bicycle(whole.mesh, bicycle, build);
  rider.height_m = add_upper_body(whole.mesh, bicycle, h, cloth, build);
  rider.parts.push_back(std::move(whole));
  const double thickness = build.uniform(0.12, 0.18), apart = build.uniform(0.09, 0.14);
  add_limbs(rider,
            {{-0.12, apart, 0.92}, 0.75, thickness, radians(28), cadence, phase, phase + kPi},
            cloth);
  return rider;
}

}  // namespace scanfuse::simulate
