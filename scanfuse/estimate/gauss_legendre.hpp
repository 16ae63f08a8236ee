#pragma once

#include <array>

namespace scanfuse::estimate {

struct QuadratureNode {
  double place;  ///< in (0, 1)
  double weight;
};

/// Gauss-Legendre on [0, 1]: eight nodes integrate polynomials up to degree 15 exactly.
inline constexpr std::array<QuadratureNode, 8> kGaussLegendre = [] {
  constexpr double place[] = {0.18343464249564980494, 0.52553240991632898582,
                              0.79666647741362673959, 0.96028985649753623168};
  constexpr double weight[] = {0.36268378337836198297, 0.31370664587788728734,
                               0.22238103445337447054, 0.10122853629037625915};
  std::array<QuadratureNode, 8> nodes{};
  for (int i = 0; i < 4; ++i) {
    nodes[4 + i] = {(1 + place[i]) / 2, weight[i] / 2};
    nodes[3 - i] = {(1 - place[i]) / 2, weight[i] / 2};
  }
  return nodes;
}();

/// Calls visit(t, weight) so that the sum of weight * f(t) is int_0^end f(t) dt, in equal panels.
template <class Visit>
void for_each_node(double end, int panels, Visit&& visit) {
  const double width = end / panels;
  for (int panel = 0; panel < panels; ++panel) {
    for (const QuadratureNode& node : kGaussLegendre) {
      visit((panel + node.place) * width, node.weight * width);
    }
  }
}

}  // namespace scanfuse::estimate
