#include <ceres/ceres.h>

#include <memory>
#include <numeric>

#include "scanfuse/calibrate/joint.hpp"
#include "scanfuse/calibrate/joint_costs.hpp"
#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::calibrate {
namespace {

using StripeCost = ceres::AutoDiffCostFunction<costs::Stripe, 2, 12, 6, 1>;
using LidarCost = ceres::AutoDiffCostFunction<costs::Lidar, 4, 12, 6, 1, 1>;
using CornerCost = ceres::AutoDiffCostFunction<costs::Corner, 2, 6>;

template <int Rows, int Columns>
using RowMajor = Eigen::Matrix<double, Rows, Columns, Eigen::RowMajor>;

Eigen::Index board_place(std::size_t board) {
  return kBoardAt + 6 * static_cast<Eigen::Index>(board);
}

void add_stripe_rows(const costs::Stripe& cost, std::vector<JointRow>& rows) {
  const StripeCost function(new costs::Stripe(cost));
  const double zeros[12] = {};
  const double* parameters[] = {zeros, zeros, zeros};
  double residual[2];
  RowMajor<2, 12> by_rig;
  RowMajor<2, 6> by_board;
  Eigen::Vector2d by_angle;
  double* jacobians[] = {by_rig.data(), by_board.data(), by_angle.data()};
  function.Evaluate(parameters, residual, jacobians);
  const StripeLine& line = cost.sample.stripes[cost.board];
  for (int i = 0; i < 2; ++i) {
    JointRow row;
    row.a.head<12>() = by_rig.row(i);
    row.a.segment<6>(board_place(cost.board)) = by_board.row(i);
    row.angle = by_angle[i];
    row.y = -residual[i];
    row.stripe = true;
    row.effect = i == 0 ? LineEffect::kStripeOffset : LineEffect::kStripeTilt;
    row.share = i == 0 ? line.weight : line.moment;
    rows.push_back(row);
  }
}

void add_lidar_rows(const costs::Lidar& cost, std::vector<JointRow>& rows) {
  const LidarCost function(new costs::Lidar(cost));
  const double zeros[12] = {};
  const double* parameters[] = {zeros, zeros, zeros, zeros};
  double residual[4];
  RowMajor<4, 12> by_rig;
  RowMajor<4, 6> by_board;
  Eigen::Vector4d by_angle, by_square;
  double* jacobians[] = {by_rig.data(), by_board.data(), by_angle.data(), by_square.data()};
  function.Evaluate(parameters, residual, jacobians);
  const LidarLine& line = cost.sample.lines[cost.board];
  constexpr LineEffect kOf[] = {LineEffect::kLidarOffset, LineEffect::kLidarTilt,
                                LineEffect::kLidarBow, LineEffect::kNone};
  for (int i = 0; i < 4; ++i) {
    if (line.R(i, i) == 0) continue;
    JointRow row;
    row.a.head<12>() = by_rig.row(i);
    row.a.segment<6>(board_place(cost.board)) = by_board.row(i);
    row.a[kSquareAt] = by_square[i];
    row.angle = by_angle[i];
    row.y = -residual[i];
    row.effect = kOf[i];
    row.share = line.R(i, i) * line.R(i, i);
    rows.push_back(row);
  }
}

void add_corner(const costs::Corner& cost, JointSystem& system) {
  const CornerCost function(new costs::Corner(cost));
  const double zeros[6] = {};
  const double* parameters[] = {zeros};
  Eigen::Vector2d residual;
  RowMajor<2, 6> J;
  double* jacobians[] = {J.data()};
  function.Evaluate(parameters, residual.data(), jacobians);
  const Eigen::Index at = board_place(cost.board);
  system.corner_information.block<6, 6>(at, at) += J.transpose() * J;
  system.corner_right.segment<6>(at) -= J.transpose() * residual;
  system.corner_squares += residual.squaredNorm();
  system.corner_rows += 2;
}

/// One over the standard deviation of each row of a line.
double scale_of(double point_variance, const JointNoise& noise, LineEffect effect, double share) {
  const double shared =
      effect == LineEffect::kNone ? 0 : share * noise.effect[static_cast<std::size_t>(effect)];
  return 1 / std::sqrt(point_variance + shared);
}

Pose3 moved(const Pose3& pose, const double* change) {
  const Eigen::Vector3d w(change[0], change[1], change[2]);
  Pose3 out = pose;
  if (w.norm() > 0) {
    out.rotation = (Eigen::Quaterniond(Eigen::AngleAxisd(w.norm(), w.normalized())) * pose.rotation)
                       .normalized();
  }
  out.translation_m += Eigen::Vector3d(change[3], change[4], change[5]);
  return out;
}

/// The unknowns of one Ceres problem, all zero at the start.
struct Changes {
  std::array<double, 12> rig{};
  std::array<std::array<double, 6>, 2> boards{};
  std::array<double, 1> square{};
  std::vector<double> angles;
};

struct Prior {
  double scale;
  double start;
  template <class T>
  bool operator()(const T* angle, T* residual) const {
    residual[0] = scale * (start + angle[0]);
    return true;
  }
};

void add_lines(const JointInput& input, const JointState& state, const JointNoise& noise,
               Changes& changes, ceres::LossFunction* loss, ceres::Problem& problem) {
  using enum LineEffect;
  for (std::size_t i = 0; i < input.samples.size(); ++i) {
    const Sample& sample = input.samples[i];
    double* angle = &changes.angles[i];
    for (std::size_t b = 0; b < 2; ++b) {
      costs::Stripe stripe{state, input.camera, sample, b, i};
      const StripeLine& line = sample.stripes[b];
      stripe.scale << scale_of(noise.stripe_px2, noise, kStripeOffset, line.weight),
          scale_of(noise.stripe_px2, noise, kStripeTilt, line.moment);
      problem.AddResidualBlock(new StripeCost(new costs::Stripe(stripe)), loss, changes.rig.data(),
                               changes.boards[b].data(), angle);
      costs::Lidar lidar{state, sample, b, i};
      const Eigen::Vector4d R = sample.lines[b].R.diagonal();
      lidar.scale << scale_of(noise.range_m2, noise, kLidarOffset, R[0] * R[0]),
          scale_of(noise.range_m2, noise, kLidarTilt, R[1] * R[1]),
          scale_of(noise.range_m2, noise, kLidarBow, R[2] * R[2]), 1 / std::sqrt(noise.range_m2);
      problem.AddResidualBlock(new LidarCost(new costs::Lidar(lidar)), loss, changes.rig.data(),
                               changes.boards[b].data(), angle, changes.square.data());
    }
    const double variance = noise.turntable_rad2 + noise.effect[kEffects - 1];
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Prior, 1, 1>(
                                 new Prior{1 / std::sqrt(variance), state.correction_rad[i]}),
                             nullptr, angle);
  }
}

