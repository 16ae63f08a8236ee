#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/object_class.hpp"

/// One line of the text files that hold KITTI's 3D boxes.
namespace scanfuse::io {

/// How such a line is laid out.
enum class KittiLayout {
  kNone,
  kTracking,  ///< `frame track type truncated occluded alpha left top right bottom height width
              ///< length x y z rotation_y [score]` [Geiger2013]
  kObject,    ///< the same from `type` on: the frame is the file's name [Geiger2013]
  kTable,     ///< `frame,type,left,top,right,bottom,score,height,width,length,x,y,z,rotation_y,
              ///< alpha` with type 1 pedestrian, 2 car, 3 cyclist [Weng2020]
};

/// What a first line says; kNone for anything else.
[[nodiscard]] KittiLayout kitti_layout(std::string_view line);

/// A box in the laser's frame, at its centre.
struct KittiBox {
  ObjectClass object_class = ObjectClass::kOther;
  bool dont_care = false;  ///< a region that nobody labelled: the rest means nothing
  std::int64_t track = -1;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double heading_rad = 0;
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  double occluded = 0;
  std::optional<double> score;
};

struct KittiLine {
  std::int64_t frame = 0;       ///< 0 in layout kObject
  std::optional<KittiBox> box;  ///< nothing where a number does not fit
};

/// Nothing where the line has too few words or no frame number.
[[nodiscard]] std::optional<KittiLine> parse_kitti_line(std::string_view line, KittiLayout layout,
                                                        const Pose3& laser_from_camera);

/// What stands between blanks.
[[nodiscard]] std::vector<std::string_view> kitti_words(std::string_view line);

}  // namespace scanfuse::io
