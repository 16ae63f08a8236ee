#include "scanfuse/track/extent.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/estimate/kalman.hpp"

namespace scanfuse::track {
namespace {

/// Rounded corners, mirrors and ground clearance: a measured side is never better than this.
constexpr double kSideSigma_m = 0.10;
/// And they stay the same from scan to scan, so no number of scans makes a side better than this.
constexpr double kLeastSigma_m = 0.08;
/// What is wrong with a measured side stays wrong while the view stays the same: so many scans
/// count as one.
constexpr double kScansOfOneView = 4;
/// Beyond this many deviations the belief, not the measurement, is doubted.
constexpr double kSurprise = 3.0;
constexpr double kShortest_m = 0.1;

/// Gives state `place` another mean and variance; all others follow by their correlation with it.
void replace_moment(Gaussian<kStates>& state, int place, double mean, double variance) {
  const double old_variance = state.covariance(place, place);
  const StateVector gain = state.covariance.col(place) / old_variance;
  state.mean += gain * (mean - state.mean(place));
  state.covariance += (variance - old_variance) * gain * gain.transpose();
  state.covariance = (0.5 * (state.covariance + state.covariance.transpose())).eval();
}

void update_seen(Gaussian<kStates>& state, int place, const MeasuredSide& side) {
  const double noise = kScansOfOneView * std::max(side.variance_m2, kSideSigma_m * kSideSigma_m);
  const double residual = side.size_m - state.mean(place);
  const double surprise = residual * residual / (kSurprise * kSurprise);
  const double belief = state.covariance(place, place);
  if (surprise > belief + noise) state.covariance(place, place) = surprise - noise;
  Eigen::Matrix<double, 1, kStates> H = Eigen::Matrix<double, 1, kStates>::Zero();
  H(place) = 1;
  Gaussian<1> measured;
  measured.mean(0) = side.size_m;
  measured.covariance(0) = noise;
  state = estimate::update(state, measured, H);
  const double least = kLeastSigma_m * kLeastSigma_m;
  if (state.covariance(place, place) < least) {
    replace_moment(state, place, state.mean(place), least);
  }
}

/// Truncated normal with a soft edge: the bound itself is known to `sigma`.
void update_lower_bound(Gaussian<kStates>& state, int place, double bound_m, double sigma_m) {
  const double mean = state.mean(place), variance = state.covariance(place, place);
  // A bound below the mean tells little, and repeated every scan it would push the mean away.
  if (bound_m <= mean) return;
  const double spread = std::sqrt(variance + sigma_m * sigma_m);
  const double alpha = std::min((bound_m - mean) / spread, 6.0);
  const double density = std::exp(-0.5 * alpha * alpha) / std::sqrt(2 * kPi);
  const double above = 0.5 * std::erfc(alpha / std::sqrt(2.0));
  const double hazard = density / above;
  const double shrink = variance / (spread * spread) * hazard * (hazard - alpha);
  replace_moment(state, place, mean + variance / spread * hazard, variance * (1 - shrink));
}

void update_side(Gaussian<kStates>& state, int place, const MeasuredSide& side) {
  if (side.seen) {
    update_seen(state, place, side);
  } else if (side.bounded) {
    const double sigma = std::sqrt(std::min(side.variance_m2, 1.0));
    update_lower_bound(state, place, side.size_m - 2 * sigma, kSideSigma_m);
  }
  state.mean(place) = std::max(state.mean(place), kShortest_m);
}

}  // namespace

Gaussian<2> extent_prior(ObjectClass object_class) {
  const auto prior = [](double length, double width, double sigma_length, double sigma_width) {
    Gaussian<2> extent;
    extent.mean << length, width;
    extent.covariance =
        Eigen::Vector2d(sigma_length * sigma_length, sigma_width * sigma_width).asDiagonal();
    return extent;
  };
  switch (object_class) {
    case ObjectClass::kVehicle:
      return prior(4.4, 1.8, 0.4, 0.12);
    case ObjectClass::kPedestrian:
      return prior(0.6, 0.5, 0.2, 0.15);
    case ObjectClass::kCyclist:
      return prior(1.8, 0.6, 0.25, 0.15);
    case ObjectClass::kUnknown:
    case ObjectClass::kOther:
      break;
  }
  return prior(1.0, 1.0, 1.0, 1.0);
}

void update_extent(Gaussian<kStates>& state, const Measurement& measurement) {
  update_side(state, kLength, measurement.length);
  update_side(state, kWidth, measurement.width);
}

void resize_to_class(Gaussian<kStates>& state, ObjectClass before, ObjectClass now) {
  if (now == before || now == ObjectClass::kUnknown || now == ObjectClass::kOther) return;
  const Gaussian<2> was = extent_prior(before), is = extent_prior(now);
  for (const int place : {kLength, kWidth}) {
    const int side = place - kLength;
    const double variance = state.covariance(place, place);
    if (variance < was.covariance(side, side) / 2) continue;
    const double off = state.mean(place) - is.mean(side);
    if (off * off < kSurprise * kSurprise * (variance + is.covariance(side, side))) continue;
    replace_moment(state, place, is.mean(side), is.covariance(side, side));
  }
}

}  // namespace scanfuse::track
