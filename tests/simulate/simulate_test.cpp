#include "scanfuse/simulate/simulate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include "scanfuse/simulate/mesh.hpp"
#include "scanfuse/simulate/scanner.hpp"
#include "scanfuse/simulate/silhouette.hpp"

namespace scanfuse::simulate {
namespace {

Simulation simulation(std::string_view scenario, std::uint64_t seed, int frames,
                      SensorPreset sensor = SensorPreset::kLux) {
  SimulateOptions options;
  options.sensor = sensor;
  options.frames = frames;
  auto made = Simulation::create(scenario, seed, options);
  EXPECT_TRUE(made.has_value());
  return std::move(*made);
}

bool same_returns(const Scan& a, const Scan& b) {
  if (a.returns.size() != b.returns.size()) return false;
  for (std::size_t i = 0; i < a.returns.size(); ++i) {
    const Return &p = a.returns[i], &q = b.returns[i];
    if (p.x_m != q.x_m || p.y_m != q.y_m || p.z_m != q.z_m || p.intensity != q.intensity ||
        p.beam != q.beam || p.layer != q.layer || p.echo != q.echo) {
      return false;
    }
  }
  return true;
}

TEST(Simulation, GivesTheSameScansForTheSameSeedAndOthersForAnother) {
  auto a = simulation("lu2018-1", 5, 4), b = simulation("lu2018-1", 5, 4);
  auto c = simulation("lu2018-1", 6, 4);
  for (int i = 0; i < 4; ++i) {
    const auto fa = a.next(), fb = b.next(), fc = c.next();
    EXPECT_TRUE(same_returns(fa->scan, fb->scan));
    EXPECT_FALSE(same_returns(fa->scan, fc->scan));
    EXPECT_EQ(fa->label, fb->label);
    EXPECT_EQ(fa->truth.objects[0].position_m, fb->truth.objects[0].position_m);
  }
}

TEST(Simulation, NamesTheNearestScenarioWhenItDoesNotKnowOne) {
  const auto made = Simulation::create("lu2018-4", 1);
  ASSERT_FALSE(made.has_value());
  EXPECT_NE(made.error().message.find("did you mean 'lu2018-1'"), std::string::npos);
}

TEST(Simulation, StartsAtTheOriginOfTheWorldAndLooksAhead) {
  for (const auto& [name, doc] : scenarios()) {
    const auto frame = simulation(name, 2, 1).next_truth();
    const Pose2 ego = frame->ego.pose.planar();
    EXPECT_NEAR(ego.x_m, 0, 1e-9) << name;
    EXPECT_NEAR(ego.y_m, 0, 1e-3) << name;
    EXPECT_NEAR(ego.heading_rad, 0, 1e-3) << name;
    EXPECT_EQ(frame->truth.coordinate_frame, "world");
    EXPECT_EQ(frame->truth.stamp, frame->scan.stamp);
  }
}

TEST(Simulation, EveryScenarioHasFiniteReturnsWithinTheReachOfEverySensor) {
  for (const auto& [name, doc] : scenarios()) {
    for (const auto& [sensor_name, sensor] : choices(SensorPreset{})) {
      auto run = simulation(name, 1, 2, sensor);
      const auto& pattern = run.sensor().pattern;
      const auto frame = run.next();
      ASSERT_FALSE(frame->scan.returns.empty()) << name << " " << sensor_name;
      EXPECT_EQ(frame->label.size(), frame->scan.returns.size());
      for (const Return& r : frame->scan.returns) {
        const double range = std::hypot(r.x_m, r.y_m, r.z_m);
        ASSERT_TRUE(range >= pattern.min_range_m - 1e-3 && range <= pattern.max_range_m + 1e-3);
        ASSERT_TRUE(r.beam >= 0 && r.beam < pattern.columns);
        ASSERT_NEAR(wrap_pi(std::atan2(r.y_m, r.x_m) - run.sensor().azimuth_rad(r.beam)), 0, 1e-4);
      }
    }
  }
}

TEST(Simulation, NoReturnFarFromAnObjectBearsItsName) {
  auto run = simulation("road-users", 4, 60);
  int checked = 0;
  while (auto frame = run.next()) {
    for (std::size_t i = 0; i < frame->label.size(); ++i) {
      if (frame->label[i] <= 0) continue;
      const Return& r = frame->scan.returns[i];
      const auto& object = frame->truth.objects[static_cast<std::size_t>(frame->label[i] - 1)];
      const Eigen::Vector3d p =
          frame->ego.pose * run.ego_from_sensor() * Eigen::Vector3d(r.x_m, r.y_m, r.z_m);
      const Box2 box{object.position_m, *object.heading_rad, *object.length_m, *object.width_m};
      EXPECT_TRUE(box.contains(p.head<2>(), 1.0)) << "frame " << frame->scan.frame;
      ++checked;
    }
  }
  EXPECT_GT(checked, 5000);
}

TEST(Simulation, MixedStreetsHoldEveryClassAndDifferFromSeedToSeed) {
  std::array<int, kObjectClasses> seen{};
  std::set<std::size_t> sizes;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    auto run = simulation("mixed-streets", seed, 2);
    const auto frame = run.next();
    ASSERT_TRUE(frame);
    sizes.insert(frame->truth.objects.size());
    for (const auto& object : frame->truth.objects) {
      seen[static_cast<std::size_t>(object.object_class)] += object.visible_points.value_or(0) > 2;
    }
  }
  EXPECT_GT(sizes.size(), 1U);
  for (const auto kind : {ObjectClass::kVehicle, ObjectClass::kPedestrian, ObjectClass::kCyclist}) {
    EXPECT_GT(seen[static_cast<std::size_t>(kind)], 0) << to_string(kind);
  }
}

TEST(Simulation, AmongPeopleSomebodyIsNearAndTheScannerIsInNobody) {
  int near = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    auto run = simulation("among-people", seed, 30);
    while (const auto frame = run.next_truth()) {
      const Eigen::Vector3d sensor = (frame->ego.pose * run.ego_from_sensor()).translation_m;
      for (const auto& object : frame->truth.objects) {
        if (object.object_class != ObjectClass::kPedestrian) continue;
        const double away = (object.position_m - sensor.head<2>()).norm();
        EXPECT_GT(away, 0.4) << "seed " << seed;
        near += away < 5;
      }
    }
  }
  EXPECT_GT(near, 50);
}

