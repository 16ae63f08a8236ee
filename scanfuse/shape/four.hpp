#pragma once

#include <array>
#include <cstddef>

namespace scanfuse::shape {

/// Four numbers that are worked on at once. GCC and Clang give the operators; a comparison gives a
/// mask for `mask ? a : b`, which takes both sides without a jump.
using Four = float __attribute__((vector_size(16)));

inline Four four(double value) {
  const auto v = static_cast<float>(value);
  return Four{v, v, v, v};
}
inline Four min(Four a, Four b) { return a < b ? a : b; }
inline Four max(Four a, Four b) { return a > b ? a : b; }
inline float sum(Four v) { return (v[0] + v[1]) + (v[2] + v[3]); }
inline float lowest(Four v) {
  const float a = v[0] < v[1] ? v[0] : v[1], b = v[2] < v[3] ? v[2] : v[3];
  return a < b ? a : b;
}
inline float highest(Four v) { return -lowest(-v); }

/// At most N numbers, read four at a time.
template <std::size_t N>
class FourColumn {
 public:
  void set(std::size_t i, float value) { values_[i / 4][i % 4] = value; }
  [[nodiscard]] Four& operator[](std::size_t four) { return values_[four]; }
  [[nodiscard]] const Four& operator[](std::size_t four) const { return values_[four]; }

 private:
  std::array<Four, (N + 3) / 4> values_;
};

}  // namespace scanfuse::shape
