#include "scanfuse/pipeline/perception.hpp"

#include <gtest/gtest.h>

#include <set>

#include "preprocess/room_scene.hpp"
#include "scanfuse/pipeline/config.hpp"

namespace scanfuse::pipeline {
namespace {

/// A car ahead of the sensor.
PosedScan car_seen(const std::string& frame_id, double seconds, bool mount_is_known,
                   RandomStream& random) {
  PosedScan posed;
  posed.scan.stamp = time_from_seconds(1000 + seconds);
  posed.scan.sensor = frame_id;
  posed.scan.frame_id = frame_id;
  posed.mount_is_known = mount_is_known;
  const auto car = preprocess::box_walls({5, 0.5}, {9.4, 2.3});
  for (const PlanarPoint& p : preprocess::look(car, {}, seconds, random).points) {
    posed.scan.returns.push_back({p.x_m, p.y_m});
  }
  return posed;
}

std::set<std::int64_t> tracks_of(bool mounts_are_known, Diagnostics& diagnostics) {
  Perception perception(*preset("vehicle-pag"));
  RandomStream random(1);
  std::set<std::int64_t> ids;
  for (int k = 0; k < 10; ++k) {
    const auto& result = perception.step(
        car_seen(k % 2 == 0 ? "left" : "right", 0.05 * k, mounts_are_known, random));
    EXPECT_EQ(result.tracks.size(), 1U);
    for (const Track& track : result.tracks) ids.insert(track.id);
  }
  diagnostics = perception.diagnostics();
  return ids;
}

TEST(Perception, SensorsOfUnknownPlaceAreTrackedEachForItself) {
  constexpr auto kNote = "sensor tracked for itself: where it is on the ego is not known";
  Diagnostics diagnostics;
  EXPECT_EQ(tracks_of(false, diagnostics).size(), 2U) << "one of each sensor, told apart";
  EXPECT_EQ(diagnostics.count(kNote), 1);
  EXPECT_EQ(tracks_of(true, diagnostics).size(), 1U) << "in one frame it is one car";
  EXPECT_EQ(diagnostics.count(kNote), 0);
}

}  // namespace
}  // namespace scanfuse::pipeline
