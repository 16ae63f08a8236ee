#include "scanfuse/simulate/simulate.hpp"

#include <array>

#include "scanfuse/simulate/scanner.hpp"
#include "scanfuse/simulate/scenarios.hpp"

namespace scanfuse::simulate {
namespace {

struct Scenario {
  ScenarioInfo info;
  World (*build)(RandomStream random);
};

constexpr std::array kScenarios{
    Scenario{{"lu2018-1", "two cars; one enters the view at frame 26 and leaves at 147"}, lu2018_1},
    Scenario{{"lu2018-2", "a car cuts in at frame 51 and hides the other from 62 to 74"}, lu2018_2},
    Scenario{{"lu2018-3", "three cars, one leaves the view at frame 16"}, lu2018_3},
    Scenario{{"empty-road", "nobody but the ego car"}, empty_road},
    Scenario{{"crossing", "an intersection with crossing and turning cars"}, crossing},
    Scenario{{"road-users", "cars, pedestrians, cyclists and clutter to 60 m"}, road_users},
    Scenario{{"mixed-streets", "road users and clutter on a street of another kind each seed"},
             mixed_streets},
    Scenario{{"among-people", "a robot on a footpath, people from half a metre on"}, among_people},
    Scenario{{"rooms", "a robot among furniture, with people or without"}, rooms},
    Scenario{{"curved-road", "a bend at up to 0.22 rad/s with oncoming cars"}, curved_road},
    Scenario{{"curved-road-cyclist", "the same, and a cyclist crosses it"}, curved_road_cyclist},
};

// An instant in the life of every simulated recording: 2018-07-01 00:00 UTC.
constexpr std::int64_t kStartSeconds = 1530403200;

SensorModel mounted(SensorModel model, const SimulateOptions& options) {
  if (options.height_m > 0) model.ego_from_sensor.translation_m.z() = options.height_m;
  return model;
}

TruthObject truth_of(const Actor& actor, double t_s) {
  TruthObject object;
  const Pose2 pose = actor.motion.pose(t_s);
  object.id = actor.id;
  object.object_class = actor.object_class;
  object.position_m = {pose.x_m, pose.y_m};
  object.z_m = actor.height_m / 2;
  object.heading_rad = wrap_pi(pose.heading_rad);
  object.velocity_m_per_s = actor.motion.velocity(t_s);
  object.length_m = actor.length_m;
  object.width_m = actor.width_m;
  object.height_m = actor.height_m;
  return object;
}

}  // namespace

struct Simulation::State {
  World world;
  Scanner scanner;
  int frames;
  std::int64_t next_frame = 0;

  State(World built, const SimulateOptions& options, std::uint64_t seed)
      : world(std::move(built)),
        scanner(world, mounted(sensor_model(options.sensor), options), options, seed),
        frames(options.frames > 0 ? options.frames : scenario_frames()) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Scenarios count their length in frames of the LUX.
  [[nodiscard]] int scenario_frames() const {
    return static_cast<int>(world.frames / 12.5 * scanner.model().rate_hz);
  }
  [[nodiscard]] PoseSample ego(Time stamp, double t_s) const {
    PoseSample sample;
    sample.stamp = stamp;
    sample.frame_id = "odom";
    sample.child_frame_id = "base_link";
    sample.pose = Pose3::from_planar(world.ego.pose(t_s));
    sample.speed_m_per_s = world.ego.velocity(t_s).norm();
    sample.yaw_rate_rad_per_s = world.ego.yaw_rate(t_s);
    return sample;
  }
};

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Result<Simulation> Simulation::create(std::string_view scenario, std::uint64_t seed,
                                      const SimulateOptions& options) {
  std::vector<std::string> names;
  for (const auto& known : kScenarios) {
    if (known.info.name == scenario) {
      return Simulation(
          std::make_unique<State>(known.build(RandomStream(seed, 0x3ce)), options, seed));
    }
    names.emplace_back(known.info.name);
  }
  return fail(Error::Code::kNotFound, "unknown scenario '{}'; did you mean '{}'?", scenario,
              nearest_name(std::string(scenario), names));
}

std::optional<SimulatedFrame> Simulation::next_truth() {
  State& s = *state_;
  if (s.next_frame >= s.frames) return std::nullopt;
  const std::int64_t frame = s.next_frame++;
  const double t = s.scanner.stamp_s(frame);
  const Time stamp = time_from_nanos(kStartSeconds * 1'000'000'000) + duration_from_seconds(t);

  SimulatedFrame out;
  out.scan = {stamp, frame, "/scan", "lidar", {}, s.scanner.model().pattern};
  out.ego = s.ego(stamp, t);
  out.truth = {stamp, frame, "world", {}};
  for (const Actor& actor : s.world.actors) out.truth.objects.push_back(truth_of(actor, t));
  return out;
}

std::optional<SimulatedFrame> Simulation::next() {
  auto out = next_truth();
  if (!out) return out;
  Sweep sweep = state_->scanner.scan(out->scan.frame);
  out->scan.returns = std::move(sweep.returns);
  out->label = std::move(sweep.label);
  for (std::size_t a = 0; a < out->truth.objects.size(); ++a) {
    out->truth.objects[a].visible_points = sweep.visible_points[a];
    out->truth.objects[a].occluded = sweep.occluded[a];
  }
  return out;
}

Pose3 Simulation::ego_from_sensor() const { return state_->scanner.model().ego_from_sensor; }
int Simulation::frames() const { return state_->frames; }
const SensorModel& Simulation::sensor() const { return state_->scanner.model(); }

std::vector<ScenarioInfo> scenarios() {
  std::vector<ScenarioInfo> list;
  list.reserve(std::size(kScenarios));
  for (const auto& known : kScenarios) list.push_back(known.info);
  return list;
}

}  // namespace scanfuse::simulate
