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

  /// The key where it counts, else one behind all others; without a jump.
  [[nodiscard]] RangeKey where(bool counts) const {
    RangeKey key;
    key.bits_ = bits_ | (std::uint64_t{counts} - 1);
    return key;
  }

  /// Without a jump, for a processor cannot guess the outcome.
  friend void put_in_order(RangeKey& a, RangeKey& b) {
    const std::uint64_t first = a.bits_, second = b.bits_;
    a.bits_ = first < second ? first : second;
    b.bits_ = first < second ? second : first;
  }

 private:
  std::uint64_t bits_ = ~std::uint64_t{0};  ///< behind all others
};

using FewKeys = std::array<RangeKey, 8>;

/// Puts keys[at] to keys[at + 3] in order.
inline void sort_four(FewKeys& keys, std::size_t at) {
  put_in_order(keys[at], keys[at + 1]);
  put_in_order(keys[at + 2], keys[at + 3]);
  put_in_order(keys[at], keys[at + 2]);
  put_in_order(keys[at + 1], keys[at + 3]);
  put_in_order(keys[at + 1], keys[at + 2]);
}

/// The first `count` of `keys` in order, 8 at most: few-layer scanners have no more returns of a
/// bearing, in any order. What follows them in `keys`, up to 8 in all, is read but counts for
/// nothing: no step hangs on their number (`scanfuse bench speed`, preprocess).
inline FewKeys sorted_few(std::span<const RangeKey> keys, std::size_t count) {
  FewKeys k;
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = keys[i].where(i < count);
  sort_four(k, 0);
  if (count <= 4) return k;
  sort_four(k, 4);
  // Batcher's merge of two sorted halves.
  for (const std::size_t i : {0, 1, 2, 3}) put_in_order(k[i], k[i + 4]);
  for (const std::size_t i : {2, 3}) put_in_order(k[i], k[i + 2]);
  for (const std::size_t i : {1, 3, 5}) put_in_order(k[i], k[i + 1]);
  return k;
}

}  // namespace scanfuse::preprocess
