#include "scanfuse/segment/gather.hpp"

namespace scanfuse::segment {

const Clusters& Gatherer::operator()(std::span<const std::uint32_t> labels, std::size_t label_count,
                                     int min_points) {
  constexpr std::uint32_t kUnplaced = 0xffffffffU;
  counts_.assign(label_count, 0);
  places_.assign(label_count, kUnplaced);
  for (const std::uint32_t label : labels) {
    if (label != kNoise) ++counts_[label];
  }
  clusters_.clear();
  std::uint32_t next = 0;
  const auto wanted = static_cast<std::uint32_t>(min_points);
  for (const std::uint32_t label : labels) {
    if (label == kNoise || counts_[label] < wanted || places_[label] != kUnplaced) continue;
    places_[label] = next;
    next += counts_[label];
    clusters_.ends.push_back(next);
  }
  clusters_.indices.resize(next);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    const std::uint32_t label = labels[i];
    if (label == kNoise || counts_[label] < wanted) continue;
    clusters_.indices[places_[label]++] = i;
  }
  return clusters_;
}

}  // namespace scanfuse::segment
