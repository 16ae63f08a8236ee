#include "scanfuse/camera/stripe.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scanfuse/camera/grid.hpp"
#include "scanfuse/camera/stripe_points.hpp"
#include "scanfuse/camera/stripe_search.hpp"

namespace scanfuse::camera {
namespace {

using Eigen::Vector2d;

constexpr int kCells = 160;  ///< of a coarse plane, along its longer side, roughly

int block_for(std::span<const Vector2d> polygon) {
  Vector2d low = polygon[0], high = polygon[0];
  for (const auto& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const int block = 2 * static_cast<int>((high - low).maxCoeff() / (2 * kCells));
  return std::clamp(block, 2, 4);
}

/// Where to look for the stripe: each channel, or each colour of a mosaic, since a laser of one
/// colour hardly shows in the mean of all.
std::vector<Lattice> lattices_to_search(const Image& image, std::span<const Vector2d> polygon,
                                        const StripeOptions& options) {
  if (image.channels == 1) {
    const bool raw = options.mosaic == Mosaic::kDetect ? shows_mosaic(image, polygon)
                                                       : options.mosaic != Mosaic::kNone;
    if (!raw) return {Lattice{}};
    const auto four = lattices_of_mosaic();
    return {four.begin(), four.end()};
  }
  switch (options.channel) {
    case LaserChannel::kRed:
      return {Lattice{0}};
    case LaserChannel::kGreen:
      return {Lattice{1}};
    case LaserChannel::kBlue:
      return {Lattice{2}};
    default:
      return {Lattice{0}, Lattice{1}, Lattice{2}};
  }
}

struct Found {
  RoughStripe stripe;
  int channel = 0;
};

/// The stripe in the channel, or colour of a mosaic, where it stands out most.
std::optional<Found> search(const Image& on, const Image* off, std::span<const Vector2d> polygon,
                            const StripeOptions& options) {
  std::optional<Found> best;
  for (const Lattice& lattice : lattices_to_search(on, polygon, options)) {
    const auto plane = coarse_plane(on, off, lattice, block_for(polygon), polygon);
    const auto stripe = search_stripe(plane, polygon);
    if (stripe && (!best || stripe->score > best->stripe.score)) best = {*stripe, lattice.channel};
  }
  return best;
}

Result<void> check(const Image& on, const Image* off) {
  const auto whole = [](const Image& image) {
    const auto pixels = static_cast<std::size_t>(std::max(image.width_px, 0)) *
                        static_cast<std::size_t>(std::max(image.height_px, 0));
    return pixels > 0 && (image.channels == 1 || image.channels == 3) &&
           image.pixels.size() == pixels * static_cast<std::size_t>(image.channels);
  };
  if (!whole(on) || (off != nullptr && !whole(*off))) {
    return fail(Error::Code::kMalformed, "an image without pixels");
  }
  if (off != nullptr && (off->width_px != on.width_px || off->height_px != on.height_px ||
                         off->channels != on.channels)) {
    return fail(Error::Code::kOutOfRange,
                "laser on {} x {} pixels, {} channels; laser off {} x {}, {}: they must be alike",
                on.width_px, on.height_px, on.channels, off->width_px, off->height_px,
                off->channels);
  }
  return {};
}

Stripe none(std::string reason) {
  Stripe stripe;
  stripe.reason = std::move(reason);
  return stripe;
}

Stripe stripe_in(const Image& on, const Image* off, const StripeRegion& region,
                 const StripeOptions& options) {
  const auto found = search(on, off, region.outline_px, options);
  if (!found) return none("no stripe stands out");
  return measure_stripe(on, off, region, found->stripe.curve, found->channel, options);
}

Result<StripeRegion> region_of(const Image& on, const DetectedBoard& board, std::size_t number,
                               const StripeOptions& options) {
  const auto corners = static_cast<std::size_t>(std::max(board.spec.rows, 0)) *
                       static_cast<std::size_t>(std::max(board.spec.columns, 0));
  if (board.spec.rows < 2 || board.spec.columns < 2 || board.corners_px.size() != corners) {
    return fail(Error::Code::kMalformed, "board {}: {} corners do not make {} x {}", number + 1,
                board.corners_px.size(), board.spec.rows, board.spec.columns);
  }
  for (const auto& p : board.corners_px) {
    if (!(p.x() > -1 && p.y() > -1 && p.x() < on.width_px && p.y() < on.height_px)) {
      return fail(Error::Code::kOutOfRange,
                  "board {}: corner ({:.1f}, {:.1f}) lies outside the image of {} x {} pixels: was "
                  "the board seen by another camera?",
                  number + 1, p.x(), p.y(), on.width_px, on.height_px);
    }
  }
  StripeRegion region;
  const Eigen::Matrix3d h = grid_homography(board.corners_px, board.spec);
  region.outline_px = grid_outline(h, board.spec, options.margin_squares);
  region.squares = SquareGrid{h.inverse(), board.spec, board.square_px};
  return region;
}

}  // namespace

std::vector<Vector2d> Stripe::positions() const {
  std::vector<Vector2d> out;
  out.reserve(points.size());
  for (const auto& point : points) out.push_back(point.position_px);
  return out;
}

Result<std::vector<Stripe>> find_stripes(const Image& on, const Image* off,
                                         std::span<const DetectedBoard> boards,
                                         const StripeOptions& options) {
  if (auto fine = check(on, off); !fine) return tl::unexpected(fine.error());
  std::vector<Stripe> stripes;
  for (std::size_t b = 0; b < boards.size(); ++b) {
    const auto region = region_of(on, boards[b], b, options);
    if (!region) return tl::unexpected(region.error());
    stripes.push_back(stripe_in(on, off, *region, options));
  }
  return stripes;
}

Result<Stripe> find_stripe(const Image& on, const Image* off, std::span<const Vector2d> polygon_px,
                           const StripeOptions& options) {
  if (auto fine = check(on, off); !fine) return tl::unexpected(fine.error());
  if (polygon_px.size() < 3)
    return fail(Error::Code::kMalformed, "a polygon of {} corners", polygon_px.size());
  for (const auto& p : polygon_px) {
    if (!p.allFinite())
      return fail(Error::Code::kMalformed, "a polygon with a corner that is no number");
  }
  StripeRegion region;
  region.outline_px.assign(polygon_px.begin(), polygon_px.end());
  return stripe_in(on, off, region, options);
}

}  // namespace scanfuse::camera
