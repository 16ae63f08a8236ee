#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse {

/// Where an object really was. Optional columns of a truth file stay empty when absent.
struct TruthObject {
  std::int64_t id = 0;
  ObjectClass object_class = ObjectClass::kUnknown;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< centre of the box
  double z_m = 0;
  std::optional<double> heading_rad;
  std::optional<Eigen::Vector2d> velocity_m_per_s;  ///< over ground
  std::optional<double> length_m;
  std::optional<double> width_m;
  std::optional<double> height_m;
  std::optional<int> visible_points;
  std::optional<double> occluded;  ///< 0: free, larger: hidden (KITTI's code, or a share)
};

struct TruthFrame {
  Time stamp;
  std::int64_t frame = 0;
  std::string coordinate_frame = "world";  ///< "world" or "ego"
  std::vector<TruthObject> objects;
};

}  // namespace scanfuse
