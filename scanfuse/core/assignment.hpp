#pragma once

#include <Eigen/Core>
#include <span>
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

/// The same with memory that is kept from call to call: grown once, nothing is allocated.
class AssignmentSolver {
 public:
  /// Valid until the next call.
  [[nodiscard]] std::span<const int> operator()(const Eigen::Ref<const Eigen::MatrixXd>& cost);

 private:
  void scale(const Eigen::Ref<const Eigen::MatrixXd>& cost);
  [[nodiscard]] double scaled(int row, int column) const {
    return values_[static_cast<std::size_t>(row) * columns_ + column];
  }
  void augment(int start);
  int relax(int row, double shortest);
  void update_duals(int start, double shortest);
  void flip(int start, int column);

  int rows_ = 0;  ///< no more than columns_: the costs are turned where they must be
  int columns_ = 0;
  double forbidden_ = 0;
  std::vector<double> values_;  ///< row-major, scaled
  std::vector<double> u_, v_;
  std::vector<int> column_of_row_, row_of_column_;
  std::vector<double> distance_;
  std::vector<int> from_row_;
  std::vector<char> done_;
  std::vector<int> reached_;
  std::vector<int> result_;
};

}  // namespace scanfuse