TEST(Simulation, RoomsHavePeopleOrNoneAndTheRobotDrivesThroughNobody) {
  int with_people = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    auto run = simulation("rooms", seed, 100);
    bool people = false;
    while (const auto frame = run.next_truth()) {
      const Eigen::Vector3d sensor = (frame->ego.pose * run.ego_from_sensor()).translation_m;
      for (const auto& object : frame->truth.objects) {
        EXPECT_EQ(object.object_class, ObjectClass::kPedestrian);
        EXPECT_GT((object.position_m - sensor.head<2>()).norm(), 0.3) << "seed " << seed;
        people = true;
      }
    }
    (people ? with_people : without) += 1;
  }
  EXPECT_GT(with_people, 3);
  EXPECT_GT(without, 0);
}

TEST(Simulation, TheSensorStandsAsHighAsIsAsked) {
  SimulateOptions options;
  options.height_m = 1.2;
  const auto run = Simulation::create("mixed-streets", 1, options);
  ASSERT_TRUE(run);
  EXPECT_EQ(run->ego_from_sensor().translation_m.z(), 1.2);
}

TEST(Simulation, TruthMovesAsItsVelocitySays) {
  for (const auto& [name, doc] : scenarios()) {
    auto run = simulation(name, 1, 60);
    auto before = run.next_truth();
    while (auto now = run.next_truth()) {
      const double dt = to_seconds(now->truth.stamp - before->truth.stamp);
      for (std::size_t i = 0; i < now->truth.objects.size(); ++i) {
        const auto &a = before->truth.objects[i], &b = now->truth.objects[i];
        const Eigen::Vector2d mean = (*a.velocity_m_per_s + *b.velocity_m_per_s) / 2;
        EXPECT_LT((b.position_m - a.position_m - dt * mean).norm(), 0.01) << name;
        const double speed = b.velocity_m_per_s->norm();
        if (speed > 0.2) {
          const Eigen::Vector2d ahead(std::cos(*b.heading_rad), std::sin(*b.heading_rad));
          EXPECT_NEAR(b.velocity_m_per_s->dot(ahead), speed, 1e-6) << name;
        }
      }
      before = std::move(now);
    }
  }
}

