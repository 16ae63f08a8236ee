#include "scanfuse/associate/associate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "scanfuse/associate/gate.hpp"
#include "scanfuse/associate/position_grid.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::associate {
namespace {

constexpr Method kAll[] = {Method::kGlobal, Method::kNearest, Method::kDetectionGreedy};

std::vector<Candidate> random_candidates(int tracks, int detections, double share,
                                         RandomStream& random) {
  std::vector<Candidate> candidates;
  for (int t = 0; t < tracks; ++t) {
    for (int d = 0; d < detections; ++d) {
      if (random.chance(share)) candidates.push_back({t, d, random.uniform(-5, 12)});
    }
  }
  return candidates;
}

/// What an assignment is worth: pairs made at their cost, pairs left open at `open`.
double worth(const Assignment& a, const std::vector<Candidate>& candidates, double open) {
  double sum = 0;
  for (const Candidate& c : candidates) {
    if (a.detection_of_track[c.track] == c.detection) sum += c.cost - open;
  }
  return sum;
}

double best_by_enumeration(int track, int tracks, std::set<int>& taken,
                           const std::vector<Candidate>& candidates, double open) {
  if (track == tracks) return 0;
  double best = best_by_enumeration(track + 1, tracks, taken, candidates, open);
  for (const Candidate& c : candidates) {
    if (c.track != track || taken.contains(c.detection)) continue;
    taken.insert(c.detection);
    best = std::min(
        best, c.cost - open + best_by_enumeration(track + 1, tracks, taken, candidates, open));
    taken.erase(c.detection);
  }
  return best;
}

void expect_one_to_one(const Assignment& a) {
  for (std::size_t t = 0; t < a.detection_of_track.size(); ++t) {
    const int d = a.detection_of_track[t];
    if (d >= 0) {
      EXPECT_EQ(a.track_of_detection[d], static_cast<int>(t));
    }
  }
  const auto paired = [](int i) { return i >= 0; };
  EXPECT_EQ(std::ranges::count_if(a.detection_of_track, paired),
            std::ranges::count_if(a.track_of_detection, paired));
}

TEST(AssignGlobal, IsTheBestOfAllAssignments) {
  RandomStream random(2);
  for (int run = 0; run < 300; ++run) {
    const int tracks = 1 + static_cast<int>(random.below(5));
    const int detections = 1 + static_cast<int>(random.below(5));
    const auto candidates = random_candidates(tracks, detections, random.uniform(), random);
    const auto a = assign_global(tracks, detections, candidates, 9.0);
    std::set<int> taken;
    expect_one_to_one(a);
    EXPECT_NEAR(worth(a, candidates, 9), best_by_enumeration(0, tracks, taken, candidates, 9),
                1e-9);
  }
}

TEST(Associate, OrderOfTheCandidatesDoesNotMatter) {
  RandomStream random(3);
  for (const Method method : kAll) {
    auto candidates = random_candidates(12, 15, 0.2, random);
    const auto before = associate(method, 12, 15, candidates, 9);
    std::reverse(candidates.begin(), candidates.end());
    EXPECT_EQ(associate(method, 12, 15, candidates, 9).detection_of_track,
              before.detection_of_track);
  }
}

TEST(Associate, MakesNoPairAtTheCostOfStayingOpen) {
  const std::vector<Candidate> candidates = {{0, 0, 9.0}, {1, 1, 8.9}};
  for (const Method method : kAll) {
    const auto a = associate(method, 2, 2, candidates, 9);
    EXPECT_EQ(a.detection_of_track, (std::vector<int>{-1, 1}));
  }
}

TEST(Associate, NothingGivesNothing) {
  for (const Method method : kAll) {
    EXPECT_EQ(associate(method, 0, 2, {}, 9).track_of_detection, (std::vector<int>{-1, -1}));
    EXPECT_EQ(associate(method, 2, 0, {}, 9).detection_of_track, (std::vector<int>{-1, -1}));
  }
}

// Two filters at 0 and 2, detections at 1.1 and 3: the first detection is nearer to filter 1.
TEST(AssignDetectionGreedy, TheFirstDetectionTakesWhatTheSecondNeeds) {
  const std::vector<Candidate> candidates = {{0, 0, 1.1}, {1, 0, 0.9}, {0, 1, 3.0}, {1, 1, 1.0}};
  const auto greedy = assign_detection_greedy(2, 2, candidates, 2.5);
  EXPECT_EQ(greedy.track_of_detection, (std::vector<int>{1, -1}));
  const auto global = assign_global(2, 2, candidates, 2.5);
  EXPECT_EQ(global.track_of_detection, (std::vector<int>{0, 1}));
}

TEST(AssignDetectionGreedy, AFilterTakenIsNotTakenAgain) {
  const std::vector<Candidate> candidates = {{0, 0, 0.5}, {0, 1, 0.1}, {1, 1, 0.8}};
  EXPECT_EQ(assign_detection_greedy(2, 2, candidates, 2).track_of_detection,
            (std::vector<int>{0, 1}));
}

TEST(Gate, NineHundredNinetyNineInAThousandPass) {
  EXPECT_NEAR(gate_in_the_plane(0.999), 13.8155, 1e-4);
  RandomStream random(4);
  int outside = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = random.normal(), y = random.normal();
    outside += x * x + y * y > gate_in_the_plane(0.999);
  }
  EXPECT_NEAR(outside, 200, 45);
}

TEST(PositionGrid, FindsAllWithinItsCellSize) {
  RandomStream random(6);
  std::vector<Eigen::Vector2d> points(500);
  PositionGrid grid(4);
  for (int i = 0; i < 500; ++i) {
    points[i] = {random.uniform(-50, 50), random.uniform(-50, 50)};
    grid.add(points[i], i);
  }
  grid.sort();
  for (const auto& centre : points) {
    std::set<int> found;
    grid.near(centre, [&](int i) { EXPECT_TRUE(found.insert(i).second); });
    for (int i = 0; i < 500; ++i) {
      if ((points[i] - centre).norm() <= 4) {
        EXPECT_TRUE(found.contains(i));
      }
    }
  }
}

TEST(Jpda, AsAPolicyHitsWhatIsLikelierHitThanNot) {
  // Odds of a pair against none: exp((10 - cost) / 2).
  const std::vector<Candidate> pairs{{0, 0, 2}, {0, 1, 4}, {1, 2, 14}};
  Associator associate;
  const Assignment& a = associate(Method::kJpda, 2, 3, pairs, 10);
  EXPECT_EQ(a.detection_of_track, (std::vector<int>{0, -1}));
  EXPECT_EQ(a.track_of_detection, (std::vector<int>{0, -1, -1}));
  const double near = std::exp(4.0), far = std::exp(3.0), all = 1 + near + far;
  EXPECT_NEAR(associate.shares().pair[0], near / all, 1e-12);
  EXPECT_NEAR(associate.shares().pair[1], far / all, 1e-12);
  EXPECT_NEAR(associate.shares().missed[1], 1 / (1 + std::exp(-2.0)), 1e-12);
}

}  // namespace
}  // namespace scanfuse::associate
