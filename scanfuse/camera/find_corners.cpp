#include "scanfuse/camera/find_corners.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "scanfuse/camera/grid.hpp"

namespace scanfuse::camera {
namespace {

using Points = std::vector<cv::Point2f>;

cv::Mat view_of(const Image& grey) {
  // OpenCV takes no pointer to const; nothing below writes.
  return {grey.height_px, grey.width_px, CV_8UC1, const_cast<std::uint8_t*>(grey.pixels.data())};
}

/// The detector at another scale: a large image is searched faster and with less noise when small,
/// small squares are told apart when large.
bool find_scaled(const cv::Mat& grey, cv::Size pattern, double scale, Points& corners) {
  constexpr int kFlags = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE;
  cv::Mat scaled = grey;
  if (scale != 1) {
    cv::resize(grey, scaled, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  }
  if (!cv::findChessboardCorners(scaled, pattern, corners, kFlags)) return false;
  // Pixel centres lie on whole numbers at either scale.
  for (auto& c : corners) {
    c.x = static_cast<float>((c.x + 0.5) / scale - 0.5);
    c.y = static_cast<float>((c.y + 0.5) / scale - 0.5);
  }
  return true;
}

/// Never above some 1600 pixels: in a larger image that holds no such board, but many squares,
/// the search takes minutes. What is too small then is left to the fallback.
std::vector<double> scales_for(const cv::Mat& grey) {
  const int longest = std::max(grey.cols, grey.rows);
  if (longest > 2400) return {1200.0 / longest};
  if (longest > 1200) return {0.5};
  if (longest > 800) return {1};
  return {1, 2};
}

std::vector<Eigen::Vector2d> to_eigen(const Points& points) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(points.size());
  for (const auto& p : points) out.emplace_back(p.x, p.y);
  return out;
}

void refine(const cv::Mat& grey, Points& corners, double side, const BoardOptions& options) {
  const int half = std::clamp(static_cast<int>(std::lround(options.half_window * side)), 2, 20);
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 60, 1e-4});
}

std::optional<DetectedBoard> finished(const cv::Mat& grey, const BoardSpec& spec, Points corners,
                                      const BoardOptions& options) {
  const auto rough = to_eigen(corners);
  if (!is_flat_grid(rough, spec)) return {};
  refine(grey, corners, shortest_side(rough, spec), options);
  DetectedBoard board;
  board.spec = spec;
  board.corners_px = in_order(to_eigen(corners), spec);
  if (!is_flat_grid(board.corners_px, spec)) return {};
  board.sigma_px = corner_sigma(board.corners_px, spec);
  board.square_px = shortest_side(board.corners_px, spec);
  return board;
}

/// Weighs the 3 x 3 pixels around each by 1 2 1 both ways.
void smooth(Image& grey) {
  cv::Mat view(grey.height_px, grey.width_px, CV_8UC1, grey.pixels.data());
  const float weights[] = {0.25F, 0.5F, 0.25F};
  const cv::Mat kernel(1, 3, CV_32F, const_cast<float*>(weights));
  cv::sepFilter2D(view, view, CV_8U, kernel, kernel);
}

/// The four kinds of pixels of a raw mosaic see other colours, so their means differ; those of any
/// other image do not.
bool is_mosaic(const Image& grey) {
  std::array<double, 4> sums{};
  for (int r = 0; r + 1 < grey.height_px; r += 2) {
    for (int c = 0; c + 1 < grey.width_px; c += 2) {
      for (int k = 0; k < 4; ++k) {
        sums[static_cast<std::size_t>(k)] += grey.at(c + k % 2, r + k / 2);
      }
    }
  }
  const auto [low, high] = std::minmax_element(sums.begin(), sums.end());
  return *high > 1.03 * *low;
}

}  // namespace

Image board_grey(const Image& image) {
  if (image.channels == 1) {
    Image grey = image;
    if (is_mosaic(grey)) smooth(grey);
    return grey;
  }
  Image grey;
  grey.width_px = image.width_px;
  grey.height_px = image.height_px;
  grey.pixels.resize(image.pixels.size() / 3);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) {
    const std::uint8_t* rgb = image.pixels.data() + 3 * i;
    grey.pixels[i] = static_cast<std::uint8_t>((77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2]) >> 8);
  }
  return grey;
}

std::optional<DetectedBoard> find_corners(const Image& grey, const BoardSpec& spec,
                                          const BoardOptions& options) {
  const cv::Mat view = view_of(grey);
  const cv::Size pattern(spec.columns, spec.rows);
  Points corners;
  for (const double scale : scales_for(view)) {
    if (!find_scaled(view, pattern, scale, corners)) continue;
    if (auto board = finished(view, spec, corners, options)) return board;
  }
  constexpr int kFlags = cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY;
  if (!cv::findChessboardCornersSB(view, pattern, corners, kFlags, cv::noArray())) return {};
  auto board = finished(view, spec, corners, options);
  if (board) board->by_fallback = true;
  return board;
}

void mask_board(Image& grey, const DetectedBoard& board) {
  const auto outline = grid_outline(grid_homography(board.corners_px, board.spec), board.spec, 1.0);
  std::vector<cv::Point> polygon;
  for (const auto& p : outline) {
    polygon.emplace_back(static_cast<int>(std::lround(p.x())),
                         static_cast<int>(std::lround(p.y())));
  }
  cv::Mat view(grey.height_px, grey.width_px, CV_8UC1, grey.pixels.data());
  cv::Mat inside(view.size(), CV_8UC1, cv::Scalar(0));
  cv::fillConvexPoly(inside, polygon, cv::Scalar(255));
  // Half of the squares are light: what lies above the mean is.
  const double mean = cv::mean(view, inside)[0];
  const double light = cv::mean(view, inside & (view > mean))[0];
  view.setTo(cv::Scalar(light), inside);
}

std::optional<BoardSpec> board_seen_instead(const Image& grey, const BoardSpec& spec) {
  cv::Mat corners, meta;
  constexpr int kFlags = cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_LARGER;
  const cv::Size smallest(std::min(3, spec.columns), std::min(3, spec.rows));
  if (!cv::findChessboardCornersSB(view_of(grey), smallest, corners, kFlags, meta)) return {};
  if (meta.rows == spec.rows && meta.cols == spec.columns) return {};
  return BoardSpec{meta.rows, meta.cols, spec.square_m};
}

}  // namespace scanfuse::camera
