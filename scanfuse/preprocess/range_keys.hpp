#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace scanfuse::preprocess {

/// A point's range and index as one number: its order is by range, then by index, because ranges
/// are positive, and the bits of positive floats are in order.
class RangeKey {
 public:
  RangeKey() = default;
  RangeKey(float range_m, std::uint32_t index)
      : bits_(std::uint64_t{std::bit_cast<std::uint32_t>(range_m)} << 32 | index) {}

  [[nodiscard]] float range_m() const {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits_ >> 32));
  }
  [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(bits_); }
  [[nodiscard]] auto operator<=>(const RangeKey&) const = default;

  /// Without a jump, for a processor cannot guess the outcome.
  friend void put_in_order(RangeKey& a, RangeKey& b) {
    const std::uint64_t first = a.bits_, second = b.bits_;
    a.bits_ = first < second ? first : second;
    b.bits_ = first < second ? second : first;
  }

 private:
  std::uint64_t bits_ = ~std::uint64_t{0};  ///< behind all others
};

inline void sort_network(std::array<RangeKey, 4>& k) {
  put_in_order(k[0], k[1]);
  put_in_order(k[2], k[3]);
  put_in_order(k[0], k[2]);
  put_in_order(k[1], k[3]);
  put_in_order(k[1], k[2]);
}

/// Batcher's: two sorted halves, merged.
inline void sort_network(std::array<RangeKey, 8>& k) {
  for (const std::size_t h : {0, 4}) {
    put_in_order(k[h], k[h + 1]);
    put_in_order(k[h + 2], k[h + 3]);
    put_in_order(k[h], k[h + 2]);
    put_in_order(k[h + 1], k[h + 3]);
    put_in_order(k[h + 1], k[h + 2]);
  }
  for (const std::size_t i : {0, 1, 2, 3}) put_in_order(k[i], k[i + 4]);
  for (const std::size_t i : {2, 3}) put_in_order(k[i], k[i + 2]);
  for (const std::size_t i : {1, 3, 5}) put_in_order(k[i], k[i + 1]);
}

/// At most N keys, filled up with keys behind all others, so that no step hangs on their number.
template <std::size_t N>
void sort_at_most(std::span<RangeKey> keys) {
  std::array<RangeKey, N> k{};
  for (std::size_t i = 0; i < keys.size(); ++i) k[i] = keys[i];
  sort_network(k);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = k[i];
}

/// Few-layer scanners have up to eight returns of a bearing, in any order (`scanfuse bench speed`,
/// preprocess).
inline void sort_keys(std::span<RangeKey> keys) {
  if (keys.size() < 2) return;
  if (keys.size() == 2) return put_in_order(keys[0], keys[1]);
  if (keys.size() <= 4) return sort_at_most<4>(keys);
  if (keys.size() <= 8) return sort_at_most<8>(keys);
  std::ranges::sort(keys);
}

}  // namespace scanfuse::preprocess
