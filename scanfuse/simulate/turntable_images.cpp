#include "scanfuse/simulate/turntable_images.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/simulate/turntable_scene.hpp"

namespace scanfuse::simulate {

/// A grid of numbers as large as the image.
struct RenderField {
  int width = 0, height = 0;
  std::vector<float> values;

  RenderField(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Random streams: images of one seed draw from streams of their own.
constexpr std::uint64_t kBrightStream = 1;
constexpr std::uint64_t kStripeStream = 1000;
constexpr std::uint64_t kOffStream = 1'000'000;
constexpr double kStripeReach = 4.5;  ///< widths (sigma) of the stripe, beyond which it is dark

/// How strongly the pixels of a mosaic (red, green, blue) see white light and a red laser.
constexpr std::array<double, 3> kSeesWhite{0.8, 1.0, 0.7};
constexpr std::array<double, 3> kSeesLaser{1.0, 0.06, 0.02};

std::vector<float> blur_kernel(double sigma) {
  const int radius = static_cast<int>(std::ceil(3.5 * sigma));
  std::vector<float> kernel;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) sum += std::exp(-0.5 * i * i / (sigma * sigma));
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum));
  }
  return kernel;
}

/// Blurs a whole field; its edges are held.
void blur(RenderField& field, const std::vector<float>& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  RenderField between(field.width, field.height);
  for (int r = 0; r < field.height; ++r) {
    for (int c = 0; c < field.width; ++c) {
      float sum = 0;
      for (int k = -radius; k <= radius; ++k) {
        const int from = std::clamp(c + k, 0, field.width - 1);
        sum += kernel[static_cast<std::size_t>(k + radius)] * field.values[field.place(from, r)];
      }
      between.values[field.place(c, r)] = sum;
    }
  }
  std::fill(field.values.begin(), field.values.end(), 0.0F);
  for (int r = 0; r < field.height; ++r) {
    for (int k = -radius; k <= radius; ++k) {
      const int from = std::clamp(r + k, 0, field.height - 1);
      const float weight = kernel[static_cast<std::size_t>(k + radius)];
      const float* source = between.values.data() + field.place(0, from);
      float* to = field.values.data() + field.place(0, r);
      for (int c = 0; c < field.width; ++c) to[c] += weight * source[c];
    }
  }
}

/// Adds `value` of one pixel to the field as the lens spreads it.
void spread(RenderField& field, int column, int row, float value,
            const std::vector<float>& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  for (int k = std::max(-radius, -row); k <= std::min(radius, field.height - 1 - row); ++k) {
    const float part = value * kernel[static_cast<std::size_t>(k + radius)];
    for (int j = std::max(-radius, -column); j <= std::min(radius, field.width - 1 - column); ++j) {
      field.values[field.place(column + j, row + k)] +=
          part * kernel[static_cast<std::size_t>(j + radius)];
    }
  }
}

}  // namespace

Vector3d ray_of_pixel(const Camera& camera, const Vector2d& pixel) {
  Vector2d p((pixel.x() - camera.cx_px) / camera.fx_px, (pixel.y() - camera.cy_px) / camera.fy_px);
  const auto at = [&](const Vector2d& q) { return camera.project({q.x(), q.y(), 1.0}); };
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 5; ++i) {
    const Vector2d base = at(p), off = pixel - base;
    const Vector2d dx = (at(p + Vector2d(kStep, 0)) - base) / kStep;
    const Vector2d dy = (at(p + Vector2d(0, kStep)) - base) / kStep;
    const double det = dx.x() * dy.y() - dx.y() * dy.x();
    p += Vector2d(dy.y() * off.x() - dy.x() * off.y(), dx.x() * off.y() - dx.y() * off.x()) / det;
  }
  return Vector3d(p.x(), p.y(), 1).normalized();
}

struct TurntableRenderer::Impl {
  const TurntableWorld* world;
  TurntableImageOptions options;
  std::uint64_t seed;
  TurntableScene scene;
  std::vector<Vector3d> rays;        ///< of pixel centres
  std::vector<float> distance_m;     ///< along them; 0: nothing
  std::vector<std::int8_t> surface;  ///< what they meet
  RenderField light;                 ///< white light thrown back, blurred: 1 is white, undimmed
  std::vector<float> kernel;

