#include "scanfuse/classify/fit_softmax.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <deque>
#include <vector>

namespace scanfuse::classify {
namespace {

/// Loss and gradient over all samples.
class Loss {
 public:
  Loss(const Eigen::MatrixXf& terms, std::span<const int> labels, std::span<const float> shares,
       int classes, double l2)
      : terms_(terms), labels_(labels), shares_(shares), classes_(classes), l2_(l2) {
    for (const float s : shares) total_ += s;
    if (shares.empty()) total_ = static_cast<double>(labels.size());
  }

  double operator()(const Eigen::VectorXd& w, Eigen::VectorXd& gradient) const {
    const Eigen::Map<const Eigen::MatrixXd> weights(w.data(), classes_, terms_.cols());
    Eigen::MatrixXf p = terms_ * weights.cast<float>().transpose();
    double loss = 0;
    for (Eigen::Index i = 0; i < p.rows(); ++i) {
      const float share = shares_.empty() ? 1.0F : shares_[i];
      const float top = p.row(i).maxCoeff();
      const float logit = p(i, labels_[i]);
      p.row(i) = (p.row(i).array() - top).exp();
      const float sum = p.row(i).sum();
      loss += share * (std::log(sum) + top - logit);
      p.row(i) *= share / sum;
      p(i, labels_[i]) -= share;
    }
    const Eigen::MatrixXd slope = (p.transpose() * terms_).cast<double>() / total_ + l2_ * weights;
    gradient = Eigen::Map<const Eigen::VectorXd>(slope.data(), slope.size());
    return loss / total_ + l2_ / 2 * w.squaredNorm();
  }

 private:
  const Eigen::MatrixXf& terms_;
  std::span<const int> labels_;
  std::span<const float> shares_;
  int classes_;
  double l2_;
  double total_ = 0;
};

struct Pair {
  Eigen::VectorXd step, change;
  double rho = 0;
};

/// The two-loop recursion: minus the gradient, bent by what the last steps told of the curvature.
Eigen::VectorXd direction(const std::deque<Pair>& memory, const Eigen::VectorXd& gradient) {
  Eigen::VectorXd d = -gradient;
  std::vector<double> alpha(memory.size());
  for (std::size_t i = memory.size(); i-- > 0;) {
    alpha[i] = memory[i].rho * memory[i].step.dot(d);
    d -= alpha[i] * memory[i].change;
  }
  if (!memory.empty()) {
    d *= memory.back().step.dot(memory.back().change) / memory.back().change.squaredNorm();
  }
  for (std::size_t i = 0; i < memory.size(); ++i) {
    d += (alpha[i] - memory[i].rho * memory[i].change.dot(d)) * memory[i].step;
  }
  return d;
}

}  // namespace

SoftmaxFit fit_softmax(const Eigen::MatrixXf& terms, std::span<const int> labels,
                       std::span<const float> shares, int classes,
                       const SoftmaxFitOptions& options) {
  constexpr std::size_t kMemory = 12;
  SoftmaxFit fit;
  fit.weights = Eigen::MatrixXd::Zero(classes, terms.cols());
  if (labels.empty()) return fit;
  const Loss loss(terms, labels, shares, classes, options.l2);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(fit.weights.size()), gradient;
  fit.loss = loss(w, gradient);
  std::deque<Pair> memory;
  std::deque<double> past{fit.loss};
  for (; fit.iterations < options.max_iterations && !fit.converged; ++fit.iterations) {
    const Eigen::VectorXd d = direction(memory, gradient);
    double length = memory.empty() ? 1 / std::max(gradient.norm(), 1.0) : 1;
    Eigen::VectorXd next, next_gradient;
    double value = 0;
    for (int halvings = 0; halvings < 30; ++halvings, length /= 2) {
      next = w + length * d;
      value = loss(next, next_gradient);
      if (value <= fit.loss + 1e-4 * length * gradient.dot(d)) break;
    }
    if (!(value < fit.loss)) break;
    Pair pair{next - w, next_gradient - gradient, 0};
    const double curvature = pair.step.dot(pair.change);
    if (curvature > 1e-12) {
      pair.rho = 1 / curvature;
      memory.push_back(std::move(pair));
      if (memory.size() > kMemory) memory.pop_front();
    }
    w = next;
    gradient = next_gradient;
    fit.loss = value;
    past.push_back(value);
    if (past.size() > 10) {
      fit.converged = past.front() - value < options.tolerance * value;
      past.pop_front();
    }
  }
  fit.weights = Eigen::Map<const Eigen::MatrixXd>(w.data(), classes, terms.cols());
  return fit;
}

double fit_temperature(const Eigen::MatrixXd& logits, std::span<const int> labels) {
  if (labels.empty()) return 1;
  const auto loss = [&](double log_temperature) {
    const Eigen::MatrixXd z = logits / std::exp(log_temperature);
    double sum = 0;
    for (Eigen::Index i = 0; i < z.rows(); ++i) {
      const double top = z.row(i).maxCoeff();
      sum += top + std::log((z.row(i).array() - top).exp().sum()) - z(i, labels[i]);
    }
    return sum;
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = std::log(0.2), high = std::log(5.0);
  for (int i = 0; i < 24; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (loss(left) < loss(right) ? high : low) = loss(left) < loss(right) ? right : left;
  }
  return std::exp((low + high) / 2);
}

}  // namespace scanfuse::classify
