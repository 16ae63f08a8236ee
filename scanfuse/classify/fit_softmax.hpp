#pragma once

#include <Eigen/Core>
#include <span>

namespace scanfuse::classify {

struct SoftmaxFitOptions {
  double l2 = 1e-4;  ///< penalty l2 / 2 |W|^2 on the mean log loss
  int max_iterations = 300;
  double tolerance = 1e-6;  ///< stops when the loss falls by less, relative, over ten steps
};

struct SoftmaxFit {
  Eigen::MatrixXd weights;  ///< classes x terms
  double loss = 0;          ///< mean -ln p(label) with the penalty
  int iterations = 0;
  bool converged = false;
};

/// Multinomial logistic regression by L-BFGS [Nocedal1980] from zero: minimises
///
///   sum_i s_i (-ln p(y_i | x_i)) / sum_i s_i + l2 / 2 |W|^2,   p = softmax(W x)
///
/// `terms`: one row a sample; `labels` in [0, classes); `shares` s_i > 0, empty: all 1. No samples:
/// zero weights. Same input: same bytes.
[[nodiscard]] SoftmaxFit fit_softmax(const Eigen::MatrixXf& terms, std::span<const int> labels,
                                     std::span<const float> shares, int classes,
                                     const SoftmaxFitOptions& options = {});

/// The temperature T that makes softmax(logits / T) likeliest for the labels [Guo2017]; golden
/// section search over ln T in [ln 0.2, ln 5]. No samples: 1.
[[nodiscard]] double fit_temperature(const Eigen::MatrixXd& logits, std::span<const int> labels);

}  // namespace scanfuse::classify