TEST(Simulation, NobodyDrivesThroughAnybody) {
  SimulateOptions options;
  for (const auto& [name, doc] : scenarios()) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      auto run = Simulation::create(name, seed, options);
      std::set<std::string> touching;
      while (auto frame = run->next_truth()) {
        const Pose2 ego = frame->ego.pose.planar();
        std::vector<Box2> boxes{{ego * Eigen::Vector2d(1.4, 0), ego.heading_rad, 4.4, 1.8}};
        for (const auto& o : frame->truth.objects) {
          boxes.push_back({o.position_m, *o.heading_rad, *o.length_m, *o.width_m});
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          for (std::size_t k = 0; k < i; ++k) {
            if (overlap(boxes[i], boxes[k])) touching.insert(fmt::format("{}-{}", k, i));
          }
        }
      }
      EXPECT_TRUE(touching.empty())
          << name << " seed " << seed << ": " << fmt::format("{}", fmt::join(touching, " "));
    }
  }
}

TEST(SensorModel, PresetsHaveTheBeamsOfTheirDataSheets) {
  struct Expected {
    SensorPreset preset;
    int layers, columns;
    double step_deg, first_deg, last_deg, rate_hz;
  };
  using enum SensorPreset;
  for (const Expected& e : {Expected{kLux, 4, 440, 0.25, -59.875, 49.875, 12.5},
                            Expected{kSickLms111, 1, 541, 0.5, -135, 135, 50},
                            Expected{kHokuyoUtm30, 1, 1081, 0.25, -135, 135, 40},
                            Expected{kRplidarA2, 1, 400, 0.9, -180, 179.1, 10},
                            Expected{kVlp16, 16, 1800, 0.2, -180, 179.8, 10},
                            Expected{kHdl32, 32, 2170, 360.0 / 2170, -180, 179.834, 10},
                            Expected{kHdl64, 64, 2083, 360.0 / 2083, -180, 179.827, 10}}) {
    const auto model = sensor_model(e.preset);
    EXPECT_EQ(model.layers.size(), static_cast<std::size_t>(e.layers));
    EXPECT_EQ(model.pattern.layers, e.layers);
    EXPECT_EQ(model.pattern.columns, e.columns);
    EXPECT_NEAR(degrees(model.pattern.step_rad), e.step_deg, 1e-9);
    EXPECT_NEAR(degrees(model.azimuth_rad(0)), e.first_deg, 1e-3);
    EXPECT_NEAR(degrees(model.azimuth_rad(e.columns - 1)), e.last_deg, 1e-3);
    EXPECT_EQ(model.rate_hz, e.rate_hz);
    for (std::size_t i = 1; i < model.layers.size(); ++i) {
      EXPECT_GT(model.layers[i].elevation_rad, model.layers[i - 1].elevation_rad);
    }
  }
}

TEST(SensorModel, TheLuxSweepsItsArcFromLeftToRightWithinItsShareOfTheTurn) {
  const auto lux = sensor_model(SensorPreset::kLux);
  EXPECT_EQ(lux.time_offset_s(439), 0);
  EXPECT_NEAR(lux.time_offset_s(0), 109.75 / 360 * 0.08, 1e-9);
}

/// A room around a sensor that stands still: a wall 10 m ahead, wide and high.
World walled(double wall_x_m, double from_y_m, double to_y_m) {
  World world;
  world.frames = 200;
  world.ego = standing({});
  add_box(world.fixed,
          {Eigen::Quaterniond::Identity(), {wall_x_m + 0.5, (from_y_m + to_y_m) / 2, 0}},
          {1, to_y_m - from_y_m, 40}, {0.8F, 0.1F, false});
  return world;
}

SimulateOptions still() {
  SimulateOptions options;
  options.vibration = 0;
  options.dropout = 0;
  return options;
}

