#include "scanfuse/evaluate/by_range.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::evaluate {
namespace {

constexpr std::size_t kMostRings = 100;

struct Ring {
  std::int64_t objects = 0, tracks = 0, found = 0, right = 0;
};

class Rings {
 public:
  explicit Rings(double ring_m) : ring_m_(ring_m) {}
  Ring& at(ObjectClass name, const Eigen::Vector2d& place_m, const Eigen::Vector2d& viewer_m) {
    const double rings = std::floor((place_m - viewer_m).norm() / ring_m_);
    const auto ring = rings < kMostRings ? static_cast<std::size_t>(rings) : kMostRings - 1;
    auto& all = by_class_[name];
    if (all.size() <= ring) all.resize(ring + 1);
    return all[ring];
  }
  [[nodiscard]] std::map<ObjectClass, std::vector<RangeMetrics>> metrics() const {
    std::map<ObjectClass, std::vector<RangeMetrics>> result;
    for (const auto& [name, rings] : by_class_) {
      for (std::size_t k = 0; k < rings.size(); ++k) {
        const Ring& r = rings[k];
        result[name].push_back({static_cast<double>(k) * ring_m_,
                                static_cast<double>(k + 1) * ring_m_, r.objects, r.tracks,
                                share(r.right, r.tracks), share(r.found, r.objects)});
      }
    }
    return result;
  }

 private:
  static std::optional<double> share(std::int64_t part, std::int64_t whole) {
    if (whole == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(whole);
  }
  double ring_m_;
  std::map<ObjectClass, std::vector<Ring>> by_class_;
};

}  // namespace

std::map<ObjectClass, std::vector<RangeMetrics>> metrics_by_range(
    const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches, double ring_m) {
  Rings rings(ring_m);
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const ScoredFrame& frame = sequence.frames[k];
    const auto ring_of_truth = [&](const TruthObject& o) -> Ring& {
      return rings.at(o.object_class, o.position_m, frame.viewer_m);
    };
    const auto ring_of_track = [&](const Track& t) -> Ring& {
      return rings.at(t.object_class, t.box.centre_m, frame.viewer_m);
    };
    for (const auto& object : frame.truth) ring_of_truth(object).objects += 1;
    for (const auto& track : frame.tracks) ring_of_track(track).tracks += 1;
    for (const auto& pair : matches[k]) {
      const TruthObject& object = frame.truth[static_cast<std::size_t>(pair.truth)];
      const Track& track = frame.tracks[static_cast<std::size_t>(pair.track)];
      if (object.object_class != track.object_class) continue;
      ring_of_truth(object).found += 1;
      ring_of_track(track).right += 1;
    }
  }
  return rings.metrics();
}

}  // namespace scanfuse::evaluate
