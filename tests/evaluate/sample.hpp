#pragma once

#include <vector>

#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::evaluate::sample {

inline Track track(std::int64_t id, double x, double y) {
  Track t;
  t.id = id;
  t.object_class = ObjectClass::kVehicle;
  t.status = TrackStatus::kConfirmed;
  t.box = {{x, y}, 0, 4, 2};
  t.state.mean << x, 0, y, 0;
  return t;
}

inline TruthObject object(std::int64_t id, double x, double y) {
  TruthObject o;
  o.id = id;
  o.object_class = ObjectClass::kVehicle;
  o.position_m = {x, y};
  return o;
}

inline StepResult step(std::int64_t frame, std::vector<Track> tracks) {
  StepResult s;
  s.frame = frame;
  s.stamp = time_from_seconds(0.1 * static_cast<double>(frame));
  s.tracks = std::move(tracks);
  return s;
}

inline TruthFrame truth(std::int64_t frame, std::vector<TruthObject> objects) {
  TruthFrame t;
  t.frame = frame;
  t.stamp = time_from_seconds(0.1 * static_cast<double>(frame));
  t.objects = std::move(objects);
  return t;
}

}  // namespace scanfuse::evaluate::sample
