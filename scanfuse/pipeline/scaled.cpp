#include "scanfuse/pipeline/scaled.hpp"

namespace scanfuse::pipeline {
namespace {

Box2 scaled_box(Box2 box, double factor) {
  box.centre_m *= factor;
  box.length_m *= factor;
  box.width_m *= factor;
  return box;
}

}  // namespace

PosedScan scaled(PosedScan posed, double factor) {
  const auto narrow = static_cast<float>(factor);
  for (Return& r : posed.scan.returns) {
    r.x_m *= narrow;
    r.y_m *= narrow;
    r.z_m *= narrow;
  }
  if (posed.scan.beams) {
    posed.scan.beams->min_range_m *= factor;
    posed.scan.beams->max_range_m *= factor;
  }
  posed.world_from_ego.translation_m *= factor;
  posed.ego_from_sensor.translation_m *= factor;
  posed.twist.speed_m_per_s *= factor;
  posed.twist.lateral_m_per_s *= factor;
  return posed;
}

Detection scaled(Detection detection, double factor) {
  detection.box = scaled_box(detection.box, factor);
  detection.z_m *= factor;
  detection.height_m *= factor;
  detection.covariance.topRows<2>() *= factor;
  detection.covariance.leftCols<2>() *= factor;
  detection.var_length_m2 *= factor * factor;
  detection.var_width_m2 *= factor * factor;
  detection.seen_from_m *= factor;
  detection.visible_middle_m *= factor;
  return detection;
}

Track scaled(Track track, double factor) {
  track.box = scaled_box(track.box, factor);
  track.z_m *= factor;
  track.height_m *= factor;
  track.state.mean *= factor;
  track.state.covariance *= factor * factor;
  track.speed_m_per_s *= factor;
  track.accel_m_per_s2 *= factor;
  return track;
}

VirtualScan scaled(VirtualScan scan, double factor) {
  const auto narrow = static_cast<float>(factor);
  for (PlanarPoint& p : scan.points) {
    p.x_m *= narrow;
    p.y_m *= narrow;
    p.z_m *= narrow;
    p.range_m *= narrow;
    p.z_low_m *= narrow;
    p.z_high_m *= narrow;
    p.depth_m *= narrow;
  }
  scan.sigma_range_m *= factor;
  return scan;
}

}  // namespace scanfuse::pipeline
