#include "scanfuse/camera/calibrate_camera.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <optional>
#include <utility>

namespace scanfuse::camera {
namespace {

/// fx, fy, cx, cy, k1, k2, p1, p2, k3.
constexpr int kIntrinsics = 9;
using Normal = Eigen::MatrixXd;  ///< 9 x 9; sizes fixed would only cost compile time

struct Views {
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> image;
};

/// What OpenCV makes of the views that it was given.
struct Solution {
  cv::Mat K = cv::Mat::eye(3, 3, CV_64F);
  cv::Mat distortion = cv::Mat::zeros(1, 5, CV_64F);  ///< k1, k2, p1, p2, k3
  std::vector<cv::Mat> turns, shifts;
  std::vector<double> rms_px;
};

Views views_of(std::span<const DetectedBoard> boards, const std::vector<std::size_t>& chosen) {
  Views views;
  for (const std::size_t i : chosen) {
    const DetectedBoard& board = boards[i];
    auto& points = views.board.emplace_back();
    auto& pixels = views.image.emplace_back();
    for (std::size_t k = 0; k < board.corners_px.size(); ++k) {
      const auto columns = static_cast<std::size_t>(board.spec.columns);
      points.emplace_back(
          static_cast<float>(static_cast<double>(k % columns) * board.spec.square_m),
          static_cast<float>(static_cast<double>(k / columns) * board.spec.square_m), 0.0F);
      pixels.emplace_back(static_cast<float>(board.corners_px[k].x()),
                          static_cast<float>(board.corners_px[k].y()));
    }
  }
  return views;
}

int flags_of(const CameraCalibrationOptions& options) {
  int flags = 0;
  if (!options.tangential) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  if (options.radial_terms < 1) flags |= cv::CALIB_FIX_K1;
  if (options.radial_terms < 2) flags |= cv::CALIB_FIX_K2;
  if (options.radial_terms < 3) flags |= cv::CALIB_FIX_K3;
  return flags;
}

bool is_estimated(int intrinsic, const CameraCalibrationOptions& options) {
  switch (intrinsic) {
    case 4:
      return options.radial_terms >= 1;
    case 5:
      return options.radial_terms >= 2;
    case 6:
    case 7:
      return options.tangential;
    case 8:
      return options.radial_terms >= 3;
    default:
      return true;
  }
}

Solution solve(const Views& views, cv::Size size, const CameraCalibrationOptions& options) {
  Solution solution;
  cv::Mat unused, per_view;
  cv::calibrateCamera(views.board, views.image, size, solution.K, solution.distortion,
                      solution.turns, solution.shifts, unused, unused, per_view, flags_of(options),
                      {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 100, 1e-12});
  for (int i = 0; i < per_view.rows; ++i) solution.rms_px.push_back(per_view.at<double>(i));
  return solution;
}

Pose3 pose_of(const cv::Mat& turn, const cv::Mat& shift) {
  const Eigen::Vector3d w(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  Pose3 pose;
  if (const double angle = w.norm(); angle > 0) {
    pose.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, w / angle));
  }
  pose.translation_m = {shift.at<double>(0), shift.at<double>(1), shift.at<double>(2)};
  return pose;
}

/// One view's share of the normal equations of the intrinsics, its pose eliminated:
/// A - B C^-1 B' with A, B, C the blocks of J'J.
Normal reduced_normal(const Views& views, const Solution& solution, std::size_t view,
                      const CameraCalibrationOptions& options) {
  std::vector<cv::Point2f> projected;
  cv::Mat jacobian;  // columns: rotation 3, translation 3, fx fy cx cy, k1 k2 p1 p2 k3
  cv::projectPoints(views.board[view], solution.turns[view], solution.shifts[view], solution.K,
                    solution.distortion, projected, jacobian, 0);
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> J(
      jacobian.ptr<double>(), jacobian.rows, jacobian.cols);
  const Eigen::MatrixXd pose = J.leftCols(6);
  Eigen::MatrixXd inner = J.middleCols(6, kIntrinsics);
  for (int i = 0; i < kIntrinsics; ++i) {
    if (!is_estimated(i, options)) inner.col(i).setZero();
  }
  const Eigen::MatrixXd B = inner.transpose() * pose;
  const Eigen::MatrixXd C = pose.transpose() * pose;
  return inner.transpose() * inner - B * C.ldlt().solve(B.transpose());
}

/// Covariance of the estimated intrinsics for corner errors of variance `variance`; nothing where
/// the views do not determine them.
std::optional<Normal> covariance_of(const Views& views, const Solution& solution, double variance,
                                    const CameraCalibrationOptions& options) {
  Normal normal = Normal::Zero(kIntrinsics, kIntrinsics);
  for (std::size_t i = 0; i < views.board.size(); ++i) {
    normal += reduced_normal(views, solution, i, options);
  }
  Eigen::VectorXd scale(kIntrinsics);
  for (int i = 0; i < kIntrinsics; ++i) {
    if (!is_estimated(i, options)) normal(i, i) = 1;
    if (!(normal(i, i) > 0)) return {};
    scale[i] = 1 / std::sqrt(normal(i, i));
  }
  const Normal scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Normal> solver(scaled);
  if (!(solver.eigenvalues()[0] > 1e-12)) return {};
  Normal covariance =
      variance * (scale.asDiagonal() * Normal(scaled.inverse()) * scale.asDiagonal());
  for (int i = 0; i < kIntrinsics; ++i) {
    if (is_estimated(i, options)) continue;
    covariance.row(i).setZero();
    covariance.col(i).setZero();
  }
  return covariance;
}

Camera camera_of(const Solution& solution, int width_px, int height_px) {
  const auto k = [&](int r, int c) { return solution.K.at<double>(r, c); };
  const auto d = [&](int i) { return solution.distortion.at<double>(i); };
  return {.width_px = width_px,
          .height_px = height_px,
          .fx_px = k(0, 0),
          .fy_px = k(1, 1),
          .cx_px = k(0, 2),
          .cy_px = k(1, 2),
          .k1 = d(0),
          .k2 = d(1),
          .p1 = d(2),
          .p2 = d(3),
          .k3 = d(4)};
}

bool is_sound(const Camera& camera) {
  const double all = camera.fx_px + camera.fy_px + camera.cx_px + camera.cy_px + camera.k1 +
                     camera.k2 + camera.p1 + camera.p2 + camera.k3;
  return std::isfinite(all) && camera.fx_px > 0 && camera.fy_px > 0;
}

Result<void> check(std::span<const DetectedBoard> boards, int width_px, int height_px) {
  if (boards.size() < 3) {
    return fail(Error::Code::kOutOfRange,
                "{} view{} of a chessboard: three or more are needed, each turned another way",
                boards.size(), boards.size() == 1 ? "" : "s");
  }
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const auto& board = boards[i];
    const auto corners = static_cast<std::size_t>(std::max(board.spec.rows, 0)) *
                         static_cast<std::size_t>(std::max(board.spec.columns, 0));
    if (corners < 4 || board.corners_px.size() != corners || !(board.spec.square_m > 0)) {
      return fail(Error::Code::kMalformed, "view {}: {} corners do not make {} x {} of {} m", i + 1,
                  board.corners_px.size(), board.spec.rows, board.spec.columns,
                  board.spec.square_m);
    }
    for (const auto& p : board.corners_px) {
      if (!(p.x() > -1 && p.y() > -1 && p.x() < width_px && p.y() < height_px)) {
        return fail(
            Error::Code::kOutOfRange,
            "view {}: a corner at ({:.1f}, {:.1f}) lies outside the image of {} x {} pixels", i + 1,
            p.x(), p.y(), width_px, height_px);
      }
    }
  }
  return {};
}

