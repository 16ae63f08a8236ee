#include "scanfuse/segment/score.hpp"

#include <map>
#include <utility>

namespace scanfuse::segment {

std::vector<ObjectScore> score_clusters(const Clusters& clusters,
                                        std::span<const std::int32_t> objects, int min_points) {
  std::map<std::int32_t, int> totals;
  for (const std::int32_t object : objects) {
    if (object >= 0) ++totals[object];
  }
  std::map<std::pair<std::int32_t, std::size_t>, int> shared;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (const std::uint32_t i : clusters[k]) {
      if (i < objects.size() && objects[i] >= 0) ++shared[{objects[i], k}];
    }
  }
  std::map<std::int32_t, ObjectScore> best;
  for (const auto& [object, points] : totals) {
    if (points >= min_points) best[object] = {object, points};
  }
  for (const auto& [key, both] : shared) {
    const auto found = best.find(key.first);
    if (found == best.end()) continue;
    ObjectScore& score = found->second;
    const auto size = static_cast<int>(clusters[key.second].size());
    const double iou = static_cast<double>(both) / (size + score.points - both);
    if (iou <= score.iou) continue;
    score = {score.object,
             score.points,
             static_cast<double>(both) / score.points,
             static_cast<double>(both) / size,
             iou,
             2 * both < size};
  }
  std::vector<ObjectScore> scores;
  scores.reserve(best.size());
  for (const auto& [object, score] : best) scores.push_back(score);
  return scores;
}

}  // namespace scanfuse::segment
