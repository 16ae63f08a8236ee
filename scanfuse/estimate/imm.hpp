#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "scanfuse/estimate/extended_kalman.hpp"

/// Interacting multiple models: several motion models run side by side on one state, and the data
/// say which of them holds [Blom1988], [BarShalom2001, section 11.6].
namespace scanfuse::estimate {

/// The one Gaussian with the mean and covariance of a mixture. Angles are averaged about the
/// component of the largest weight. Weights are not negative and sum to one.
template <int N, std::size_t K>
[[nodiscard]] Gaussian<N> moment_match(const std::array<Gaussian<N>, K>& components,
                                       const Eigen::Matrix<double, static_cast<int>(K), 1>& weights,
                                       Angles angles = {}) {
  Eigen::Index heaviest = 0;
  weights.maxCoeff(&heaviest);
  const Eigen::Matrix<double, N, 1> origin = components[heaviest].mean;
  std::array<Eigen::Matrix<double, N, 1>, K> offsets;
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  for (std::size_t k = 0; k < K; ++k) {
    offsets[k] = wrapped<N>(components[k].mean - origin, angles);
    mean += weights(k) * offsets[k];
  }
  Gaussian<N> merged{wrapped<N>(origin + mean, angles), Eigen::Matrix<double, N, N>::Zero()};
  for (std::size_t k = 0; k < K; ++k) {
    const Eigen::Matrix<double, N, 1> d = offsets[k] - mean;
    merged.covariance += weights(k) * (components[k].covariance + d * d.transpose());
  }
  return merged;
}

/// exp(rates dt): the chance to be in model j after dt when in model i before (rows sum to one).
/// rates(i, j) in 1/s for i != j, the diagonal is not read: a model is left after 1 / (sum of its
/// row) on average. Two half steps switch as one whole step, whatever the rate of the sensor.
template <int K>
[[nodiscard]] Eigen::Matrix<double, K, K> switching(const Eigen::Matrix<double, K, K>& rates,
                                                    double dt_s) {
  using Matrix = Eigen::Matrix<double, K, K>;
  Matrix generator = rates * dt_s;
  generator.diagonal().setZero();
  generator.diagonal() = -generator.rowwise().sum();
  int halvings = 0;
  for (; generator.cwiseAbs().maxCoeff() > 0.125; ++halvings) generator *= 0.5;
  Matrix power = Matrix::Identity(), sum = Matrix::Identity();
  for (int n = 1; n <= 10; ++n) {
    power = (power * generator / n).eval();
    sum += power;
  }
  for (; halvings > 0; --halvings) {
    sum = (sum * sum).eval();
    sum.array().colwise() /= sum.array().rowwise().sum().eval();
  }
  return sum;
}

/// K models on a state of N numbers. Nothing is allocated. Models that ignore a part of the state
/// run on it all the same (ctra_models.hpp holds it at zero for them), so that mixing needs no
/// translation between states.
template <int N, int K>
class Imm {
 public:
  using State = Gaussian<N>;
  using Weights = Eigen::Matrix<double, K, 1>;
  using Switching = Eigen::Matrix<double, K, K>;

  /// Every model starts with the same belief. Probabilities are not negative and sum to one.
  Imm(const State& start, const Weights& probabilities, Angles angles = {})
      : probabilities_(probabilities), angles_(angles) {
    beliefs_.fill(start);
  }

  /// Mixes the beliefs by the chance of having switched, then moves each by its own model:
  ///
  ///   c_j = sum_i pi_ij mu_i,   mu_i|j = pi_ij mu_i / c_j,   x_j = move(j, mixture of x_i by
  ///   mu_i|j)
  ///
  /// `move(int model, const Gaussian<N>&) -> Gaussian<N>`.
  template <class Move>
  void predict(const Switching& pi, Move&& move) {
    const std::array<State, K> before = beliefs_;
    const Weights reached = pi.transpose() * probabilities_;
    for (int j = 0; j < K; ++j) {
      Weights from = pi.col(j).cwiseProduct(probabilities_);
      from = reached(j) > 0 ? Weights(from / reached(j)) : Weights(Weights::Unit(j));
      beliefs_[j] = move(j, moment_match<N, K>(before, from, angles_));
    }
    probabilities_ = reached / reached.sum();
  }

  /// Folds a measurement into every model and weighs the models by how well each foresaw it.
  /// `expectation(const Gaussian<N>&) -> Expectation<N, M>`. Returns ln p(z), the log-likelihood of
  /// the mixture; a measurement that no model can explain (-inf, NaN) leaves probabilities alone.
  template <int M, class Expect>
  double update(const Gaussian<M>& z, Expect&& expectation, Angles angles_of_z = {}) {
    Weights log_likelihood;
    for (int j = 0; j < K; ++j) {
      const Expectation<N, M> h = expectation(beliefs_[j]);
      log_likelihood(j) = innovation(beliefs_[j], z, h, angles_of_z).log_likelihood();
      beliefs_[j] = estimate::update(beliefs_[j], z, h, angles_, angles_of_z);
    }
    return reweigh(log_likelihood);
  }

  /// mu_j ~ mu_j exp(log_likelihood_j), computed about the largest so that nothing underflows to
  /// 0/0. Returns ln sum_j mu_j exp(log_likelihood_j).
  double reweigh(const Weights& log_likelihood) {
    Weights logs;
    double largest = -std::numeric_limits<double>::infinity();
    for (int j = 0; j < K; ++j) {
      logs(j) = std::log(probabilities_(j)) + log_likelihood(j);
      if (logs(j) > largest) largest = logs(j);
    }
    if (!std::isfinite(largest)) return largest;
    for (int j = 0; j < K; ++j) logs(j) = std::isnan(logs(j)) ? 0 : std::exp(logs(j) - largest);
    probabilities_ = logs / logs.sum();
    return largest + std::log(logs.sum());
  }

  /// Applies the same change to every model's belief: a flipped heading, another frame.
  template <class Change>
  void transform(Change&& change) {
    for (State& belief : beliefs_) belief = change(belief);
  }

  /// The moment-matched belief of all models.
  [[nodiscard]] State combined() const {
    return moment_match<N, K>(beliefs_, probabilities_, angles_);
  }
  [[nodiscard]] const State& belief(int model) const { return beliefs_[model]; }
  [[nodiscard]] const Weights& probabilities() const { return probabilities_; }

 private:
  std::array<State, K> beliefs_;
  Weights probabilities_;
  Angles angles_;
};

}  // namespace scanfuse::estimate