void hold_constant(const JointUnknowns& unknowns, Changes& changes, ceres::Problem& problem) {
  std::vector<int> held;
  if (!unknowns.range_bias) held.push_back(10);
  if (!unknowns.angle_scale) held.push_back(11);
  if (!held.empty()) {
    problem.SetManifold(changes.rig.data(), new ceres::SubsetManifold(12, held));
  }
  if (!unknowns.square_bias) problem.SetParameterBlockConstant(changes.square.data());
}

ceres::Solver::Options solver_options(Changes& changes) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (double& angle : changes.angles) options.linear_solver_ordering->AddElementToGroup(&angle, 0);
  options.linear_solver_ordering->AddElementToGroup(changes.rig.data(), 1);
  for (auto& board : changes.boards) {
    options.linear_solver_ordering->AddElementToGroup(board.data(), 1);
  }
  options.linear_solver_ordering->AddElementToGroup(changes.square.data(), 1);
  options.max_num_iterations = 60;
  options.function_tolerance = 1e-10;
  options.parameter_tolerance = 1e-12;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

JointSystem linearise(const JointInput& input, const JointState& state) {
  JointSystem system;
  system.correction_rad = state.correction_rad;
  for (std::size_t i = 0; i < input.samples.size(); ++i) {
    auto& rows = system.samples.emplace_back();
    for (std::size_t b = 0; b < 2; ++b) {
      add_stripe_rows({state, input.camera, input.samples[i], b, i}, rows);
      add_lidar_rows({state, input.samples[i], b, i}, rows);
    }
  }
  for (std::size_t b = 0; b < 2; ++b) {
    for (const auto& corner : input.corners[b]) {
      add_corner({state, input.camera, corner, b}, system);
    }
  }
  return system;
}

JointRun minimise(const JointInput& input, const JointState& start, const JointNoise& noise,
                  const JointUnknowns& unknowns, bool robust) {
  JointRun run{start};
  Changes changes;
  changes.angles.assign(input.samples.size(), 0);
  ceres::CauchyLoss cauchy(3);
  ceres::HuberLoss huber(4);
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  add_lines(input, run.state, noise, changes, robust ? &cauchy : nullptr, problem);
  const double corner_scale = 1 / std::sqrt(noise.corner_px2);
  for (std::size_t b = 0; b < 2; ++b) {
    for (const auto& corner : input.corners[b]) {
      problem.AddResidualBlock(
          new CornerCost(new costs::Corner{run.state, input.camera, corner, b, corner_scale}),
          robust ? &huber : nullptr, changes.boards[b].data());
    }
  }
  hold_constant(unknowns, changes, problem);
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(changes), &problem, &summary);
  run.iterations = static_cast<int>(summary.iterations.size());
  run.converged = summary.termination_type == ceres::CONVERGENCE;
  if (!summary.IsSolutionUsable()) return run;
  run.state.rig = changed(start.rig, Eigen::Map<const RigVector>(changes.rig.data()));
  for (std::size_t b = 0; b < 2; ++b) {
    run.state.camera_from_board[b] = moved(start.camera_from_board[b], changes.boards[b].data());
  }
  run.state.square_bias_m += changes.square[0];
  for (std::size_t i = 0; i < changes.angles.size(); ++i) {
    run.state.correction_rad[i] += changes.angles[i];
  }
  return run;
}

}  // namespace scanfuse::calibrate
