#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/core/random.hpp"

/// Scenes of passive sensors turned into packings: for tests and benchmarks of the solvers only.
/// Bearings of random targets, with misses and clutter; every combination within the gates becomes
/// a column with the Laplace evidence as weight, linearised crudely.
namespace scanfuse::associate::scenes {

struct Scene {
  double noise_rad = 5e-3;
  double detection = 1.0;
  double false_alarms = 0;  ///< mean number a sensor and scan
  std::vector<Eigen::Vector3d> sensors_km;
  std::vector<Eigen::Vector3d> targets_km;
};

inline std::vector<Eigen::Vector3d> paper_sensors() {
  return {{30, 0, 0.1}, {0, 30, 0.1}, {0, 0, 0}};
}

/// Targets in a row, `spacing_km` apart along x.
inline Scene line(int targets, double spacing_km, RandomStream& random) {
  Scene scene;
  scene.sensors_km = paper_sensors();
  const Eigen::Vector3d start(random.uniform(5, 20), random.uniform(10, 25), random.uniform(4, 9));
  for (int t = 0; t < targets; ++t)
    scene.targets_km.emplace_back(start.x() + t * spacing_km, start.y(), start.z());
  return scene;
}

/// Targets on a grid of 5 columns: many ghosts.
inline Scene grid(int targets, double spacing_km, RandomStream& random) {
  Scene scene;
  scene.sensors_km = paper_sensors();
  const Eigen::Vector3d start(random.uniform(12, 20), random.uniform(12, 20), random.uniform(4, 9));
  for (int t = 0; t < targets; ++t)
    scene.targets_km.emplace_back(start.x() + t % 5 * spacing_km, start.y() + t / 5 * spacing_km,
                                  start.z());
  return scene;
}

/// Targets and sensors anywhere in a box of 40 x 40 x 11 km, sensors on the ground.
inline Scene box(int targets, int sensors, RandomStream& random) {
  Scene scene;
  scene.detection = 0.9;
  for (int s = 0; s < sensors; ++s)
    scene.sensors_km.emplace_back(random.uniform(0, 40), random.uniform(0, 40),
                                  random.uniform(0, 0.3));
  for (int t = 0; t < targets; ++t)
    scene.targets_km.emplace_back(random.uniform(0, 40), random.uniform(0, 40),
                                  random.uniform(0.5, 11));
  return scene;
}

/// A packing and the target that each row is of, -1 for clutter.
struct Labelled {
  Packing packing;
  std::vector<int> target_of_row;

  /// Whether a column holds all rows of one target and no others.
  [[nodiscard]] bool is_right(std::size_t column) const {
    const auto rows = packing.column(column);
    const int target = target_of_row[static_cast<std::size_t>(rows[0])];
    const auto same = [&](auto row) {
      return target_of_row[static_cast<std::size_t>(row)] == target;
    };
    return target >= 0 && std::ranges::all_of(rows, same) &&
           std::ranges::count(target_of_row, target) == static_cast<std::ptrdiff_t>(rows.size());
  }
};

/// Grows tuples sensor by sensor from pairs of lines that pass close to each other.
class Columns {
 public:
  Columns(const Scene& scene, RandomStream& random) : scene_(scene) { measure(random); }

  Labelled labelled() {
    auto columns = packing();
    return {std::move(columns), std::move(target_of_row_)};
  }

  Packing packing() {
    for (std::size_t s = 0; s < bearings_.size(); ++s) {
      for (std::size_t r = s + 1; r < bearings_.size(); ++r) pairs(s, r);
    }
    return std::move(packing_);
  }

 private:
  struct Bearing {
    double azimuth, elevation;
    Eigen::Vector3d ray;
    std::int32_t row = 0;
    int target = -1;
  };
  struct Member {
    std::size_t sensor;
    const Bearing* bearing;
  };

  static Bearing bearing(double azimuth, double elevation) {
    return {azimuth,
            elevation,
            {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
             std::sin(elevation)}};
  }

  void measure(RandomStream& random) {
    for (std::size_t s = 0; s < scene_.sensors_km.size(); ++s) {
      std::vector<Bearing> seen;
      for (const auto& target : scene_.targets_km) {
        const Eigen::Vector3d d = target - scene_.sensors_km[s];
        const double azimuth = random.normal(std::atan2(d.y(), d.x()), scene_.noise_rad);
        const double elevation =
            random.normal(std::atan2(d.z(), d.head<2>().norm()), scene_.noise_rad);
        if (!random.chance(scene_.detection)) continue;
        seen.push_back(bearing(std::remainder(azimuth, 2 * std::numbers::pi), elevation));
        seen.back().target = static_cast<int>(&target - scene_.targets_km.data());
      }
      for (int c = 0; c < static_cast<int>(scene_.false_alarms); ++c) {
        seen.push_back(
            bearing(random.uniform(-std::numbers::pi, std::numbers::pi), random.uniform(0, 0.8)));
      }
      std::ranges::sort(seen, {}, &Bearing::azimuth);
      for (auto& b : seen) {
        b.row = static_cast<std::int32_t>(packing_.set_of_row.size());
        packing_.set_of_row.push_back(static_cast<std::int32_t>(s));
        target_of_row_.push_back(b.target);
      }
      bearings_.push_back(std::move(seen));
    }
  }

