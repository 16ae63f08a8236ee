#include "scanfuse/track/class_belief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scanfuse::track {
namespace {

constexpr double kStep_s = 0.1;

Sighting sighting_at(double t_s, double breadth_m) {
  Sighting seen;
  seen.class_probability = {0, 0.25, 0.25, 0.25, 0.25};
  seen.cues = {10, breadth_m, 0.1, 1, 0.8, 1, 0.05};
  seen.stamp = time_from_nanos(0) + duration_from_seconds(t_s);
  return seen;
}

ClassBelief seen_often(int scans, double breadth_m, double waver_m, int every = 1) {
  ClassBelief belief;
  for (int i = 0; i < scans; i += every) {
    belief.add(sighting_at(i * kStep_s, breadth_m + (i / every % 2 ? waver_m : -waver_m)), {});
  }
  return belief;
}

TEST(ClassBelief, TermsAreFiniteForBlankAndHugeSightings) {
  ClassBelief blank, huge;
  Sighting nothing;
  nothing.stamp = time_from_nanos(0);
  blank.add(nothing, {});
  Sighting large = sighting_at(0, 1e9);
  large.cues = {1e9, 1e9, 1e9, 1e9, 1e9, 1, 1e9};
  huge.add(large, {});
  for (const auto& belief : {blank, huge}) {
    const auto terms = belief.terms({{1e6, 1e6}, 1e6, 0});
    EXPECT_TRUE(terms.allFinite());
    EXPECT_LT(terms.cwiseAbs().maxCoeff(), 20);
  }
}

TEST(ClassBelief, EveryTermHasAName) {
  EXPECT_EQ(belief_term_names().size(), static_cast<std::size_t>(kBeliefTerms));
}

TEST(ClassBelief, AShapeThatChangesFromScanToScanWavers) {
  const auto steady = seen_often(20, 0.5, 0).cues({});
  const auto restless = seen_often(20, 0.5, 0.2).cues({});
  EXPECT_NEAR(steady[kBreadthWaver], 0, 1e-6);
  EXPECT_GT(restless[kBreadthWaver], 1);
  EXPECT_NEAR(steady[kCueBreadth], restless[kCueBreadth], 0.2);
}

TEST(ClassBelief, MissedScansLowerTheShareSeen) {
  const auto always = seen_often(30, 0.5, 0).cues({});
  const auto every_other = seen_often(30, 0.5, 0, 2).cues({});
  EXPECT_NEAR(always[kSeenShare], 1, 0.01);
  EXPECT_LT(every_other[kSeenShare], 0);
}

TEST(ClassBelief, ItsSumsStayBoundedHoweverLongAndFastItIsSeen) {
  const BeliefModel model;
  ClassBelief belief;
  for (int i = 0; i < 20000; ++i) {
    Sighting seen = sighting_at(i * 0.01, 0.5);
    seen.class_probability = {0, 0, 1, 0, 0};
    belief.add(seen, model);
  }
  EXPECT_LE(belief.evidence, model.memory_s / model.full_s + 1);
}

// Without layers nothing is known of height: the cue must not say "flat".
TEST(ClassBelief, OneLayerLeavesTheLayersDepthInTheMiddle) {
  ClassBelief belief;
  Sighting seen = sighting_at(0, 0.5);
  seen.cues.layered_share = seen.cues.layer_depth_m = 0;
  belief.add(seen, {});
  EXPECT_EQ(belief.cues({})[kLayerDepth], 0);
}

}  // namespace
}  // namespace scanfuse::track