TEST(Scanner, RangesHaveTheNoiseOfTheSensorAndNoBias) {
  const auto world = walled(13.7, -100, 100);
  auto options = still();
  options.divergence = 0;
  const auto model = sensor_model(SensorPreset::kLux);
  Scanner scanner(world, model, options, 1);
  double sum = 0, squares = 0;
  int count = 0;
  for (int frame = 0; frame < 20; ++frame) {
    for (const Return& r : scanner.scan(frame).returns) {
      const double range = std::hypot(r.x_m, r.y_m, r.z_m);
      const double error = range * (1 - 10 / r.x_m);
      sum += error;
      squares += error * error;
      ++count;
    }
  }
  EXPECT_EQ(count, 20 * 1560);
  EXPECT_NEAR(sum / count, 0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / count), 0.035, 0.001);
}

TEST(Scanner, LosesTheShareOfBeamsItIsTold) {
  const auto world = walled(13.7, -100, 100);
  auto options = still();
  options.dropout = 0.2;
  Scanner scanner(world, sensor_model(SensorPreset::kLux), options, 1);
  double found = 0;
  for (int frame = 0; frame < 20; ++frame) {
    found += static_cast<double>(scanner.scan(frame).returns.size());
  }
  EXPECT_NEAR(found / (20 * 1560), 0.8, 0.01);
}

TEST(Scanner, BeamsAtAnEdgeGiveReturnsBetweenTheTwoSides) {
  World world = walled(14.2, -100, 100);
  add_box(world.fixed, {Eigen::Quaterniond::Identity(), {13.8, -50, 0}}, {0.2, 100, 40},
          {0.8F, 0.1F, false});
  Scanner scanner(world, sensor_model(SensorPreset::kSickLms111), still(), 1);
  int between = 0;
  for (int frame = 0; frame < 20; ++frame) {
    for (const Return& r : scanner.scan(frame).returns) {
      between += r.x_m > 10.08 && r.x_m < 10.42;
    }
  }
  EXPECT_GT(between, 10);
}

TEST(Scanner, MeetsAMovingObjectWhereItIsWhenTheBeamIsFired) {
  World world;
  world.frames = 10;
  world.ego = standing({});
  Actor wall;
  wall.id = 1;
  wall.length_m = 0.2;
  wall.width_m = 60;
  wall.height_m = 40;
  Part part;
  add_box(part.mesh, {}, {0.2, 60, 40}, {0.8F, 0.1F, false});
  wall.parts.push_back(std::move(part));
  wall.motion = straight({13.8, 0, 0}, 20);
  world.actors.push_back(std::move(wall));
  auto options = still();
  options.range_noise_m = 0;
  options.divergence = 0;
  Scanner scanner(world, sensor_model(SensorPreset::kLux), options, 1);
  const auto sweep = scanner.scan(0);
  ASSERT_GT(sweep.returns.size(), 1000U);
  for (const Return& r : sweep.returns) EXPECT_NEAR(r.x_m, 10 + 20 * r.time_offset_s, 0.01);
}

TEST(Scanner, WhatStandsBehindSomethingIsNotSeenAndSaidToBeOccluded) {
  World world = walled(10, -3, 3);
  Actor hidden;
  hidden.id = 1;
  hidden.length_m = hidden.width_m = hidden.height_m = 2;
  Part part;
  add_box(part.mesh, {Eigen::Quaterniond::Identity(), {0, 0, 1}}, {2, 2, 2}, {});
  hidden.parts.push_back(std::move(part));
  hidden.motion = standing({20, 0, 0});
  Actor open = hidden;
  open.id = 2;
  open.motion = standing({20, 12, 0});
  world.actors = {hidden, open};
  Scanner scanner(world, sensor_model(SensorPreset::kLux), still(), 1);
  const auto sweep = scanner.scan(0);
  EXPECT_EQ(sweep.visible_points[0], 0);
  EXPECT_EQ(sweep.occluded[0], 1);
  EXPECT_GT(sweep.visible_points[1], 30);
  EXPECT_EQ(sweep.occluded[1], 0);
}

}  // namespace
}  // namespace scanfuse::simulate
