#include "scanfuse/preprocess/range_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
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

TEST(RangeKey, SortingAFewPutsThemInOrderWhateverFollows) {
  RandomStream random(5);
  for (std::size_t count = 0; count <= 8; ++count) {
    for (int round = 0; round < 500; ++round) {
      std::vector<RangeKey> keys;
      for (std::uint32_t i = 0; i < 8; ++i) {
        keys.emplace_back(static_cast<float>(static_cast<int>(random.uniform(1, 12))), i);
      }
      const FewKeys few = sorted_few(keys, count);
      keys.resize(count);
      std::ranges::sort(keys);
      ASSERT_TRUE(std::ranges::equal(std::span(few).first(count), keys)) << count;
    }
  }
}

}  // namespace
}  // namespace scanfuse::preprocess
