#include "scanfuse/estimate/ego_frame.hpp"

namespace scanfuse::estimate {
namespace {

/// The first five states of the CTRA model are those of the paper.
CtraVector without_turn(const Eigen::Matrix<double, 5, 1>& x) {
  CtraVector full = CtraVector::Zero();
  full.head<5>() = x;
  return full;
}

}  // namespace

EgoTransition<5> guo_transition(const Eigen::Matrix<double, 5, 1>& x, const EgoControl& ego,
                                double dt_s) {
  const Transition<6> f = ctra_transition(without_turn(x), dt_s);
  return seen_from_ego<5>({f.mean.head<5>(), f.F.topLeftCorner<5, 5>()}, ego, dt_s);
}

Eigen::Matrix<double, 5, 5> guo_noise(const Eigen::Matrix<double, 5, 1>& x, double dt_s,
                                      CtraNoise noise) {
  noise.yaw_rate_rad_per_s = 0;
  return ctra_noise(without_turn(x), dt_s, noise).topLeftCorner<5, 5>();
}

}  // namespace scanfuse::estimate
