#include "scanfuse/camera/stripe_signal.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::camera {

Signal::Signal(const Image& on, const Image* off, const Lattice& lattice, bool upright)
    : pitch_(lattice.pitch) {
  const std::ptrdiff_t pixel = on.channels, row = pixel * on.width_px;
  const std::ptrdiff_t first =
      lattice.first_row * row + lattice.first_column * pixel + lattice.channel;
  on_ = on.pixels.data() + first;
  if (off != nullptr) off_ = off->pixels.data() + first;
  const int columns = (on.width_px - lattice.first_column + pitch_ - 1) / pitch_;
  const int rows = (on.height_px - lattice.first_row + pitch_ - 1) / pitch_;
  along_step_ = pitch_ * (upright ? row : pixel);
  across_step_ = pitch_ * (upright ? pixel : row);
  along_ = upright ? rows : columns;
  across_ = upright ? columns : rows;
  first_along_ = upright ? lattice.first_row : lattice.first_column;
  first_across_ = upright ? lattice.first_column : lattice.first_row;
}

namespace {

struct Box {
  int left, top, right, bottom;  ///< right and bottom are not part of it
};

Box box_around(std::span<const Eigen::Vector2d> polygon, const Image& image) {
  Eigen::Vector2d low = polygon[0], high = polygon[0];
  for (const auto& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto bounded = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  // Even starts, so that blocks of a mosaic begin alike.
  return {bounded(std::floor(low.x()), image.width_px) & ~1,
          bounded(std::floor(low.y()), image.height_px) & ~1,
          bounded(std::ceil(high.x()) + 1, image.width_px),
          bounded(std::ceil(high.y()) + 1, image.height_px)};
}

/// Adds `times` one row of a lattice's pixels to the sums of the blocks that it crosses.
void add_row(const Image& image, int row, int channel, int left, int pitch, int block, int times,
             std::span<int> sums) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t step = channels * static_cast<std::size_t>(pitch);
  const std::uint8_t* pixel =
      image.pixels.data() +
      (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width_px) +
       static_cast<std::size_t>(left)) *
          channels +
      static_cast<std::size_t>(channel);
  for (int& sum : sums) {
    int part = 0;
    for (int k = 0; k < block; k += pitch, pixel += step) part += *pixel;
    sum += times * part;
  }
}

}  // namespace

CoarsePlane coarse_plane(const Image& on, const Image* off, const Lattice& lattice, int block,
                         std::span<const Eigen::Vector2d> polygon_px) {
  const int channel = lattice.channel, pitch = lattice.pitch;
  const Box box = box_around(polygon_px, on);
  CoarsePlane plane;
  plane.width = std::max(0, (box.right - box.left) / block);
  plane.height = std::max(0, (box.bottom - box.top) / block);
  plane.pitch_px = block;
  const int left = box.left + lattice.first_column, top = box.top + lattice.first_row;
  plane.origin_px = Eigen::Vector2d(left, top).array() + (block - pitch) / 2.0;
  plane.values.reserve(static_cast<std::size_t>(plane.width) *
                       static_cast<std::size_t>(plane.height));
  std::vector<int> sums(static_cast<std::size_t>(plane.width));
  const float share = 0.5F / static_cast<float>(block / pitch * (block / pitch));
  const bool against = off == nullptr && on.channels == 3;
  for (int r = 0; r < plane.height; ++r) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int k = 0; k < block; k += pitch) {
      const int row = top + r * block + k;
      add_row(on, row, channel, left, pitch, block, 2, sums);
      if (off != nullptr) add_row(*off, row, channel, left, pitch, block, -2, sums);
      for (int other = 0; against && other < 3; ++other) {
        if (other != channel) add_row(on, row, other, left, pitch, block, -1, sums);
      }
    }
    for (const int sum : sums) plane.values.push_back(share * static_cast<float>(sum));
  }
  return plane;
}

std::array<Lattice, 4> lattices_of_mosaic() {
  return {Lattice{0, 2, 0, 0}, Lattice{0, 2, 1, 0}, Lattice{0, 2, 0, 1}, Lattice{0, 2, 1, 1}};
}

bool shows_mosaic(const Image& image, std::span<const Eigen::Vector2d> polygon_px) {
  if (image.channels != 1) return false;
  constexpr int kSkip = 3;  // every so many pairs of rows will do
  constexpr double kApart = 1.08;
  const Box box = box_around(polygon_px, image);
  std::array<double, 4> sums{};
  for (int row = box.top; row + 1 < box.bottom; row += 2 * kSkip) {
    for (int column = box.left; column + 1 < box.right; column += 2) {
      for (int k = 0; k < 4; ++k) {
        sums[static_cast<std::size_t>(k)] += image.at(column + k % 2, row + k / 2, 0);
      }
    }
  }
  const auto [least, most] = std::ranges::minmax_element(sums);
  return *most > kApart * *least;
}

bool is_inside(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& p) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - a, to = p - a;
    const double side = edge.x() * to.y() - edge.y() * to.x();
    (side >= 0 ? left : right) = true;
  }
  return !(left && right);
}

}  // namespace scanfuse::camera
