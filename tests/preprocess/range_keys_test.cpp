#include "scanfuse/preprocess/range_keys.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scanfuse/core/random.hpp"

namespace scanfuse::preprocess {
namespace {

TEST(RangeKey, GivesBackRangeAndIndex) {
  const RangeKey key(12.5F, 7);
  EXPECT_EQ(key.range_m(), 12.5F);
  EXPECT_EQ(key.index(), 7u);
}

TEST(RangeKey, OrderIsByRangeThenByIndex) {
  EXPECT_LT(RangeKey(1, 9), RangeKey(1.0000001F, 3));
  EXPECT_LT(RangeKey(1, 3), RangeKey(1, 9));
  EXPECT_LT(RangeKey(1e4F, 9), RangeKey());
}

TEST(RangeKey, SortingPutsAnyNumberInOrder) {
  RandomStream random(5);
  for (std::uint32_t size = 0; size < 20; ++size) {
    for (int round = 0; round < 200; ++round) {
      std::vector<RangeKey> keys;
      for (std::uint32_t i = 0; i < size; ++i) {
        keys.emplace_back(static_cast<float>(static_cast<int>(random.uniform(1, 12))), i);
      }
      auto expected = keys;
      std::ranges::sort(expected);
      sort_keys(keys);
      ASSERT_EQ(keys, expected) << size;
    }
  }
}

}  // namespace
}  // namespace scanfuse::preprocess
