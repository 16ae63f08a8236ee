#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scanfuse/simulate/world.hpp"

namespace scanfuse::simulate {

struct Ray {
  Eigen::Vector3f origin_m;
  Eigen::Vector3f direction;  ///< of length 1
  float time = 0;             ///< 0 .. 1 within the interval given to `Caster::move_to`
};

struct Hit {
  float range_m = 0;        ///< 0: nothing hit
  float cosine = 0;         ///< between ray and surface normal, 0..1
  std::int32_t actor = -1;  ///< index into World::actors; -1: the fixed part of the world
  Surface surface;
};

/// The world inside Embree. Moving parts are instances whose transform runs linearly over the time
/// of one sweep, so that every ray meets them where they are when it is fired. One thread:
/// the same rays give the same hits.
class Caster {
 public:
  /// `world` must outlive the caster.
  explicit Caster(const World& world);
  ~Caster();
  Caster(Caster&&) noexcept;
  Caster& operator=(Caster&&) noexcept;

  void move_to(double from_s, double to_s);
  /// Hits beyond `max_range_m` do not count. As many hits as rays, in their order.
  [[nodiscard]] std::vector<Hit> cast(std::span<const Ray> rays, double max_range_m) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace scanfuse::simulate
