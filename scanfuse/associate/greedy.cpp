#include <algorithm>
#include <limits>
#include <tuple>

#include "scanfuse/associate/associate.hpp"

namespace scanfuse::associate {
namespace {

Assignment nobody(int tracks, int detections) {
  return {std::vector<int>(tracks, -1), std::vector<int>(detections, -1)};
}

void join(Assignment& assignment, int track, int detection) {
  assignment.detection_of_track[track] = detection;
  assignment.track_of_detection[detection] = track;
}

}  // namespace

Assignment assign_nearest(int tracks, int detections, std::span<const Candidate> candidates,
                          double unassigned_cost) {
  std::vector<Candidate> sorted(candidates.begin(), candidates.end());
  std::sort(sorted.begin(), sorted.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.track, a.detection) < std::tie(b.cost, b.track, b.detection);
  });
  Assignment assignment = nobody(tracks, detections);
  for (const Candidate& pair : sorted) {
    if (pair.cost >= unassigned_cost) break;
    if (assignment.detection_of_track[pair.track] >= 0) continue;
    if (assignment.track_of_detection[pair.detection] >= 0) continue;
    join(assignment, pair.track, pair.detection);
  }
  return assignment;
}

Assignment assign_detection_greedy(int tracks, int detections,
                                   std::span<const Candidate> candidates, double unassigned_cost) {
  std::vector<Candidate> sorted(candidates.begin(), candidates.end());
  std::sort(sorted.begin(), sorted.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.detection, a.cost, a.track) < std::tie(b.detection, b.cost, b.track);
  });
  Assignment assignment = nobody(tracks, detections);
  for (const Candidate& pair : sorted) {
    if (pair.cost >= unassigned_cost) continue;
    if (assignment.track_of_detection[pair.detection] >= 0) continue;
    if (assignment.detection_of_track[pair.track] >= 0) continue;
    join(assignment, pair.track, pair.detection);
  }
  return assignment;
}

Assignment associate(Method method, int tracks, int detections,
                     std::span<const Candidate> candidates, double unassigned_cost) {
  switch (method) {
    case Method::kNearest:
      return assign_nearest(tracks, detections, candidates, unassigned_cost);
    case Method::kDetectionGreedy:
      return assign_detection_greedy(tracks, detections, candidates, unassigned_cost);
    case Method::kGlobal:
      break;
  }
  return assign_global(tracks, detections, candidates, unassigned_cost);
}

}  // namespace scanfuse::associate