/// Those of `chosen` whose rms does not stand out; never fewer than three.
std::vector<std::size_t> without_outliers(const std::vector<std::size_t>& chosen,
                                          const Solution& solution, double ratio) {
  std::vector<double> sorted = solution.rms_px;
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (solution.rms_px[i] <= ratio * median) kept.push_back(chosen[i]);
  }
  return kept.size() >= 3 ? kept : chosen;
}

CameraCalibration result_of(const Solution& solution, const std::vector<std::size_t>& chosen,
                            const Views& views, std::size_t given, cv::Size size) {
  CameraCalibration result;
  result.camera = camera_of(solution, size.width, size.height);
  result.views.assign(given, {false, 0, {}});
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    result.views[chosen[i]] = {true, solution.rms_px[i],
                               pose_of(solution.turns[i], solution.shifts[i])};
    const auto corners = static_cast<double>(views.image[i].size());
    sum += corners * solution.rms_px[i] * solution.rms_px[i];
    count += corners;
  }
  result.rms_px = std::sqrt(sum / count);
  return result;
}

}  // namespace

Result<CameraCalibration> calibrate_camera(std::span<const DetectedBoard> boards, int width_px,
                                           int height_px, const CameraCalibrationOptions& options) {
  if (auto fine = check(boards, width_px, height_px); !fine) return tl::unexpected(fine.error());
  const cv::Size size(width_px, height_px);
  std::vector<std::size_t> chosen(boards.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
  Views views = views_of(boards, chosen);
  Solution solution = solve(views, size, options);
  const auto kept = without_outliers(chosen, solution, options.outlier_ratio);
  if (kept.size() < chosen.size()) {
    chosen = kept;
    views = views_of(boards, chosen);
    solution = solve(views, size, options);
  }
  CameraCalibration result = result_of(solution, chosen, views, boards.size(), size);
  // Both coordinates together have twice the variance of one.
  const auto covariance =
      covariance_of(views, solution, 0.5 * result.rms_px * result.rms_px, options);
  if (!covariance || !is_sound(result.camera)) {
    return fail(Error::Code::kOutOfRange,
                "these {} views do not determine the camera: turn the board about both of its "
                "sides, by 20 to 45 degrees, and fill the image with it",
                chosen.size());
  }
  result.covariance = *covariance;
  return result;
}

}  // namespace scanfuse::camera
