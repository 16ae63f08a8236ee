#include <algorithm>
#include <tuple>

#include "scanfuse/associate/associate.hpp"

namespace scanfuse::associate {

Assignment assign_nearest(int tracks, int detections, std::span<const Candidate> candidates,
                          double unassigned_cost) {
  return Associator()(Method::kNearest, tracks, detections, candidates, unassigned_cost);
}

Assignment assign_detection_greedy(int tracks, int detections,
                                   std::span<const Candidate> candidates, double unassigned_cost) {
  return Associator()(Method::kDetectionGreedy, tracks, detections, candidates, unassigned_cost);
}

Assignment associate(Method method, int tracks, int detections,
                     std::span<const Candidate> candidates, double unassigned_cost) {
  return Associator()(method, tracks, detections, candidates, unassigned_cost);
}

const Assignment& Associator::operator()(Method method, int tracks, int detections,
                                         std::span<const Candidate> candidates,
                                         double unassigned_cost) {
  assignment_.detection_of_track.assign(tracks, -1);
  assignment_.track_of_detection.assign(detections, -1);
  switch (method) {
    case Method::kGlobal:
      global(candidates, unassigned_cost);
      break;
    case Method::kNearest:
      nearest(candidates, unassigned_cost);
      break;
    case Method::kDetectionGreedy:
      detection_greedy(candidates, unassigned_cost);
      break;
    case Method::kJpda:
      jpda(tracks, detections, candidates, unassigned_cost);
      break;
  }
  return assignment_;
}

void Associator::nearest(std::span<const Candidate> candidates, double unassigned_cost) {
  sorted_.assign(candidates.begin(), candidates.end());
  std::sort(sorted_.begin(), sorted_.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.track, a.detection) < std::tie(b.cost, b.track, b.detection);
  });
  for (const Candidate& c : sorted_) {
    if (c.cost >= unassigned_cost) break;
    if (assignment_.detection_of_track[c.track] >= 0) continue;
    if (assignment_.track_of_detection[c.detection] >= 0) continue;
    pair(c.track, c.detection);
  }
}

void Associator::detection_greedy(std::span<const Candidate> candidates, double unassigned_cost) {
  sorted_.assign(candidates.begin(), candidates.end());
  std::sort(sorted_.begin(), sorted_.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.detection, a.cost, a.track) < std::tie(b.detection, b.cost, b.track);
  });
  for (const Candidate& c : sorted_) {
    if (c.cost >= unassigned_cost) continue;
    if (assignment_.track_of_detection[c.detection] >= 0) continue;
    if (assignment_.detection_of_track[c.track] >= 0) continue;
    pair(c.track, c.detection);
  }
}

void Associator::pair(int track, int detection) {
  assignment_.detection_of_track[track] = detection;
  assignment_.track_of_detection[detection] = track;
}

}  // namespace scanfuse::associate
