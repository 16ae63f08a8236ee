#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/camera/boards.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::camera {

/// Which channel shows the laser. kDetect: the one that it lights most.
enum class LaserChannel { kDetect, kRed, kGreen, kBlue, kGrey };
constexpr auto choices(LaserChannel) {
  using enum LaserChannel;
  return std::array{std::pair{"detect", kDetect}, std::pair{"red", kRed},
                    std::pair{"green", kGreen}, std::pair{"blue", kBlue}, std::pair{"grey", kGrey}};
}

/// Colours of the 2 x 2 pixels at the top left of a raw one-channel image of a Bayer camera, row by
/// row. kDetect: where the laser lights pixels of one parity of rows and columns only, those are
/// used; kNone: every pixel counts.
enum class Mosaic { kDetect, kNone, kRggb, kGrbg, kGbrg, kBggr };
constexpr auto choices(Mosaic) {
  using enum Mosaic;
  return std::array{std::pair{"detect", kDetect}, std::pair{"none", kNone},
                    std::pair{"rggb", kRggb},     std::pair{"grbg", kGrbg},
                    std::pair{"gbrg", kGbrg},     std::pair{"bggr", kBggr}};
}

struct StripeOptions {
  LaserChannel channel = LaserChannel::kDetect;
  Mosaic mosaic = Mosaic::kDetect;
  double margin_squares = 1;
  double border_widths = 2.5;
  double piece_widths = 1.5;
  double min_contrast = 8;
  double min_squares = 2;
  double max_scatter_px = 0.6;

  static constexpr auto fields() {
    using O = StripeOptions;
    return std::tuple{
        Field{"channel", &O::channel, "channel that shows the laser"},
        Field{"mosaic", &O::mosaic, "colour mosaic of raw one-channel images"},
        Field{"margin_squares", &O::margin_squares, 0.0, 20.0,
              "how far the flat plate reaches beyond the inner corners, in squares"},
        Field{"border_widths", &O::border_widths, 0.0, 10.0,
              "points nearer to a square's border than this many widths (sigma) of the smoothed "
              "stripe are left out, but none further from it than a quarter of a square's side"},
        Field{"piece_widths", &O::piece_widths, 0.1, 100.0,
              "each point is a mean over this many widths (sigma) of the smoothed stripe"},
        Field{"min_contrast", &O::min_contrast, 1.0, 255.0,
              "a stripe stands out from its surroundings by at least this many counts"},
        Field{"min_squares", &O::min_squares, 0.5, 100.0,
              "a stripe shorter than this many squares is not used"},
        Field{"max_scatter_px", &O::max_scatter_px, 0.01, 100.0,
              "nor one whose points scatter more about a smooth curve"},
    };
  }
};

/// A point on the centre line of a stripe.
struct StripePoint {
  Eigen::Vector2d position_px;  ///< raw image (distorted) pixels
  double sigma_px = 0;          ///< across the stripe, from the scatter about the smooth curve
  double contrast = 0;          ///< height above the surroundings, counts
};

/// One stripe on one board; no points where none was found, `reason` then says why.
struct Stripe {
  std::vector<StripePoint> points;  ///< in order along the stripe
  double width_px = 0;              ///< sigma of its cross-section
  double scatter_px = 0;            ///< rms distance of the points from the smooth curve
  double saturated_share = 0;       ///< of the points whose peak the camera clipped
  LaserChannel channel = LaserChannel::kGrey;
  Mosaic mosaic = Mosaic::kNone;
  std::string reason;

  [[nodiscard]] bool found() const { return !points.empty(); }
  [[nodiscard]] std::vector<Eigen::Vector2d> positions() const;
};

/// Finds the laser's stripe on each board: sub-pixel ridge points [Steger1998], one curve through
/// them by a robust fit of a parabola (distortion bends a straight stripe by no more), points near
/// the borders of squares left out. Board k of `boards` gives stripe k.
///
/// `off` may be null; else it is the same view with the laser off, which is subtracted.
/// Errors: images of different size, a board outside the image.
[[nodiscard]] Result<std::vector<Stripe>> find_stripes(const Image& on, const Image* off,
                                                       std::span<const DetectedBoard> boards,
                                                       const StripeOptions& options = {});

/// The same inside any convex polygon, where no borders of squares are known.
[[nodiscard]] Result<Stripe> find_stripe(const Image& on, const Image* off,
                                         std::span<const Eigen::Vector2d> polygon_px,
                                         const StripeOptions& options = {});

}  // namespace scanfuse::camera
