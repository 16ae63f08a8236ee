#include "scanfuse/camera/boards.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "scanfuse/camera/find_corners.hpp"
#include "scanfuse/camera/grid.hpp"

namespace scanfuse::camera {
namespace {

Result<void> check(const Image& image, const BoardSpec& spec) {
  if (image.width_px < 16 || image.height_px < 16) {
    return fail(Error::Code::kOutOfRange,
                "an image of {} x {} pixels is too small for a chessboard", image.width_px,
                image.height_px);
  }
  if (spec.rows < 2 || spec.columns < 2 || spec.rows > 200 || spec.columns > 200) {
    return fail(Error::Code::kOutOfRange,
                "a chessboard of {} x {} inner corners: rows and columns must be 2 to 200",
                spec.rows, spec.columns);
  }
  if (spec.rows == 2 && spec.columns == 2) {
    return fail(Error::Code::kOutOfRange, "2 x 2 inner corners are too few to tell a chessboard");
  }
  return {};
}

tl::unexpected<Error> not_found(const Image& grey, const BoardSpec& spec, const char* which) {
  std::string seen;
  if (const auto other = board_seen_instead(grey, spec)) {
    seen = fmt::format(
        "; one of about {} x {} is there: are rows and columns counted by inner corners?",
        other->rows, other->columns);
  }
  return fail(Error::Code::kNotFound,
              "no {}chessboard of {} x {} inner corners (rows x columns) found whole{}", which,
              spec.rows, spec.columns, seen);
}

Eigen::Vector2d centre(const DetectedBoard& board) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& corner : board.corners_px) sum += corner;
  return sum / static_cast<double>(board.corners_px.size());
}

bool alike(const BoardSpec& a, const BoardSpec& b) {
  return (a.rows == b.rows && a.columns == b.columns) ||
         (a.rows == b.columns && a.columns == b.rows);
}

/// Boards alike but for what is called a row: counts the corners as `spec` does.
void count_as(const BoardSpec& spec, DetectedBoard& board) {
  if (board.spec.rows != spec.rows) {
    board.corners_px = in_order(transposed(board.corners_px, board.spec), spec);
  }
  board.spec = spec;
}

/// Whether `b` comes before `a`: left of it where they lie side by side, else above it.
bool comes_before(const DetectedBoard& b, const DetectedBoard& a) {
  const Eigen::Vector2d d = centre(b) - centre(a);
  return std::abs(d.x()) >= std::abs(d.y()) ? d.x() < 0 : d.y() < 0;
}

}  // namespace

Result<DetectedBoard> find_board(const Image& image, const BoardSpec& spec,
                                 const BoardOptions& options) {
  if (auto fine = check(image, spec); !fine) return tl::unexpected(fine.error());
  const Image grey = board_grey(image);
  if (auto board = find_corners(grey, spec, options)) return *std::move(board);
  return not_found(grey, spec, "");
}

Result<std::array<DetectedBoard, 2>> find_two_boards(const Image& image,
                                                     const std::array<BoardSpec, 2>& specs,
                                                     const BoardOptions& options) {
  for (const auto& spec : specs) {
    if (auto fine = check(image, spec); !fine) return tl::unexpected(fine.error());
  }
  Image grey = board_grey(image);
  // A small pattern would also be found within a large board, so the large one comes first.
  const bool swapped = specs[1].rows * specs[1].columns > specs[0].rows * specs[0].columns;
  const BoardSpec& large = specs[swapped ? 1 : 0];
  const BoardSpec& small = specs[swapped ? 0 : 1];
  auto first = find_corners(grey, large, options);
  if (!first) return not_found(grey, large, "");
  mask_board(grey, *first);
  auto second = find_corners(grey, small, options);
  if (!second) return not_found(grey, small, "second ");
  std::array<DetectedBoard, 2> boards{*std::move(first), *std::move(second)};
  const bool order_by_place = alike(specs[0], specs[1]);
  if (order_by_place ? comes_before(boards[1], boards[0]) : swapped) {
    std::swap(boards[0], boards[1]);
  }
  for (std::size_t k = 0; k < 2; ++k) count_as(specs[k], boards[k]);
  return boards;
}

}  // namespace scanfuse::camera
