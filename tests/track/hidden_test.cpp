#include "scanfuse/track/hidden.hpp"

#include <gtest/gtest.h>

#include "scanfuse/track/tracker.hpp"
#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

Detection standing_car(double x, double y) {
  const Eigen::Vector2d place(x, y);
  return testing::box_detection(place, 0, {place, {0, 0}}, 0.05);
}

TEST(Shadows, HideWhatStandsBehindAndNothingElse) {
  Shadows shadows;
  shadows.cast(std::vector{standing_car(10, 0)});
  EXPECT_GT(shadows.hidden_share(standing_car(30, 0).box), 0.99);
  EXPECT_EQ(shadows.hidden_share(standing_car(30, 8).box), 0);
  EXPECT_EQ(shadows.hidden_share(standing_car(5, 0).box), 0) << "stands before it";
  EXPECT_EQ(shadows.hidden_share(standing_car(-30, 0).box), 0) << "lies on the other side";
}

TEST(Shadows, TwoThatOverlapHideNoMoreThanAll) {
  Shadows shadows;
  shadows.cast(std::vector{standing_car(10, 0), standing_car(15, 0.3), standing_car(10, 0.2)});
  EXPECT_LE(shadows.hidden_share(standing_car(30, 0).box), 1 + 1e-12);
}

TEST(Shadows, AreTheSameAcrossTheBackOfTheSensor) {
  Shadows shadows;
  shadows.cast(std::vector{standing_car(-10, 0)});
  EXPECT_GT(shadows.hidden_share(standing_car(-30, 0.2).box), 0.9);
}

TEST(Shadows, WithoutDetectionsThereAreNone) {
  Shadows shadows;
  shadows.cast({});
  EXPECT_EQ(shadows.hidden_share(standing_car(30, 0).box), 0);
}

/// Whether a car seen for a second is reported all the time that it is unseen, 0.8 s, with a car
/// between it and the sensor or not; when given up it is not looked for again.
bool keeps_identity(bool hidden) {
  TrackerOptions options;
  options.lost_s = 0;
  Tracker tracker(options);
  std::int64_t before = -1, after = -2;
  for (int k = 0; k < 30; ++k) {
    const bool unseen = k >= 12 && k < 22;
    std::vector<Detection> seen;
    if (!unseen) seen.push_back(standing_car(30 - 0.4 * k, 1));
    if (hidden && unseen) seen.push_back(standing_car(12, 0.4));
    const auto& tracks = tracker.step(time_from_seconds(0.08 * k), seen);
    for (const Track& track : tracks) {
      if (track.detection != 0 || unseen) continue;
      (k < 12 ? before : after) = track.id;
    }
  }
  return before == after;
}

TEST(Tracker, KeepsWhatIsHiddenForLongerThanWhatIsGone) {
  EXPECT_TRUE(keeps_identity(true));
  EXPECT_FALSE(keeps_identity(false));
}

}  // namespace
}  // namespace scanfuse::track
