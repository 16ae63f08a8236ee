#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/types/clusters.hpp"

namespace scanfuse::segment {

/// How well one labelled object was cut out.
struct ObjectScore {
  std::int32_t object = 0;
  int points = 0;           ///< of the object in the scan
  double completeness = 0;  ///< share of the object's points in its best cluster
  double purity = 0;        ///< share of that cluster's points that are the object's
  double iou = 0;           ///< points in both over points in either
  bool merged = false;      ///< its best cluster holds more points of others than of it

  [[nodiscard]] bool right() const { return completeness > 0.8 && purity > 0.8; }
  [[nodiscard]] bool right_by_iou() const { return iou >= 0.7; }
};

/// Scores every object with at least `min_points` points, by object number. `objects[i]` is the
/// number of the object that point i lies on, negative for none. The best cluster of an object is
/// the one with the highest IoU, the first of equals.
[[nodiscard]] std::vector<ObjectScore> score_clusters(const Clusters& clusters,
                                                      std::span<const std::int32_t> objects,
                                                      int min_points = 3);

}  // namespace scanfuse::segment