  void pairs(std::size_t s, std::size_t r) {
    const Eigen::Vector3d baseline = scene_.sensors_km[r] - scene_.sensors_km[s];
    for (const auto& a : bearings_[s]) {
      const Eigen::Vector3d normal_a = baseline.cross(a.ray);
      for (const auto& b : bearings_[r]) {
        const Eigen::Vector3d normal = a.ray.cross(b.ray);
        const double sine2 = normal.squaredNorm();
        if (sine2 < 1e-8) continue;
        const double miss2 = std::pow(baseline.dot(normal), 2) / sine2;
        const double range_a = baseline.cross(b.ray).dot(normal) / sine2;
        const double range_b = normal_a.dot(normal) / sine2;
        if (range_a < 0.2 || range_b < 0.2 || range_a > 70 || range_b > 70) continue;
        const double sigma2 =
            scene_.noise_rad * scene_.noise_rad * (range_a * range_a + range_b * range_b);
        if (miss2 > 12 * sigma2) continue;
        const Eigen::Vector3d x = scene_.sensors_km[s] + range_a * a.ray;
        if ((x.array() < -2).any() || x.x() > 42 || x.y() > 42 || x.z() > 13) continue;
        tuple_ = {{s, &a}, {r, &b}};
        grow(x, r + 1);
      }
    }
  }

  /// Emits the tuple and all that further sensors can add to it.
  void grow(const Eigen::Vector3d& start, std::size_t next) {
    const auto [x, P, chi2] = fit(start);
    const double degrees = 2.0 * static_cast<double>(tuple_.size()) - 3;
    if (!(chi2 < degrees + 4 * std::sqrt(2 * degrees) + 5)) return;
    emit(P, chi2);
    for (std::size_t s = next; s < bearings_.size(); ++s) {
      const Eigen::Vector3d d = x - scene_.sensors_km[s];
      const double flat2 = d.head<2>().squaredNorm();
      const double azimuth = std::atan2(d.y(), d.x()),
                   elevation = std::atan2(d.z(), std::sqrt(flat2));
      const Eigen::Matrix<double, 2, 3> H = slopes(d);
      const Eigen::Matrix2d S =
          H * P * H.transpose() + Eigen::Matrix2d::Identity() * scene_.noise_rad * scene_.noise_rad;
      const double reach = 4 * std::sqrt(S(0, 0));
      const Eigen::Matrix2d S_inverse = S.inverse();
      auto first = std::ranges::lower_bound(bearings_[s], azimuth - reach, {}, &Bearing::azimuth);
      for (; first != bearings_[s].end() && first->azimuth < azimuth + reach; ++first) {
        const Eigen::Vector2d v(first->azimuth - azimuth, first->elevation - elevation);
        if (v.dot(S_inverse * v) > 18) continue;
        tuple_.push_back({s, &*first});
        grow(x, s + 1);
        tuple_.pop_back();
      }
    }
  }

  static Eigen::Matrix<double, 2, 3> slopes(const Eigen::Vector3d& d) {
    const double flat2 = d.head<2>().squaredNorm(), flat = std::sqrt(flat2),
                 range2 = d.squaredNorm();
    Eigen::Matrix<double, 2, 3> H;
    H << -d.y() / flat2, d.x() / flat2, 0, -d.x() * d.z() / (flat * range2),
        -d.y() * d.z() / (flat * range2), flat / range2;
    return H;
  }

  struct Fit {
    Eigen::Vector3d x;
    Eigen::Matrix3d P;
    double chi2;
  };
  Fit fit(Eigen::Vector3d x) const {
    Fit fit{x, Eigen::Matrix3d::Identity(), 0};
    for (int step = 0; step < 3; ++step) {
      Eigen::Matrix3d information = Eigen::Matrix3d::Identity() * 1e-9;
      Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
      double chi2 = 0;
      for (const auto& [sensor, b] : tuple_) {
        const Eigen::Vector3d d = fit.x - scene_.sensors_km[sensor];
        const Eigen::Matrix<double, 2, 3> H = slopes(d) / scene_.noise_rad;
        Eigen::Vector2d v(
            std::remainder(b->azimuth - std::atan2(d.y(), d.x()), 2 * std::numbers::pi),
            b->elevation - std::atan2(d.z(), d.head<2>().norm()));
        v /= scene_.noise_rad;
        information += H.transpose() * H;
        gradient += H.transpose() * v;
        chi2 += v.squaredNorm();
      }
      fit.P = information.inverse();
      const Eigen::Vector3d move = fit.P * gradient;
      fit.x += move;
      fit.chi2 = chi2 - gradient.dot(move);
    }
    return fit;
  }

  void emit(const Eigen::Matrix3d& P, double chi2) {
    const double volume = 40.0 * 40 * 11, view = 2 * std::numbers::pi * 0.8;
    const double n = static_cast<double>(tuple_.size()),
                 missed = static_cast<double>(bearings_.size()) - n;
    const double pd = std::min(scene_.detection, 0.99);
    double w = std::log(static_cast<double>(scene_.targets_km.size()) / volume) + n * std::log(pd) +
               missed * std::log(1 - pd);
    w += -chi2 / 2 - n * std::log(2 * std::numbers::pi * scene_.noise_rad * scene_.noise_rad);
    w += 0.5 * std::log(std::pow(2 * std::numbers::pi, 3) * P.determinant());
    w -= n * std::log(std::max(scene_.false_alarms, 0.5) / view);
    if (!(w > 0)) return;
    std::vector<std::int32_t> rows;
    for (const auto& member : tuple_) rows.push_back(member.bearing->row);
    packing_.add(rows, w);
  }

  Scene scene_;
  Packing packing_;
  std::vector<std::vector<Bearing>> bearings_;
  std::vector<Member> tuple_;
  std::vector<int> target_of_row_;
};

inline Packing packing_of(const Scene& scene, RandomStream& random) {
  return Columns(scene, random).packing();
}

inline Labelled labelled(const Scene& scene, RandomStream& random) {
  return Columns(scene, random).labelled();
}

}  // namespace scanfuse::associate::scenes
