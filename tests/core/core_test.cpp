#include <gtest/gtest.h>

#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/core/time.hpp"

namespace scanfuse {
namespace {

TEST(Time, SecondsRoundToTheNearestNanosecond) {
  EXPECT_EQ(duration_from_seconds(1.5).count(), 1'500'000'000);
  EXPECT_EQ(duration_from_seconds(-0.25).count(), -250'000'000);
  EXPECT_EQ(to_nanos(time_from_nanos(1575811624359102488)), 1575811624359102488);
}

TEST(RandomStream, IsTheSameForTheSameSeedAndDiffersBetweenStreams) {
  RandomStream a(7, 1), b(7, 1), c(7, 2);
  const auto first = a.next();
  EXPECT_EQ(first, b.next());
  EXPECT_NE(first, c.next());
}

TEST(RandomStream, NormalDrawsHaveUnitVarianceAndNoMean) {
  RandomStream stream(3);
  double sum = 0, squares = 0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.015);
  EXPECT_NEAR(squares / kDraws, 1, 0.02);
}

TEST(ParallelFor, CallsEveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(1000, 0);
    parallel_for(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
  }
}

TEST(Diagnostics, CountsByNameAndRemembersTheFirstPlaceAndDamage) {
  Diagnostics ours, theirs;
  ours.note("clock jump", "scan 3");
  theirs.damage("chunk skipped", "byte 100", 2);
  theirs.note("clock jump", "scan 9");
  ours.merge(theirs);
  EXPECT_EQ(ours.count("clock jump"), 2);
  EXPECT_EQ(ours.count("chunk skipped"), 2);
  EXPECT_EQ(ours.entries().at("clock jump").first, "scan 3");
  EXPECT_TRUE(ours.any_damage());
}

}  // namespace
}  // namespace scanfuse
