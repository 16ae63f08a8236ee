#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/simulate/turntable_world.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::simulate {

/// What the camera hands out: grey, or the raw mosaic of a colour camera (red at the top left).
enum class Sensor { kGrey, kRggb };
constexpr auto choices(Sensor) {
  using enum Sensor;
  return std::array{std::pair{"grey", kGrey}, std::pair{"rggb", kRggb}};
}

struct TurntableImageOptions {
  Sensor sensor = Sensor::kGrey;
  double blur_px = 0.7;
  double bright_counts = 200;
  double ambient_counts = 6;
  double gradient = 0.3;
  double laser_counts = 160;
  double stripe_sigma_m = 0.0005;
  double stripe_spread_rad = 0.0004;
  double speckle = 0.15;
  double read_noise_counts = 1.2;
  double electrons_per_count = 40;

  static constexpr auto fields() {
    using O = TurntableImageOptions;
    return std::tuple{
        Field{"sensor", &O::sensor, "grey, or the raw mosaic of a colour camera"},
        Field{"blur_px", &O::blur_px, 0.3, 10.0, "standard deviation of the lens's blur"},
        Field{"bright_counts", &O::bright_counts, 1.0, 10000.0,
              "what white gives in the bright image"},
        Field{"ambient_counts", &O::ambient_counts, 0.0, 10000.0,
              "what white gives in the dark images, without the laser"},
        Field{"gradient", &O::gradient, 0.0, 1.0,
              "light lost from the left side of the image to the right, as a share"},
        Field{"laser_counts", &O::laser_counts, 0.0, 100000.0,
              "what the middle of the stripe gives on white, 1 m from the lidar; more than the "
              "camera's 255 saturates"},
        Field{"stripe_sigma_m", &O::stripe_sigma_m, 1e-5, 0.1,
              "of the stripe's width at the lidar"},
        Field{"stripe_spread_rad", &O::stripe_spread_rad, 0.0, 0.1,
              "how much that grows with distance"},
        Field{"speckle", &O::speckle, 0.0, 1.0, "contrast of the laser's speckle, per pixel"},
        Field{"read_noise_counts", &O::read_noise_counts, 0.0, 100.0, "of every pixel"},
        Field{"electrons_per_count", &O::electrons_per_count, 0.1, 10000.0, "sets the shot noise"}};
  }
};

/// Renders what the camera of a turntable world sees. Geometry is cast once; every image then costs
/// its noise and its stripe. Each image has a random stream of its own: any order, any number of
/// threads, the same images. `world` must outlive it.
class TurntableRenderer {
 public:
  TurntableRenderer(const TurntableWorld& world, const TurntableImageOptions& options,
                    std::uint64_t seed, int threads = 0);
  ~TurntableRenderer();
  TurntableRenderer(TurntableRenderer&&) noexcept;
  TurntableRenderer& operator=(TurntableRenderer&&) noexcept;

  /// Bright room, laser off.
  [[nodiscard]] Image bright() const;
  /// Dark room, the turntable at `turned_rad`, laser on.
  [[nodiscard]] Image stripe(std::size_t position, double turned_rad) const;
  /// The same with the laser off.
  [[nodiscard]] Image laser_off(std::size_t position) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct SessionImages {
  Image bright;
  std::vector<Image> stripes;    ///< one for each position
  std::vector<Image> laser_off;  ///< likewise, or none
};

/// All images of a world, for those who have the memory (2 MB each). `turned_rad`: true angles;
/// empty: as commanded.
[[nodiscard]] SessionImages render_session_images(const TurntableWorld& world,
                                                  const TurntableImageOptions& options,
                                                  std::uint64_t seed, bool with_laser_off = false,
                                                  const std::vector<double>& turned_rad = {},
                                                  int threads = 0);

/// The ray of an image point, camera frame, unit length: `Camera::project` undone by Newton's
/// method.
[[nodiscard]] Eigen::Vector3d ray_of_pixel(const Camera& camera, const Eigen::Vector2d& pixel);

}  // namespace scanfuse::simulate
