#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/types/image.hpp"

namespace scanfuse::camera {

/// Which samples of an image show the laser: one channel, every pixel or every second one of every
/// second row.
struct Lattice {
  int channel = 0;
  int pitch = 1;
  int first_column = 0;  ///< 0 or 1
  int first_row = 0;
};

/// One lattice of an image, laser on minus laser off where there is an off, as a grid of numbers.
/// Upright: `along` counts rows and `across` columns; else the other way round, so that a stripe
/// is always followed along the first index. The images must outlive it.
class Signal {
 public:
  Signal(const Image& on, const Image* off, const Lattice& lattice, bool upright);

  [[nodiscard]] int along() const { return along_; }  ///< how many samples
  [[nodiscard]] int across() const { return across_; }
  [[nodiscard]] int pitch() const { return pitch_; }
  [[nodiscard]] float at(int along, int across) const {
    const auto i = along * along_step_ + across * across_step_;
    return static_cast<float>(on_[i] - (off_ != nullptr ? off_[i] : 0));
  }
  [[nodiscard]] bool is_clipped(int along, int across) const {
    return on_[along * along_step_ + across * across_step_] >= kClipped;
  }
  /// Pixel coordinate of a sample, in units of pixels.
  [[nodiscard]] double along_px(double along) const { return first_along_ + pitch_ * along; }
  [[nodiscard]] double across_px(double across) const { return first_across_ + pitch_ * across; }
  [[nodiscard]] double along_index(double px) const { return (px - first_along_) / pitch_; }
  [[nodiscard]] double across_index(double px) const { return (px - first_across_) / pitch_; }

 private:
  static constexpr std::uint8_t kClipped = 250;
  const std::uint8_t* on_;
  const std::uint8_t* off_ = nullptr;
  std::ptrdiff_t along_step_, across_step_;
  int along_, across_, pitch_, first_along_, first_across_;
};

/// Means over square blocks of pixels. Cell (column, row) is centred on
/// `origin_px + pitch_px * (column, row)`.
struct CoarsePlane {
  int width = 0;
  int height = 0;
  double pitch_px = 1;
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();
  std::vector<float> values;

  [[nodiscard]] float at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

/// The part of an image around a polygon, in blocks of `block` x `block` pixels, an even number. Of
/// each block those pixels count that belong to the lattice.
[[nodiscard]] CoarsePlane coarse_plane(const Image& on, const Image* off, const Lattice& lattice,
                                       int block, std::span<const Eigen::Vector2d> polygon_px);

/// The four lattices of 2 x 2 pixels, row by row.
[[nodiscard]] std::array<Lattice, 4> lattices_of_mosaic();

/// Whether the four lattices of a one-channel image differ in brightness: a colour mosaic, whose
/// filters let light of different colours through.
[[nodiscard]] bool shows_mosaic(const Image& image, std::span<const Eigen::Vector2d> polygon_px);

/// Whether a point lies inside a convex polygon, whichever way round that is given.
[[nodiscard]] bool is_inside(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& p);

}  // namespace scanfuse::camera
