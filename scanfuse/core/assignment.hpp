#pragma once

#include <Eigen/Core>
#include <vector>

namespace scanfuse {

/// Which column each row takes, -1 for none: as many pairs as the allowed entries permit, and among
/// those the least sum of costs. Each column is taken once at most.
///
/// `cost` is rows x columns, of any shape, also empty. +infinity (or NaN) forbids a pair; finite
/// entries may be negative. Optimal to about 1e-14 of the spread of the finite entries. Ties break
/// the same way on every run. To let a row stay free at a price, append a column for it that holds
/// that price (infinity in all other rows).
///
/// Shortest augmenting paths with dual variables, O(rows^2 columns) [Crouse2016].
[[nodiscard]] std::vector<int> solve_assignment(const Eigen::MatrixXd& cost);

}  // namespace scanfuse
