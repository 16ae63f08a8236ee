#include "scanfuse/simulate/cast.hpp"

#include "scanfuse/simulate/bodies.hpp"
#include "scanfuse/simulate/silhouette.hpp"

namespace scanfuse::simulate {

Course& Course::arc(double length_m, double angle_rad) {
  const int steps = std::max(1, static_cast<int>(std::lround(length_m)));
  for (int i = 0; i < steps; ++i) {
    const double step = length_m / steps, turn = angle_rad / steps;
    at_ = at_ * Pose2{0, 0, turn / 2} * Pose2{step, 0, turn / 2};
    poses_.push_back(at_);
  }
  return *this;
}

Course Course::back(double left_m) const {
  Course other(poses_.back() * Pose2{0, left_m, kPi});
  for (auto pose = poses_.rbegin() + 1; pose != poses_.rend(); ++pose) {
    other.poses_.push_back(*pose * Pose2{0, left_m, kPi});
  }
  return other;
}

PlanarMotion Course::drive(double start_s, const std::function<double(double)>& speed_at) const {
  std::vector<double> t{start_s}, x{poses_[0].x_m}, y{poses_[0].y_m};
  double s = 0;
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const double step =
        std::hypot(poses_[i].x_m - poses_[i - 1].x_m, poses_[i].y_m - poses_[i - 1].y_m);
    t.push_back(t.back() + step / speed_at(s + step / 2));
    x.push_back(poses_[i].x_m);
    y.push_back(poses_[i].y_m);
    s += step;
  }
  return {Spline(t, x), Spline(t, y), std::nullopt};
}

std::function<double(double)> steady(double speed_m_per_s) {
  return [=](double) { return speed_m_per_s; };
}

std::function<double(double)> slowing(double fast, double slow, double where_m, double width_m) {
  return [=](double s) {
    const double u = (s - where_m) / width_m;
    return fast - (fast - slow) * std::exp(-u * u);
  };
}

bool Cast::add(Actor actor, PlanarMotion motion) const {
  actor.motion = std::move(motion);
  if (!runs_free(actor)) return false;
  world_->actors.push_back(std::move(actor));
  return true;
}

bool Cast::car(PlanarMotion motion) const {
  return add(make_car(next_id(), random_car_size(*random_), *random_), std::move(motion));
}

bool Cast::van(PlanarMotion motion) const {
  return add(make_van(next_id(), *random_), std::move(motion));
}

bool Cast::truck(PlanarMotion motion) const {
  return add(make_truck(next_id(), *random_), std::move(motion));
}

bool Cast::pedestrian(PlanarMotion motion) const {
  const double speed = motion.velocity(0).norm();
  return add(make_pedestrian(next_id(), speed / 0.7, *random_), std::move(motion));
}

bool Cast::cyclist(PlanarMotion motion) const {
  return add(make_cyclist(next_id(), *random_), std::move(motion));
}

bool Cast::runs_free(const Actor& actor) const {
  constexpr double kMargin = 0.3;
  const auto box = [](const Actor& a, double t) {
    const Pose2 pose = a.motion.pose(t);
    return Box2{{pose.x_m, pose.y_m}, pose.heading_rad, a.length_m + kMargin, a.width_m + kMargin};
  };
  for (double t = 0; t < world_->frames / 12.5; t += 0.1) {
    const Box2 mine = box(actor, t);
    const Pose2 ego = world_->ego.pose(t);
    if (overlap(mine, {ego * Eigen::Vector2d(1.4, 0), ego.heading_rad, 5, 1.9})) return false;
    for (const Actor& other : world_->actors) {
      if (overlap(mine, box(other, t))) return false;
    }
  }
  return true;
}

}  // namespace scanfuse::simulate