  Impl(const TurntableWorld& w, const TurntableImageOptions& o, std::uint64_t s, int threads)
      : world(&w),
        options(o),
        seed(s),
        scene(w),
        rays(pixels()),
        distance_m(pixels()),
        surface(pixels()),
        light(w.camera.width_px, w.camera.height_px),
        kernel(blur_kernel(o.blur_px)) {
    parallel_for(static_cast<std::size_t>(light.height), threads,
                 [&](std::size_t row) { cast_row(static_cast<int>(row)); });
    blur(light, kernel);
  }

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(world->camera.width_px) *
           static_cast<std::size_t>(world->camera.height_px);
  }

  /// Half lengths, along a board's sides, of what one pixel covers (or a part of it).
  [[nodiscard]] Vector2d footprint(int id, double distance, double share) const {
    if (id > 1) return Vector2d::Zero();
    const Vector3d n = scene.normal(id);
    const Pose3& board = world->camera_from_board[static_cast<std::size_t>(id)];
    const double half = 0.5 * share * distance / world->camera.fx_px;
    // A board turned about an axis is seen shortened across that axis.
    const Vector3d x = board.rotation * Vector3d::UnitX(), y = board.rotation * Vector3d::UnitY();
    const double seen_x = std::max(0.1, std::sqrt(1 - x.z() * x.z()));
    const double seen_y = std::max(0.1, std::sqrt(1 - y.z() * y.z()));
    return std::abs(n.z()) > 0 ? Vector2d(half / seen_x, half / seen_y) : Vector2d(half, half);
  }

  void cast_row(int row) {
    for (int column = 0; column < light.width; ++column) {
      const std::size_t i = light.place(column, row);
      rays[i] = ray_of_pixel(world->camera, Vector2d(column, row));
      const auto hit = scene.cast(Vector3d::Zero(), rays[i]);
      surface[i] = static_cast<std::int8_t>(hit.surface);
      if (hit.surface < 0) continue;
      distance_m[i] = static_cast<float>(hit.distance_m);
      const double albedo = scene.albedo(hit.surface, hit.distance_m * rays[i],
                                         footprint(hit.surface, hit.distance_m, 1));
      const double dimming = 1 - options.gradient * column / light.width;
      const double facing = 0.6 + 0.4 * std::abs(scene.normal(hit.surface).dot(rays[i]));
      light.values[i] = static_cast<float>(albedo * dimming * facing / 0.85);
    }
  }

  /// Laser light on one pixel: the mean over four parts of it, before speckle and blur.
  [[nodiscard]] double laser_at(int column, int row, const Pose3& lidar,
                                const Vector3d& normal) const {
    const std::size_t i = light.place(column, row);
    const std::int8_t id = surface[i];
    const Vector3d n = scene.normal(id), at = static_cast<double>(distance_m[i]) * rays[i];
    const double plane = n.dot(at);
    const Vector2d half = footprint(id, distance_m[i], 0.5);
    // Rays within a pixel: straight steps towards its neighbours.
    const Vector3d& right = rays[light.place(std::min(column + 1, light.width - 1), row)];
    const Vector3d& below = rays[light.place(column, std::min(row + 1, light.height - 1))];
    double sum = 0;
    for (const double a : {-0.25, 0.25}) {
      for (const double b : {-0.25, 0.25}) {
        const Vector3d ray = rays[i] + a * (right - rays[i]) + b * (below - rays[i]);
        const Vector3d point = plane / n.dot(ray) * ray;
        const double range = (point - lidar.translation_m).norm();
        const double width = options.stripe_sigma_m + options.stripe_spread_rad * range;
        const double off = normal.dot(point - lidar.translation_m) / width;
        const double facing = std::abs(n.dot(point - lidar.translation_m)) / range;
        // Spread over its width and over a circle: falls with both.
        const double strength =
            (options.stripe_sigma_m + options.stripe_spread_rad) / (width * range);
        sum += scene.albedo(id, point, half) * facing * strength * std::exp(-0.5 * off * off);
      }
    }
    return options.laser_counts / 0.85 * sum / 4;
  }

  [[nodiscard]] RenderField laser(double turned_rad, RandomStream& random) const {
    RenderField field(light.width, light.height);
    const Pose3 lidar = world->rig.pose(turned_rad);
    const Vector3d normal = lidar.rotation * Vector3d::UnitZ();
    const double offset = normal.dot(lidar.translation_m);
    for (int row = 0; row < light.height; ++row) {
      for (int column = 0; column < light.width; ++column) {
        const std::size_t i = light.place(column, row);
        if (surface[i] < 0) continue;
        const double off = static_cast<double>(distance_m[i]) * normal.dot(rays[i]) - offset;
        if (std::abs(off) >
            kStripeReach * (options.stripe_sigma_m + 5 * options.stripe_spread_rad)) {
          continue;
        }
        const Vector3d at = static_cast<double>(distance_m[i]) * rays[i];
        if (!is_lit(lidar, at)) continue;
        const double grain = std::max(0.0, 1 + options.speckle * random.normal());
        spread(field, column, row, static_cast<float>(grain * laser_at(column, row, lidar, normal)),
               kernel);
      }
    }
    return field;
  }

  /// Within the lidar's field of view, and nothing in between.
  [[nodiscard]] bool is_lit(const Pose3& lidar, const Vector3d& at) const {
    const Vector3d p = lidar.inverse() * at;
    const double last = world->first_beam_rad + (world->beams - 1) * world->beam_step_rad;
    const double middle = (world->first_beam_rad + last) / 2;
    const double turned = std::remainder(std::atan2(p.y(), p.x()) - middle, 2 * kPi);
    return std::abs(turned) <= (last - world->first_beam_rad) / 2 &&
           scene.sees(lidar.translation_m, at);
  }

  /// Light into counts: colour filters, shot and read noise, rounding, clipping.
  [[nodiscard]] Image exposed(double white_counts, const RenderField* laser,
                              RandomStream& random) const {
    Image image{light.width, light.height, 1, {}};
    image.pixels.resize(light.values.size());
    const double read = options.read_noise_counts * options.read_noise_counts;
    for (int row = 0; row < light.height; ++row) {
      for (int column = 0; column < light.width; ++column) {
        const std::size_t i = light.place(column, row), colour = colour_at(column, row);
        const bool grey = options.sensor == Sensor::kGrey;
        double counts = white_counts * light.values[i] * (grey ? 1 : kSeesWhite[colour]);
        if (laser != nullptr) counts += laser->values[i] * (grey ? 1 : kSeesLaser[colour]);
        const double sigma = std::sqrt(read + counts / options.electrons_per_count);
        const double value = std::round(counts + sigma * random.normal());
        image.pixels[i] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
    return image;
  }
  static std::size_t colour_at(int column, int row) {
    return static_cast<std::size_t>((column & 1) + (row & 1));
  }
};

TurntableRenderer::TurntableRenderer(const TurntableWorld& world,
                                     const TurntableImageOptions& options, std::uint64_t seed,
                                     int threads)
    : impl_(std::make_unique<Impl>(world, options, seed, threads)) {}
TurntableRenderer::~TurntableRenderer() = default;
TurntableRenderer::TurntableRenderer(TurntableRenderer&&) noexcept = default;
TurntableRenderer& TurntableRenderer::operator=(TurntableRenderer&&) noexcept = default;

Image TurntableRenderer::bright() const {
  RandomStream random(impl_->seed, kBrightStream);
  return impl_->exposed(impl_->options.bright_counts, nullptr, random);
}

Image TurntableRenderer::stripe(std::size_t position, double turned_rad) const {
  RandomStream random(impl_->seed, kStripeStream + position);
  const RenderField laser = impl_->laser(turned_rad, random);
  return impl_->exposed(impl_->options.ambient_counts, &laser, random);
}

Image TurntableRenderer::laser_off(std::size_t position) const {
  RandomStream random(impl_->seed, kOffStream + position);
  return impl_->exposed(impl_->options.ambient_counts, nullptr, random);
}

SessionImages render_session_images(const TurntableWorld& world,
                                    const TurntableImageOptions& options, std::uint64_t seed,
                                    bool with_laser_off, const std::vector<double>& turned_rad,
                                    int threads) {
  const TurntableRenderer renderer(world, options, seed, threads);
  const auto& angles = turned_rad.empty() ? world.turntable_rad : turned_rad;
  SessionImages images;
  images.bright = renderer.bright();
  images.stripes.resize(angles.size());
  if (with_laser_off) images.laser_off.resize(angles.size());
  parallel_for(angles.size(), threads, [&](std::size_t i) {
    images.stripes[i] = renderer.stripe(i, angles[i]);
    if (with_laser_off) images.laser_off[i] = renderer.laser_off(i);
  });
  return images;
}

}  // namespace scanfuse::simulate
