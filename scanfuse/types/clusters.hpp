#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scanfuse {

/// Groups of points of one VirtualScan: indices into its `points`, ascending (so by bearing) within
/// each group. Points that stand in no group are noise. One flat array: no allocation per cluster.
struct Clusters {
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> ends;  ///< one past the last index of each cluster

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t k) const {
    const std::uint32_t begin = k == 0 ? 0 : ends[k - 1];
    return std::span(indices).subspan(begin, ends[k] - begin);
  }
  void clear() {
    indices.clear();
    ends.clear();
  }
  /// Makes one cluster of everything appended to `indices` since the last call.
  void close() { ends.push_back(static_cast<std::uint32_t>(indices.size())); }
};

}  // namespace scanfuse
