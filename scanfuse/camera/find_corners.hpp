#pragma once

#include <optional>

#include "scanfuse/camera/boards.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::camera {

/// One channel for finding boards: colours weighed as the eye does; a raw Bayer mosaic, told by the
/// four kinds of pixels having different means, smoothed by 1 2 1 both ways (every output then
/// holds every colour with the same weight, and nothing moves).
[[nodiscard]] Image board_grey(const Image& image);

/// The board in a one-channel image, or nothing. Built on OpenCV.
[[nodiscard]] std::optional<DetectedBoard> find_corners(const Image& grey, const BoardSpec& spec,
                                                        const BoardOptions& options);

/// Paints over a board and its outermost squares in the tone of its light squares.
void mask_board(Image& grey, const DetectedBoard& board);

/// Rows and columns of a board that is there but is not `spec`, as far as can be seen.
[[nodiscard]] std::optional<BoardSpec> board_seen_instead(const Image& grey, const BoardSpec& spec);

}  // namespace scanfuse::camera
