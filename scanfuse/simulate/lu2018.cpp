#include <cmath>

#include "scanfuse/simulate/bodies.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"
#include "scanfuse/simulate/silhouette.hpp"

namespace scanfuse::simulate {
namespace {

constexpr double kPeriod = 0.08;   ///< of the LUX
constexpr double kLeftLane = 3.4;  ///< middle of the lane left of the ego car's, at y = 0
const double kViewEdge = radians(50);

/// When the beam at a bearing is fired in a frame; `frame` may be between two.
double beam_time(const SensorModel& lux, double frame, double bearing_rad) {
  const double column = (bearing_rad - lux.pattern.first_azimuth_rad) / lux.pattern.step_rad;
  return frame * kPeriod + lux.time_offset_s(static_cast<int>(std::lround(column)));
}

/// The drive of the ego car and its sensor's planar pose.
struct Drive {
  SensorModel lux = sensor_model(SensorPreset::kLux);
  PlanarMotion ego;

  [[nodiscard]] Pose2 sensor(double t_s) const {
    return ego.pose(t_s) * lux.ego_from_sensor.planar();
  }
};

/// Knots of a motion along the road, told relative to the sensor: frame, metres ahead.
struct Ahead {
  double frame, metres;
};

Spline along_road(const Drive& drive, const std::vector<Ahead>& knots, double shift_m) {
  std::vector<double> times, values;
  for (const auto& [frame, metres] : knots) {
    times.push_back(frame * kPeriod);
    values.push_back(drive.sensor(frame * kPeriod).x_m + metres + shift_m);
  }
  return {times, values};
}

/// A smooth change of lane in y, with a level run before and after.
Spline lane_change(double from_y_m, double to_y_m, double middle_s, double lasts_s) {
  std::vector<double> times{-10.0, middle_s - lasts_s}, values{from_y_m, from_y_m};
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    times.push_back(middle_s + (u - 0.5) * lasts_s);
    values.push_back(from_y_m + (to_y_m - from_y_m) * u * u * u * (10 + u * (6 * u - 15)));
  }
  times.insert(times.end(), {middle_s + lasts_s, middle_s + lasts_s + 60});
  values.insert(values.end(), {to_y_m, to_y_m});
  return {times, values};
}

Spline constant(double value) { return Spline({0, 1}, {value, value}); }

PlanarMotion ego_drive(double speed_m_per_s, double change, RandomStream& random) {
  std::vector<double> times, xs;
  double x = 0, speed = speed_m_per_s;
  for (double t = 0; t <= 20; t += 2) {
    times.push_back(t);
    xs.push_back(x);
    x += 2 * speed;
    speed = speed_m_per_s + random.uniform(-change, change);
  }
  return {Spline(times, xs), constant(0), std::nullopt};
}

World campus_road(int frames, RandomStream& random) {
  World world;
  world.frames = frames;
  RoadOptions road;
  road.from_x_m = -20;
  road.to_x_m = 10 * frames * kPeriod + 110;
  add_road(world.fixed, road, random);
  return world;
}

Actor car(std::int64_t id, RandomStream& random) {
  return make_car(id, random_car_size(random), random);
}

/// Moves the knots along the road until the car's foremost edge lies on the left edge of the field
/// of view halfway between the frame before `frame` and `frame`.
Spline meets_view_edge(const Drive& drive, const Actor& actor, const Spline& y,
                       const std::vector<Ahead>& knots, double frame) {
  const double t = beam_time(drive.lux, frame - 0.5, kViewEdge);
  const double shift = find_zero(
      [&](double shift_m) {
        const PlanarMotion motion{along_road(drive, knots, shift_m), y, std::nullopt};
        return kViewEdge - silhouette(actor.footprint, motion.pose(t), drive.sensor(t)).right_rad;
      },
      -20, 20);
  return along_road(drive, knots, shift);
}

/// As above for two crossings of the edge: coming in and falling back. The knots in between move
/// along, so the drive keeps its shape.
Spline visits_view(const Drive& drive, const Actor& actor, const Spline& y, double enter,
                   double leave, double most_m) {
  std::vector<Ahead> knots{{enter - 40, -9},     {enter, 0},           {enter + 25, 5.5},
                           {enter + 50, most_m}, {leave - 46, most_m}, {leave - 22, 5},
                           {leave, 0},           {leave + 40, -11}};
  double late = 0, early = 0;
  for (int round = 0; round < 20; ++round) {
    const auto edge = [&](double frame, double& moved, std::size_t knot) {
      const double t = beam_time(drive.lux, frame - 0.5, kViewEdge);
      const double at = find_zero(
          [&](double shift_m) {
            auto tried = knots;
            tried[knot].metres += shift_m;
            const PlanarMotion motion{along_road(drive, tried, 0), y, std::nullopt};
            return kViewEdge -
                   silhouette(actor.footprint, motion.pose(t), drive.sensor(t)).right_rad;
          },
          -8, 8);
      knots[knot].metres += at;
      moved = at;
    };
    edge(enter, early, 1);
    edge(leave, late, 6);
    if (std::abs(early) + std::abs(late) < 1e-9) break;
  }
  return along_road(drive, knots, 0);
}

}  // namespace

