#include "scanfuse/simulate/set_pieces.hpp"

#include <cmath>
#include <utility>

namespace scanfuse::simulate {
namespace {

void add_clutter(SceneFrame& frame, const SceneOptions& options, RandomStream& random,
                 const Mover& looks_like) {
  // Poisson by thinning: the mean is well below ten.
  for (int i = 0; i < 10; ++i) {
    if (!random.chance(options.clutter_per_frame / 10)) continue;
    const Eigen::Vector2d at(random.uniform(-options.half_field_m, options.half_field_m),
                             random.uniform(-options.half_field_m, options.half_field_m));
    frame.detections.push_back(
        box_detection(at, random.uniform(-3, 3), looks_like, options.sigma_m));
  }
}

void shuffle(std::vector<Detection>& detections, RandomStream& random) {
  for (std::size_t i = detections.size(); i > 1; --i) {
    std::swap(detections[i - 1], detections[random.below(i)]);
  }
}

}  // namespace

Detection box_detection(const Eigen::Vector2d& centre, double heading_rad, const Mover& mover,
                        double sigma_m) {
  Detection d;
  d.object_class = mover.object_class;
  d.box = {centre, heading_rad, mover.length_m, mover.width_m};
  d.covariance = Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, 0.003).asDiagonal();
  d.var_length_m2 = d.var_width_m2 = 0.01;
  d.length_seen = d.width_seen = true;
  d.faces_seen = 2;
  d.visible_middle_m = centre;
  return d;
}

std::optional<Detection> perfect_detection(const TruthObject& object) {
  if (!object.heading_rad || !object.length_m || !object.width_m) return std::nullopt;
  const Mover mover{
      object.position_m, {0, 0}, object.object_class, *object.length_m, *object.width_m};
  return box_detection(object.position_m, *object.heading_rad, mover, 0.05);
}

std::vector<SceneFrame> play(const std::vector<Mover>& movers, const SceneOptions& options,
                             std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Eigen::Vector4d> states;
  states.reserve(movers.size());
  for (const Mover& m : movers) {
    states.emplace_back(m.start_m.x(), m.velocity_m_per_s.x(), m.start_m.y(),
                        m.velocity_m_per_s.y());
  }
  std::vector<SceneFrame> frames(options.frames);
  for (int k = 0; k < options.frames; ++k) {
    SceneFrame& frame = frames[k];
    const double t = k * options.dt_s, dt = options.dt_s;
    frame.stamp = time_from_seconds(1000 + t);
    for (std::size_t i = 0; i < movers.size(); ++i) {
      Eigen::Vector4d& x = states[i];
      frame.truth.push_back(x);
      const Eigen::Vector2d noise(random.normal(0, options.sigma_m),
                                  random.normal(0, options.sigma_m));
      if (random.chance(options.detection_probability)) {
        frame.detections.push_back(box_detection(Eigen::Vector2d(x(0), x(2)) + noise,
                                                 std::atan2(x(3), x(1)), movers[i],
                                                 options.sigma_m));
      }
      const Eigen::Vector2d a = movers[i].accel(t);
      x += Eigen::Vector4d(x(1) * dt + a.x() * dt * dt / 2, a.x() * dt,
                           x(3) * dt + a.y() * dt * dt / 2, a.y() * dt);
    }
    add_clutter(frame, options, random, movers.front());
    shuffle(frame.detections, random);
  }
  return frames;
}

std::vector<SetPiece> set_pieces() {
  constexpr auto kWalker = ObjectClass::kPedestrian;
  std::vector<SetPiece> pieces;
  pieces.push_back({"parallel 3 m", {{{-25, 0}, {8, 0}}, {{-25, 3}, {8, 0}}}, 0.3});
  pieces.push_back({"crossing 90 deg", {{{-24, 0}, {6, 0}}, {{0, -24}, {0, 6}}}, 1.5});
  pieces.push_back(
      {"opposed pedestrians",
       {{{-5.6, 0}, {1.4, 0}, kWalker, 0.6, 0.5}, {{5.6, 0.5}, {-1.4, 0}, kWalker, 0.6, 0.5}},
       0.7});
  pieces.push_back(
      {"two pedestrians 0.7 m apart",
       {{{-5.6, 0}, {1.4, 0}, kWalker, 0.6, 0.5}, {{-5.6, 0.7}, {1.4, 0}, kWalker, 0.6, 0.5}},
       0.7});
  pieces.push_back({"overtaking", {{{-20, 0}, {4, 0}}, {{-28, 3}, {8, 0}}}, 0.0});
  std::vector<Mover> line;
  line.reserve(5);
  for (int i = 0; i < 5; ++i) line.push_back({{-25.0 + 7 * i, 0}, {4, 0}});
  pieces.push_back({"five in line", line, 0.2});
  return pieces;
}

}  // namespace scanfuse::simulate
