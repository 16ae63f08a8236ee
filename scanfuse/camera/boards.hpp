#pragma once

#include <Eigen/Core>
#include <array>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/image.hpp"
#include "scanfuse/types/turntable.hpp"

namespace scanfuse::camera {

/// A chessboard that was found in an image.
///
/// Corner order, the same rule for every image: row-major as BoardSpec says; x cross y points away
/// from the camera (in the image x turns clockwise into y); of the orders that remain, the one
/// whose x points right if x is more level than upright in the image, else down. Where rows and
/// columns are equal, x is the more level side.
struct DetectedBoard {
  BoardSpec spec;
  std::vector<Eigen::Vector2d> corners_px;  ///< rows * columns, raw image (distorted) pixels
  /// Standard deviation of one corner coordinate, from third differences along rows and columns
  /// (perspective and distortion leave nothing of weight in them). NaN on boards under 4 x 4.
  double sigma_px = 0;
  double square_px = 0;  ///< shortest distance of neighbours
  bool by_fallback =
      false;  ///< found by the sector-based detector, which was less exact on real images
};

struct BoardOptions {
  double half_window = 0.35;

  static constexpr auto fields() {
    using O = BoardOptions;
    return std::tuple{
        Field{"half_window", &O::half_window, 0.1, 0.6,
              "half window of the sub-pixel corner search, as a share of the square in the image"},
    };
  }
};

/// Finds one chessboard. kNotFound where it is not there whole, naming what was looked for and, if
/// it can be seen, how many corners the board in the image has.
[[nodiscard]] Result<DetectedBoard> find_board(const Image& image, const BoardSpec& spec,
                                               const BoardOptions& options = {});

/// Finds both boards of a V in one image: one is found and masked, then the other.
///
/// Which is which: boards of different size go by their size. Of two alike, the first is the left
/// one where their centres lie further apart in u than in v, else the upper one.
[[nodiscard]] Result<std::array<DetectedBoard, 2>> find_two_boards(
    const Image& image, const std::array<BoardSpec, 2>& specs, const BoardOptions& options = {});

}  // namespace scanfuse::camera
