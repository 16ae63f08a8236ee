#include "scanfuse/drivers/clock_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scanfuse/core/random.hpp"

namespace scanfuse::drivers {
namespace {

const Time kStart = time_from_nanos(1'700'000'000'000'000'000);

/// Messages every 20 ms over a line that delays each by 0.1 ms and, now and then, far more.
struct Line {
  double drift = 0;
  Duration device_start = std::chrono::seconds(1234);
  RandomStream random{11};

  [[nodiscard]] Duration device_at(double utc_s) const {
    return device_start + duration_from_seconds(utc_s * (1 + drift));
  }
  Time received(double utc_s) {
    double delay_s = 1e-4 + 2e-3 * random.uniform() * random.uniform();
    if (random.chance(0.03)) delay_s += 0.05 * random.uniform();
    return kStart + duration_from_seconds(utc_s + delay_s);
  }
};

TEST(ClockMap, KeepsDelaysOutOfTheStamps) {
  Line line;
  ClockMap map;
  for (int i = 0; i < 3000; ++i) {
    const double utc_s = 0.02 * i;
    const Duration at = line.device_at(utc_s);
    const Time stamp = map.stamp(at - std::chrono::milliseconds(5), at, line.received(utc_s));
    if (i < 100) continue;
    EXPECT_NEAR(to_seconds(stamp - kStart), utc_s - 0.005, 5e-4) << i;
  }
  EXPECT_EQ(map.jumps(), 0);
}

TEST(ClockMap, FollowsAClockThatRunsFast) {
  Line line{2e-4};
  ClockMap map;
  double worst_s = 0;
  for (int i = 0; i < 15'000; ++i) {
    const double utc_s = 0.02 * i;
    const Duration at = line.device_at(utc_s);
    const Time stamp = map.stamp(at, at, line.received(utc_s));
    if (i > 3000) worst_s = std::max(worst_s, std::abs(to_seconds(stamp - kStart) - utc_s));
  }
  EXPECT_LT(worst_s, 1e-3);
  EXPECT_NEAR(map.drift(), 2e-4, 2e-5);
}

TEST(ClockMap, CountsJumpsBothWaysAndGoesOn) {
  for (const double jump_s : {5.0, -5.0, 4000.0, -1200.0, 0.3, -0.3}) {
    Line line;
    ClockMap map;
    double worst_s = 0;
    for (int i = 0; i < 2000; ++i) {
      const double utc_s = 0.02 * i;
      Duration at = line.device_at(utc_s);
      if (i >= 500) at += duration_from_seconds(jump_s);
      const Time stamp = map.stamp(at, at, line.received(utc_s));
      if (i > 100) worst_s = std::max(worst_s, std::abs(to_seconds(stamp - kStart) - utc_s));
    }
    EXPECT_EQ(map.jumps(), 1) << jump_s;
    EXPECT_LT(worst_s, 0.1) << jump_s;  // not even while in doubt
  }
}

TEST(ClockMap, IsNotMisledByAStalledConnection) {
  Line line;
  ClockMap map;
  for (int i = 0; i < 2000; ++i) {
    const double utc_s = 0.02 * i;
    // Once in a while everything waits for 400 ms, then comes at once.
    const double stalled_s = std::fmod(utc_s, 10) < 0.4 ? 0.4 - std::fmod(utc_s, 10) : 0;
    const Duration at = line.device_at(utc_s);
    (void)map.stamp(at, at, line.received(utc_s + stalled_s));
  }
  EXPECT_EQ(map.jumps(), 0);
}

TEST(ClockMap, TakesAnEventThatCannotBeForTheSending) {
  ClockMap map;
  const Duration sent = std::chrono::seconds(10);
  EXPECT_EQ(map.stamp(sent + std::chrono::hours(1), sent, kStart), kStart);
  EXPECT_EQ(map.stamp(sent - std::chrono::hours(1), sent, kStart), kStart);
}

TEST(Unwrapper, CountsOnThroughTheEndOfACounter) {
  Unwrapper unwrapper(std::chrono::seconds(16));
  Duration last{-1};
  for (int i = 0; i < 1000; ++i) {
    const auto now = i * std::chrono::milliseconds(700);
    const Duration told = unwrapper.unwrap(now % std::chrono::seconds(16));
    EXPECT_EQ(told, now);
    EXPECT_GT(told, last);
    last = told;
  }
}

}  // namespace
}  // namespace scanfuse::drivers