World lu2018_1(RandomStream random) {
  World world = campus_road(190, random);
  Drive drive;
  drive.ego = world.ego = ego_drive(random.uniform(8, 9.5), 0.3, random);

  Actor first = car(1, random);
  const double gap = random.uniform(12, 15);
  first.motion = {
      along_road(drive, {{0, gap}, {60, gap + 2.5}, {120, gap + 5}, {190, gap + 4}, {230, gap + 3}},
                 first.length_m / 2),
      constant(random.uniform(-0.4, 0.1)), std::nullopt};
  first.missed_frames = {102, 148, 172, 177};

  Actor second = car(2, random);
  const Spline y = constant(kLeftLane + random.uniform(-0.15, 0.25));
  second.motion = {visits_view(drive, second, y, 26, 147, random.uniform(11, 14)), y, std::nullopt};
  world.actors = {std::move(first), std::move(second)};
  return world;
}

World lu2018_3(RandomStream random) {
  World world = campus_road(120, random);
  Drive drive;
  drive.ego = world.ego = ego_drive(random.uniform(8, 9.5), 0.3, random);

  Actor leaver = car(1, random);
  const Spline y = constant(kLeftLane + random.uniform(-0.1, 0.25));
  leaver.motion = {meets_view_edge(drive, leaver, y, {{-20, 6.5}, {0, 3.4}, {16, 0}, {50, -8}}, 16),
                   y, std::nullopt};
  Actor ahead = car(2, random);
  const double gap = random.uniform(12, 16);
  ahead.motion = {along_road(drive, {{0, gap}, {60, gap + 2}, {130, gap + 3}}, ahead.length_m / 2),
                  constant(random.uniform(-0.4, 0.1)), std::nullopt};
  Actor left = car(3, random);
  const double far = random.uniform(18, 24);
  left.motion = {along_road(drive, {{0, far}, {60, far - 2}, {130, far - 3}}, left.length_m / 2),
                 constant(kLeftLane + random.uniform(-0.2, 0.2)), std::nullopt};
  world.actors = {std::move(leaver), std::move(ahead), std::move(left)};
  return world;
}

// Three events, three unknowns: how far along the road target 2 runs (enters at 51), when it
// changes lane (target 1 covered from 62) and when the ego car, cut off, draws to the left (target
// 1 seen again from 75).
World lu2018_2(RandomStream random) {
  World world = campus_road(140, random);
  Drive drive;
  Actor first = car(1, random);
  Actor second = car(2, random);
  const double ego_speed = random.uniform(7, 8);
  const double gap = random.uniform(28, 31);
  const double first_y = random.uniform(0.6, 0.9);
  const double from_y = kLeftLane + random.uniform(-0.1, 0.1);
  const double to_y = random.uniform(-0.35, -0.15);

  const auto place = [&](double change_s, double ego_s) {
    drive.ego = {Spline({0, 1}, {0, ego_speed}), lane_change(0, 1.7, ego_s, 2.4), std::nullopt};
    first.motion = {
        along_road(drive, {{0, gap}, {60, gap + 1}, {140, gap + 2}}, first.length_m / 2),
        constant(first_y), std::nullopt};
    const Spline y = lane_change(from_y, to_y, change_s, 3.0);
    second.motion = {
        meets_view_edge(drive, second, y,
                        {{0, -20}, {30, -8.4}, {51, 0}, {62, 4.4}, {80, 9.6}, {110, 13}, {150, 14}},
                        51),
        y, std::nullopt};
  };
  const auto seen = [&](const Actor& actor, double frame) {
    const double t = beam_time(drive.lux, frame, 0);
    return silhouette(actor.footprint, actor.motion.pose(t), drive.sensor(t));
  };
  const auto covers_at_62 = [&](double ego_s) {
    return find_zero(
        [&](double change_s) {
          place(change_s, ego_s);
          return seen(second, 61.5).right_rad - seen(first, 61.5).right_rad;
        },
        57 * kPeriod - 2, 57 * kPeriod + 2);
  };
  const double ego_s = find_zero(
      [&](double tried_s) {
        place(covers_at_62(tried_s), tried_s);
        return seen(second, 74.5).left_rad - seen(first, 74.5).left_rad;
      },
      66 * kPeriod - 1.5, 66 * kPeriod + 2.0);
  place(covers_at_62(ego_s), ego_s);
  world.ego = drive.ego;
  world.actors = {std::move(first), std::move(second)};
  return world;
}

}  // namespace scanfuse::simulate
