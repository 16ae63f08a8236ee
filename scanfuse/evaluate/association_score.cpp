#include "scanfuse/evaluate/association_score.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scanfuse/core/assignment.hpp"

namespace scanfuse::evaluate {
namespace {

double squared_ospa(std::span<const Fix> fixes, std::span<const Eigen::Vector3d> targets_m,
                    double cutoff_m) {
  const auto rows = static_cast<Eigen::Index>(fixes.size());
  const auto columns = static_cast<Eigen::Index>(targets_m.size());
  const Eigen::Index most = std::max(rows, columns), least = std::min(rows, columns);
  if (most == 0) return 0;
  const double cut = cutoff_m * cutoff_m;
  Eigen::MatrixXd cost(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      cost(i, j) = std::min(cut, (fixes[static_cast<std::size_t>(i)].position_m -
                                  targets_m[static_cast<std::size_t>(j)])
                                     .squaredNorm());
    }
  }
  double sum = cut * static_cast<double>(most - least);
  const auto column_of_row = solve_assignment(cost);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int j = column_of_row[static_cast<std::size_t>(i)];
    if (j >= 0) sum += cost(i, j);
  }
  return sum / static_cast<double>(most);
}

double ratio(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : std::nan("");
}

}  // namespace

std::optional<std::int64_t> origin_of(const BearingScan& scan, const Fix& fix) {
  const auto origin = [&](std::int32_t place) {
    return scan.bearings[static_cast<std::size_t>(place)].truth.value_or(-1);
  };
  const std::int64_t first = fix.bearings.empty() ? -1 : origin(fix.bearings.front());
  const bool pure = first >= 0 && std::ranges::all_of(fix.bearings, [&](std::int32_t place) {
                      return origin(place) == first;
                    });
  return pure ? std::optional(first) : std::nullopt;
}

AssociationScore& AssociationScore::operator+=(const AssociationScore& other) {
  scenes += other.scenes;
  targets += other.targets;
  fixes += other.fixes;
  exact += other.exact;
  ghosts += other.ghosts;
  squared_ospa += other.squared_ospa;
  return *this;
}

double AssociationScore::exact_rate() const { return ratio(exact, targets); }
double AssociationScore::f1() const { return ratio(2 * exact, targets + fixes); }
double AssociationScore::ghosts_per_scene() const { return ratio(ghosts, scenes); }
double AssociationScore::ospa_m() const {
  return scenes > 0 ? std::sqrt(squared_ospa / static_cast<double>(scenes)) : std::nan("");
}

void AssociationScore::add(const BearingScan& scan, std::span<const Fix> found,
                           std::span<const Eigen::Vector3d> targets_m, double cutoff_m) {
  std::map<std::int64_t, std::size_t> bearings_of_target;
  for (const Bearing& b : scan.bearings) {
    if (b.truth.value_or(-1) >= 0) ++bearings_of_target[*b.truth];
  }
  ++scenes;
  fixes += std::ssize(found);
  targets += std::ranges::count_if(bearings_of_target, [](const auto& t) { return t.second >= 2; });
  for (const Fix& fix : found) {
    const auto origin = origin_of(scan, fix);
    ghosts += !origin;
    exact += origin && fix.bearings.size() == bearings_of_target[*origin];
  }
  squared_ospa += evaluate::squared_ospa(found, targets_m, cutoff_m);
}

}  // namespace scanfuse::evaluate
