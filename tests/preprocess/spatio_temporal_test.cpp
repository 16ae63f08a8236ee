#include "scanfuse/preprocess/spatio_temporal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::preprocess {
namespace {

PreprocessOptions by(OutlierMethod method, bool compensated = false) {
  PreprocessOptions options;
  options.outliers = method;
  options.median_compensated = compensated;
  return options;
}

struct Share {
  int yes = 0, all = 0;
  void count(bool is) { yes += is, ++all; }
  [[nodiscard]] double value() const { return all > 0 ? static_cast<double>(yes) / all : 0; }
};

/// Rain: of each hundred beams three return from a drop somewhere before what they would have met.
/// Intensity tells them: negative.
void rain_on(Scan& scan, RandomStream& random) {
  for (Return& r : scan.returns) {
    if (!random.chance(0.03)) continue;
    const double range = std::sqrt(r.squared_range());
    if (range < 2) continue;
    const auto factor = static_cast<float>(random.uniform(1, range - 1) / range);
    r.x_m *= factor, r.y_m *= factor, r.z_m *= factor;
    r.intensity = -1;
  }
}

struct Kept {
  std::map<std::string, Share> objects;  ///< "vehicle 20-40 m"
  Share rain, mixed;
};

std::string bin_of(ObjectClass object_class, double range) {
  const int from = 20 * static_cast<int>(range / 20);
  return std::string(to_string(object_class)) + " " + std::to_string(from) + "-" +
         std::to_string(from + 20) + " m";
}

/// What is left of each object, by class and range; every return carries its number as intensity.
Kept kept_of(std::string_view scenario, std::uint64_t seed, int frames, bool rain,
             simulate::SensorPreset sensor = simulate::SensorPreset::kLux) {
  simulate::SimulateOptions options;
  options.frames = frames;
  options.sensor = sensor;
  auto run = simulate::Simulation::create(scenario, seed, options);
  SpatioTemporalFilter filter(by(OutlierMethod::kSupported));
  RandomStream random(seed);
  Kept kept;
  for (bool first = true; auto frame = run->next(); first = false) {
    if (rain) rain_on(frame->scan, random);
    std::vector<bool> is_rain;
    for (std::size_t i = 0; i < frame->scan.returns.size(); ++i) {
      is_rain.push_back(frame->scan.returns[i].intensity < 0);
      frame->scan.returns[i].intensity = static_cast<float>(i);
    }
    const Scan& clean = filter(frame->scan, frame->ego.pose * run->ego_from_sensor());
    if (first) continue;  // nothing came before
    std::set<std::size_t> left;
    for (const Return& r : clean.returns) left.insert(static_cast<std::size_t>(r.intensity));
    std::map<std::int64_t, ObjectClass> classes;
    for (const auto& object : frame->truth.objects) classes[object.id] = object.object_class;
    for (std::size_t i = 0; i < frame->label.size(); ++i) {
      const double range = std::sqrt(frame->scan.returns[i].squared_range());
      if (is_rain[i]) {
        kept.rain.count(left.count(i) > 0);
      } else if (frame->label[i] == simulate::kMixed) {
        kept.mixed.count(left.count(i) > 0);
      } else if (frame->label[i] > 0) {
        kept.objects[bin_of(classes[frame->label[i]], range)].count(left.count(i) > 0);
      }
    }
  }
  return kept;
}

void print(const char* what, const Kept& kept) {
  for (const auto& [name, share] : kept.objects) {
    std::printf("%s, kept of %s: %.4f of %d\n", what, name.c_str(), share.value(), share.all);
  }
  std::printf("%s, kept of rain %.4f of %d, of mixed returns %.4f of %d\n", what, kept.rain.value(),
              kept.rain.all, kept.mixed.value(), kept.mixed.all);
}

TEST(SupportedReturns, ObjectsLoseFewReturns) {
  const Kept kept = kept_of("road-users", 3, 60, false);
  print("four layers", kept);
  for (const auto& [name, share] : kept.objects) {
    if (share.all < 50) continue;
    EXPECT_GE(share.value(), name.ends_with("60-80 m") ? 0.9 : 0.93) << name;
  }
}

TEST(SupportedReturns, OneLayerKeepsItsObjectsToo) {
  const Kept kept = kept_of("road-users", 3, 60, false, simulate::SensorPreset::kSickLms111);
  print("one layer", kept);
  for (const auto& [name, share] : kept.objects) {
    if (share.all < 50) continue;
    EXPECT_GE(share.value(), 0.9) << name;
  }
}

TEST(SupportedReturns, MostDropsOfRainAreTakenAway) {
  const Kept kept = kept_of("road-users", 4, 40, true);
  print("in rain", kept);
  EXPECT_LE(kept.rain.value(), 0.2);
  for (const auto& [name, share] : kept.objects) {
    if (share.all < 50) continue;
    EXPECT_GE(share.value(), name.ends_with("60-80 m") ? 0.85 : 0.95) << name;
  }
}

/// Share of the returns of object `id` that the median moves by more than 0.3 m.
double smeared(std::string_view scenario, std::int32_t id, bool compensated) {
  simulate::SimulateOptions options;
  options.frames = 40;
  auto run = simulate::Simulation::create(scenario, 1, options);
  SpatioTemporalFilter filter(by(OutlierMethod::kMedianReplace, compensated));
  Share moved;
  while (auto frame = run->next()) {
    const Scan& clean = filter(frame->scan, frame->ego.pose * run->ego_from_sensor());
    EXPECT_EQ(clean.returns.size(), frame->scan.returns.size());
    for (std::size_t i = 0; i < frame->label.size(); ++i) {
      if (id > 0 ? frame->label[i] != id : frame->label[i] <= 0) continue;
      const double way = std::sqrt(clean.returns[i].squared_range()) -
                         std::sqrt(frame->scan.returns[i].squared_range());
      moved.count(std::abs(way) > 0.3);
    }
  }
  return moved.value();
}

TEST(MedianReplace, SmearsObjectsWithAndWithoutCompensation) {
  for (const char* scenario : {"lu2018-1", "crossing", "road-users"}) {
    const double plain = smeared(scenario, 0, false), compensated = smeared(scenario, 0, true);
    std::printf("moved by more than 0.3 m in %s: %.3f, with ego compensation %.3f\n", scenario,
                plain, compensated);
    EXPECT_GT(std::max(plain, compensated), 0.02) << scenario;
  }
}

Scan wall(double range, int columns) {
  Scan scan;
  scan.beams = BeamPattern{-0.5, radians(0.25), columns, 1, 0.1, 200};
  for (int c = 0; c < columns; ++c) {
    const double bearing = -0.5 + c * radians(0.25);
    Return r;
    r.x_m = static_cast<float>(range * std::cos(bearing));
    r.y_m = static_cast<float>(range * std::sin(bearing));
    r.beam = c;
    scan.returns.push_back(r);
  }
  return scan;
}

TEST(SpatioTemporalFilter, GivesTheScanItselfWhenOff) {
  SpatioTemporalFilter filter;
  const Scan scan = wall(10, 50);
  EXPECT_EQ(&filter(scan, {}), &scan);
}

TEST(SpatioTemporalFilter, DropsALonelyReturnAndKeepsTheRestInOrder) {
  SpatioTemporalFilter filter(by(OutlierMethod::kSupported));
  Scan scan = wall(10, 50);
  scan.returns[20].x_m *= 0.4F;
  scan.returns[20].y_m *= 0.4F;
  const Scan& clean = filter(scan, {});
  ASSERT_EQ(clean.returns.size(), 49U);
  EXPECT_EQ(clean.returns[19].beam, 19);
  EXPECT_EQ(clean.returns[20].beam, 21);
}

TEST(SpatioTemporalFilter, TheScanBeforeSupportsWhatTheEgoMovedPast) {
  SpatioTemporalFilter filter(by(OutlierMethod::kSupported));
  Scan post = wall(10, 50);
  post.returns = {post.returns[24], post.returns[25]};  // two returns: one supporter each
  EXPECT_EQ(filter(post, {}).returns.size(), 0U);
  Scan nearer = post;
  nearer.stamp = post.stamp + std::chrono::milliseconds(100);
  for (Return& r : nearer.returns) r.x_m -= 1;
  Pose3 moved;
  moved.translation_m.x() = 1;
  EXPECT_EQ(filter(nearer, moved).returns.size(), 2U);
  SpatioTemporalFilter unaware(by(OutlierMethod::kSupported));
  (void)unaware(post, {});
  EXPECT_EQ(unaware(nearer, {}).returns.size(), 0U);
}

TEST(SpatioTemporalFilter, SurvivesReturnsOfNoSense) {
  for (const auto method : {OutlierMethod::kSupported, OutlierMethod::kMedianReplace}) {
    SpatioTemporalFilter filter(by(method, true));
    for (int i = 0; i < 3; ++i) {
      Scan scan = wall(10, 50);
      scan.stamp += std::chrono::milliseconds(100 * i);
      scan.returns[3].x_m = std::numeric_limits<float>::quiet_NaN();
      scan.returns[4].x_m = scan.returns[4].y_m = 0;
      scan.returns[5].layer = -7;
      scan.returns[6].beam = 1 << 30;
      scan.returns[7].layer = 30000;
      scan.returns[8].x_m = 1e30F;
      if (i == 2) scan.beams.reset();
      EXPECT_LE(filter(scan, {}).returns.size(), 50U);
    }
  }
}

TEST(SpatioTemporalFilter, EmptyScansAreFine) {
  SpatioTemporalFilter filter(by(OutlierMethod::kMedianReplace));
  EXPECT_EQ(filter(Scan{}, {}).returns.size(), 0U);
  EXPECT_EQ(filter(wall(10, 20), {}).returns.size(), 20U);
  EXPECT_EQ(filter(Scan{}, {}).returns.size(), 0U);
}

}  // namespace
}  // namespace scanfuse::preprocess
