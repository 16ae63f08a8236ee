#include <gtest/gtest.h>

#include <set>

#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::simulate {
namespace {

constexpr std::uint64_t kSeeds = 20;

/// Frames of `looked_at` in which each object is seen. The others are passed over unmeasured.
std::vector<std::set<int>> frames_seen(std::string_view scenario, std::uint64_t seed,
                                       const std::set<int>& looked_at) {
  auto simulation = Simulation::create(scenario, seed);
  std::vector<std::set<int>> seen;
  for (int f = 0; f < simulation->frames(); ++f) {
    const auto frame = looked_at.contains(f) ? simulation->next() : simulation->next_truth();
    seen.resize(frame->truth.objects.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (frame->truth.objects[i].visible_points.value_or(0) > 0) seen[i].insert(f);
    }
  }
  return seen;
}

using Frames = std::set<int>;

TEST(Lu2018, ScenarioOneHasItsEntryItsExitAndItsMissesForEverySeed) {
  const Frames looked_at{0, 24, 25, 26, 27, 101, 102, 103, 146, 147, 148, 149, 171, 172, 177, 189};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto seen = frames_seen("lu2018-1", seed, looked_at);
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0], (Frames{0, 24, 25, 26, 27, 101, 103, 146, 147, 149, 171, 189})) << seed;
    EXPECT_EQ(seen[1], (Frames{26, 27, 101, 102, 103, 146})) << "seed " << seed;
  }
}

TEST(Lu2018, ScenarioTwoHidesTargetOneFromFrame62To74ForEverySeed) {
  const Frames looked_at{0,  50, 51, 60, 61, 62, 63, 64, 65, 66, 67,
                         68, 69, 70, 71, 72, 73, 74, 75, 76, 90, 139};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto seen = frames_seen("lu2018-2", seed, looked_at);
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0], (Frames{0, 50, 51, 60, 61, 75, 76, 90, 139})) << "seed " << seed;
    EXPECT_EQ(seen[1].size(), looked_at.size() - 2) << "seed " << seed;
    EXPECT_EQ(*seen[1].begin(), 51) << "seed " << seed;
  }
}

TEST(Lu2018, ScenarioThreeLosesTargetOneAtFrame16ForEverySeed) {
  const Frames looked_at{0, 14, 15, 16, 17, 60, 119};
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto seen = frames_seen("lu2018-3", seed, looked_at);
    ASSERT_EQ(seen.size(), 3U);
    EXPECT_EQ(seen[0], (Frames{0, 14, 15})) << "seed " << seed;
    EXPECT_EQ(seen[1], looked_at) << "seed " << seed;
    EXPECT_EQ(seen[2], looked_at) << "seed " << seed;
  }
}

TEST(Lu2018, TheHiddenCarIsSaidToBeOccluded) {
  auto simulation = Simulation::create("lu2018-2", 3);
  while (auto frame = simulation->next()) {
    const double occluded = *frame->truth.objects[0].occluded;
    const bool behind = frame->scan.frame >= 63 && frame->scan.frame <= 73;
    EXPECT_TRUE(!behind || occluded > 0.95) << frame->scan.frame << " " << occluded;
    EXPECT_TRUE(frame->scan.frame >= 51 || occluded < 0.05) << frame->scan.frame;
  }
}

}  // namespace
}  // namespace scanfuse::simulate
