#include "scanfuse/core/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Row-major, rows <= columns; finite entries scaled to [0, 1]; forbidden ones cost more than any
/// sum of allowed ones, so that they are taken only where nothing else is left.
struct ScaledCosts {
  int rows = 0;
  int columns = 0;
  double forbidden = 0;
  std::vector<double> values;

  [[nodiscard]] double operator()(int row, int column) const {
    return values[static_cast<std::size_t>(row) * columns + column];
  }
};

ScaledCosts scaled_costs(const Eigen::MatrixXd& cost) {
  const bool turn = cost.rows() > cost.cols();
  ScaledCosts scaled;
  scaled.rows = static_cast<int>(turn ? cost.cols() : cost.rows());
  scaled.columns = static_cast<int>(turn ? cost.rows() : cost.cols());
  scaled.forbidden = scaled.rows + 1.0;
  double low = kInfinity, high = -kInfinity;
  for (const double c : cost.reshaped()) {
    if (!std::isfinite(c)) continue;
    low = std::min(low, c);
    high = std::max(high, c);
  }
  const double half_spread = high > low ? high / 2 - low / 2 : 1;
  scaled.values.reserve(static_cast<std::size_t>(cost.size()));
  for (int row = 0; row < scaled.rows; ++row) {
    for (int column = 0; column < scaled.columns; ++column) {
      const double c = turn ? cost(column, row) : cost(row, column);
      scaled.values.push_back(std::isfinite(c) ? (c / 2 - low / 2) / half_spread
                                               : scaled.forbidden);
    }
  }
  return scaled;
}

/// Grows a complete assignment of the rows one row at a time, each along the cheapest path that
/// frees a column for it, in costs reduced by the dual variables u (rows) and v (columns).
class AugmentingPaths {
 public:
  explicit AugmentingPaths(const ScaledCosts& cost)
      : cost_(cost),
        u_(cost.rows, 0.0),
        v_(cost.columns, 0.0),
        column_of_row_(cost.rows, -1),
        row_of_column_(cost.columns, -1) {
    for (int row = 0; row < cost_.rows; ++row) augment(row);
  }
  [[nodiscard]] const std::vector<int>& column_of_row() const { return column_of_row_; }

 private:
  void augment(int start) {
    distance_.assign(cost_.columns, kInfinity);
    from_row_.assign(cost_.columns, -1);
    done_.assign(cost_.columns, 0);
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
  int relax(int row, double shortest) {
    int best = -1;
    for (int column = 0; column < cost_.columns; ++column) {
      if (done_[column]) continue;
      const double through = shortest + cost_(row, column) - u_[row] - v_[column];
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

  void update_duals(int start, double shortest) {
    u_[start] += shortest;
    for (const int column : reached_) {
      v_[column] += distance_[column] - shortest;
      const int row = row_of_column_[column];
      if (row >= 0) u_[row] += shortest - distance_[column];
    }
  }

  void flip(int start, int column) {
    for (int row = -1; row != start;) {
      row = from_row_[column];
      row_of_column_[column] = row;
      std::swap(column, column_of_row_[row]);
    }
  }

  const ScaledCosts& cost_;
  std::vector<double> u_, v_;
  std::vector<int> column_of_row_, row_of_column_;
  std::vector<double> distance_;
  std::vector<int> from_row_;
  std::vector<char> done_;
  std::vector<int> reached_;
};

}  // namespace

std::vector<int> solve_assignment(const Eigen::MatrixXd& cost) {
  std::vector<int> column_of_row(static_cast<std::size_t>(cost.rows()), -1);
  if (cost.size() == 0) return column_of_row;
  const ScaledCosts scaled = scaled_costs(cost);
  const AugmentingPaths paths(scaled);
  const bool turned = cost.rows() > cost.cols();
  for (int i = 0; i < scaled.rows; ++i) {
    const int j = paths.column_of_row()[i];
    if (scaled(i, j) >= scaled.forbidden) continue;
    column_of_row[turned ? j : i] = turned ? i : j;
  }
  return column_of_row;
}

}  // namespace scanfuse
