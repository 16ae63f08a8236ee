#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/track/tracker.hpp"

/// A world of detections without a lidar: what the tracker alone is tested on.
namespace scanfuse::track::testing {

struct Mover {
  Eigen::Vector2d start_m;
  Eigen::Vector2d velocity_m_per_s;
  ObjectClass object_class = ObjectClass::kVehicle;
  double length_m = 4.4;
  double width_m = 1.8;
  /// Acceleration at a time after the start, m/s^2.
  std::function<Eigen::Vector2d(double)> accel = [](double) { return Eigen::Vector2d(0, 0); };
};

struct SceneOptions {
  int frames = 100;
  double dt_s = 0.08;
  double sigma_m = 0.15;
  double detection_probability = 0.95;
  double clutter_per_frame = 0.3;
  double half_field_m = 30;
};

struct SceneFrame {
  Time stamp;
  std::vector<Eigen::Vector4d> truth;  ///< x, vx, y, vy of each mover
  std::vector<Detection> detections;
};

inline Detection box_detection(const Eigen::Vector2d& centre, double heading, const Mover& mover,
                               double sigma_m) {
  Detection d;
  d.object_class = mover.object_class;
  d.box = {centre, heading, mover.length_m, mover.width_m};
  d.covariance = Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, 0.003).asDiagonal();
  d.var_length_m2 = d.var_width_m2 = 0.01;
  d.length_seen = d.width_seen = true;
  d.faces_seen = 2;
  d.visible_middle_m = centre;
  return d;
}

inline void add_clutter(SceneFrame& frame, const SceneOptions& options, RandomStream& random,
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

inline void shuffle(std::vector<Detection>& detections, RandomStream& random) {
  for (std::size_t i = detections.size(); i > 1; --i) {
    std::swap(detections[i - 1], detections[random.below(i)]);
  }
}

inline std::vector<SceneFrame> play(const std::vector<Mover>& movers, const SceneOptions& options,
                                    std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Eigen::Vector4d> states;
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

/// Counts how often the confirmed track that covers a mover changes, as CLEAR-MOT does.
class IdentityCounter {
 public:
  explicit IdentityCounter(double match_m) : match_m_(match_m) {}

  void add(const std::vector<Eigen::Vector4d>& truth, const std::vector<Track>& tracks) {
    identity_.resize(truth.size(), 0);
    std::vector<char> taken(tracks.size(), 0);
    std::vector<int> match(truth.size(), -1);
    for (int round = 0; round < 2; ++round) {  // first those that keep their track
      for (std::size_t i = 0; i < truth.size(); ++i) {
        if (match[i] < 0) match[i] = find(truth[i], round == 0 ? identity_[i] : 0, tracks, taken);
      }
    }
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ++frames_;
      if (match[i] < 0) continue;
      ++covered_;
      const std::int64_t id = tracks[match[i]].id;
      if (identity_[i] != 0 && identity_[i] != id) ++changes_;
      identity_[i] = id;
    }
  }
  [[nodiscard]] int changes() const { return changes_; }
  [[nodiscard]] double coverage() const { return double(covered_) / frames_; }
  [[nodiscard]] const std::vector<std::int64_t>& identity() const { return identity_; }

 private:
  int find(const Eigen::Vector4d& truth, std::int64_t wanted, const std::vector<Track>& tracks,
           std::vector<char>& taken) const {
    int best = -1;
    double nearest = match_m_;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      if (taken[t] || tracks[t].status == TrackStatus::kTentative) continue;
      if (wanted != 0 && tracks[t].id != wanted) continue;
      const double apart = (tracks[t].box.centre_m - Eigen::Vector2d(truth(0), truth(2))).norm();
      if (apart < nearest) {
        nearest = apart;
        best = static_cast<int>(t);
      }
    }
    // Identity 0 means none yet: the first round has nothing to keep then.
    if (best >= 0) taken[best] = 1;
    return best;
  }

  double match_m_;
  std::vector<std::int64_t> identity_;
  int changes_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t covered_ = 0;
};

struct SetPiece {
  const char* name;
  std::vector<Mover> movers;
  double allowed;  ///< identity changes a run
};

inline std::vector<SetPiece> set_pieces() {
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
  for (int i = 0; i < 5; ++i) line.push_back({{-25.0 + 7 * i, 0}, {4, 0}});
  pieces.push_back({"five in line", line, 0.2});
  return pieces;
}

}  // namespace scanfuse::track::testing
