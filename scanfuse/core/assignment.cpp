#include "scanfuse/core/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

std::vector<int> solve_assignment(const Eigen::MatrixXd& cost) {
  AssignmentSolver solver;
  const auto columns = solver(cost);
  return {columns.begin(), columns.end()};
}

std::span<const int> AssignmentSolver::operator()(const Eigen::Ref<const Eigen::MatrixXd>& cost) {
  result_.assign(static_cast<std::size_t>(cost.rows()), -1);
  if (cost.size() == 0) return result_;
  scale(cost);
  u_.assign(rows_, 0.0);
  v_.assign(columns_, 0.0);
  column_of_row_.assign(rows_, -1);
  row_of_column_.assign(columns_, -1);
  for (int row = 0; row < rows_; ++row) augment(row);
  const bool turned = cost.rows() > cost.cols();
  for (int i = 0; i < rows_; ++i) {
    const int j = column_of_row_[i];
    if (scaled(i, j) >= forbidden_) continue;
    result_[turned ? j : i] = turned ? i : j;
  }
  return result_;
}

/// Finite entries scaled to [0, 1]; forbidden ones cost more than any sum of allowed ones, so that
/// they are taken only where nothing else is left.
void AssignmentSolver::scale(const Eigen::Ref<const Eigen::MatrixXd>& cost) {
  const bool turn = cost.rows() > cost.cols();
  rows_ = static_cast<int>(turn ? cost.cols() : cost.rows());
  columns_ = static_cast<int>(turn ? cost.rows() : cost.cols());
  forbidden_ = rows_ + 1.0;
  double low = kInfinity, high = -kInfinity;
  for (Eigen::Index column = 0; column < cost.cols(); ++column) {
    for (Eigen::Index row = 0; row < cost.rows(); ++row) {
      const double c = cost(row, column);
      if (!std::isfinite(c)) continue;
      low = std::min(low, c);
      high = std::max(high, c);
    }
  }
  const double half_spread = high > low ? high / 2 - low / 2 : 1;
  values_.clear();
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double c = turn ? cost(column, row) : cost(row, column);
      values_.push_back(std::isfinite(c) ? (c / 2 - low / 2) / half_spread : forbidden_);
    }
  }
}

/// Grows the assignment by one row, along the cheapest path that frees a column for it, in costs
/// reduced by the dual variables u (rows) and v (columns).
void AssignmentSolver::augment(int start) {
  distance_.assign(columns_, kInfinity);
  from_row_.assign(columns_, -1);
  done_.assign(columns_, 0);
  reached_.clear();
  double shortest = 0;
  int column = -1;
  for (int row = start; row >= 0; row = row_of_column_[column]) {
    column = relax(row, shortest);
    shortest = distance_[column];
    done_[column] = 1;
    reached_.push_back(column);
  }
  update_duals(start, shortest);
  flip(start, column);
}

/// Looks at all columns from `row`; the nearest open one. A free column wins a tie: it ends the
/// path.
int AssignmentSolver::relax(int row, double shortest) {
  int best = -1;
  for (int column = 0; column < columns_; ++column) {
    if (done_[column]) continue;
    const double through = shortest + scaled(row, column) - u_[row] - v_[column];
    if (through < distance_[column]) {
      distance_[column] = through;
      from_row_[column] = row;
    }
    if (best < 0 || distance_[column] < distance_[best] ||
        (distance_[column] == distance_[best] && row_of_column_[best] >= 0 &&
         row_of_column_[column] < 0)) {
      best = column;
    }
  }
  return best;
}

void AssignmentSolver::update_duals(int start, double shortest) {
  u_[start] += shortest;
  for (const int column : reached_) {
    v_[column] += distance_[column] - shortest;
    const int row = row_of_column_[column];
    if (row >= 0) u_[row] += shortest - distance_[column];
  }
}

void AssignmentSolver::flip(int start, int column) {
  for (int row = -1; row != start;) {
    row = from_row_[column];
    row_of_column_[column] = row;
    std::swap(column, column_of_row_[row]);
  }
}

}  // namespace scanfuse
