#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace scanfuse::camera {

/// A Gaussian and its first two derivatives, sampled. Correlation with them (sum of kernel[i] *
/// value[centre + i - radius]) gives the smoothed value, its slope and its curvature; the samples
/// are scaled so that a constant, a slope of one and a curvature of one come out exactly.
struct GaussianKernels {
  int radius = 0;
  std::vector<float> value, slope, curvature;

  explicit GaussianKernels(double sigma) : radius(std::max(2, static_cast<int>(3 * sigma + 0.5))) {
    const int size = 2 * radius + 1;
    std::vector<double> g, d, c;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
    double second = 0, fourth = 0;
    for (int i = -radius; i <= radius; ++i) {
      g.push_back(std::exp(-0.5 * i * i / (sigma * sigma)) / sum);
      second += g.back() * i * i;
      fourth += g.back() * i * i * i * i;
    }
    for (int i = 0; i < size; ++i) {
      const double x = i - radius, weight = g[static_cast<std::size_t>(i)];
      value.push_back(static_cast<float>(weight));
      slope.push_back(static_cast<float>(weight * x / second));
      // Orthogonal to constants; of x^2 / 2 it makes one.
      curvature.push_back(
          static_cast<float>(2 * weight * (x * x - second) / (fourth - second * second)));
    }
  }
};

}  // namespace scanfuse::camera
