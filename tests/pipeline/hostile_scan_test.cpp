#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scanfuse/core/random.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/pipeline/perception.hpp"

// Scans no sensor would send: whatever comes in, every number that leaves the chain is finite.
namespace scanfuse::pipeline {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kHuge = std::numeric_limits<float>::max();

bool is_sound(const Box2& box) {
  return box.centre_m.allFinite() && std::isfinite(box.heading_rad) &&
         std::isfinite(box.length_m) && std::isfinite(box.width_m);
}

bool is_sound(const Detection& d) {
  return is_sound(d.box) && std::isfinite(d.score) && std::isfinite(d.z_m) &&
         std::isfinite(d.height_m) && d.covariance.allFinite() && std::isfinite(d.var_length_m2) &&
         std::isfinite(d.var_width_m2) && std::isfinite(d.time_offset_s) &&
         d.seen_from_m.allFinite() && d.visible_middle_m.allFinite();
}

bool is_sound(const Track& t) {
  return is_sound(t.box) && std::isfinite(t.class_probability) && std::isfinite(t.z_m) &&
         std::isfinite(t.height_m) && t.state.mean.allFinite() && t.state.covariance.allFinite() &&
         std::isfinite(t.speed_m_per_s) && std::isfinite(t.accel_m_per_s2) &&
         std::isfinite(t.yaw_rate_rad_per_s) && std::isfinite(t.nis);
}

void expect_sound(const StepResult& result) {
  for (const Detection& detection : result.detections) ASSERT_TRUE(is_sound(detection));
  for (const Track& track : result.tracks) {
    ASSERT_TRUE(is_sound(track)) << "track " << track.id;
    ASSERT_LT(track.detection, static_cast<int>(result.detections.size()));
  }
}

/// Draws scans of which everything may be wrong: coordinates, order, beams, layers, times, poses.
class HostileWorld {
 public:
  explicit HostileWorld(std::uint64_t seed) : random_(seed) {}

  PosedScan next() {
    PosedScan posed;
    posed.scan.stamp = next_stamp();
    posed.scan.frame = frame_++;
    posed.scan.sensor = one_in(3) ? "/other" : "/scan";
    posed.scan.returns.resize(count());
    const int kind = draw(5);
    for (std::size_t i = 0; i < posed.scan.returns.size(); ++i) {
      posed.scan.returns[i] = one_in(20) ? wild_return() : plain_return(kind, i);
    }
    if (one_in(2)) posed.scan.beams = pattern();
    if (one_in(3)) posed.world_from_ego.translation_m = {wild(), wild(), wild()};
    if (one_in(3)) posed.ego_from_sensor.translation_m = {wild(), wild(), wild()};
    if (one_in(3)) posed.twist = {wild(), wild(), wild()};
    return posed;
  }

 private:
  bool one_in(int n) { return draw(n) == 0; }
  int draw(int n) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(n))); }
  float wild() {
    const float values[] = {0,      1e-38F, -1e-30F,   1,     -40,    1e6F,
                            -1e12F, kNan,   kInfinite, kHuge, -kHuge, 0.05F};
    return values[draw(static_cast<int>(std::size(values)))];
  }
  std::size_t count() {
    const std::size_t counts[] = {0, 1, 2, 3, 500, 1500, 6000};
    return counts[draw(static_cast<int>(std::size(counts)))];
  }
  Time next_stamp() {
    using namespace std::chrono_literals;
    const Time ends[] = {Time::min(), Time::max(), Time{}};
    if (one_in(12)) return ends[draw(3)];
    const Duration steps[] = {40ms, 40ms, 40ms, 40ms, 0ms, -10ms, 1000h, -900h, 7s};
    stamp_ += steps[draw(static_cast<int>(std::size(steps)))];
    return stamp_;
  }
  Return wild_return() {
    Return r;
    r.x_m = wild();
    r.y_m = wild();
    r.z_m = wild();
    r.intensity = wild();
    r.time_offset_s = wild();
    r.beam = draw(2) == 0 ? std::numeric_limits<std::int32_t>::max() : -7;
    r.layer = draw(2) == 0 ? std::numeric_limits<std::int16_t>::min()
                           : std::numeric_limits<std::int16_t>::max();
    r.echo = 255;
    return r;
  }
  /// Kinds: walls and corners, all in one place, on one line through the sensor, noise, a car.
  Return plain_return(int kind, std::size_t i) {
    Return r;
    const auto t = static_cast<float>(i) * 0.004F;
    switch (kind) {
      case 0:
        r.x_m = std::fmod(t, 3.0F) + 8;
        r.y_m = t - 3;
        break;
      case 1:
        r.x_m = 5;
        r.y_m = 5;
        break;
      case 2:
        r.x_m = t + 0.1F;
        break;
      case 3:
        r.x_m = static_cast<float>(random_.normal()) * 30;
        r.y_m = static_cast<float>(random_.normal()) * 30;
        r.z_m = static_cast<float>(random_.normal());
        break;
      default:
        r.x_m = 12 + (t < 1.8F ? 0 : t - 1.8F);
        r.y_m = t < 1.8F ? t : 1.8F;
    }
    r.beam = static_cast<std::int32_t>(i);
    r.layer = static_cast<std::int16_t>(i % 4);
    return r;
  }
  BeamPattern pattern() {
    BeamPattern beams;
    beams.first_azimuth_rad = wild();
    beams.step_rad = one_in(2) ? 0.004 : wild();
    beams.columns = one_in(2) ? 1500 : draw(1000) - 500;
    beams.layers = one_in(2) ? 4 : std::numeric_limits<int>::max();
    beams.min_range_m = wild();
    beams.max_range_m = wild();
    return beams;
  }

  RandomStream random_;
  Time stamp_{std::chrono::seconds(1'600'000'000)};
  std::int64_t frame_ = 0;
};

PerceptionOptions chain(const char* method, OutputFrame frame) {
  auto options = preset("vehicle-pag");
  EXPECT_TRUE(set_config(*options, "segment", "method", method).has_value());
  options->pipeline.frame = frame;
  return *options;
}

TEST(HostileScans, GiveNothingThatIsNotFiniteByAnySegmentation) {
  for (const char* method : {"pag", "pag_literal", "surface", "breakpoint", "adaptive",
                             "distance_threshold", "euclidean"}) {
    for (const OutputFrame frame : {OutputFrame::kWorld, OutputFrame::kEgo}) {
      SCOPED_TRACE(method);
      Perception perception(chain(method, frame));
      HostileWorld world(7);
      for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        ASSERT_NO_FATAL_FAILURE(expect_sound(perception.step(world.next())));
      }
    }
  }
}

TEST(HostileScans, OfAHundredThousandReturnsAreWorkedThrough) {
  Perception perception;
  PosedScan posed;
  RandomStream random(3);
  for (int i = 0; i < 100'000; ++i) {
    Return r;
    r.x_m = static_cast<float>(random.uniform(-60, 60));
    r.y_m = static_cast<float>(random.uniform(-60, 60));
    r.z_m = static_cast<float>(random.uniform(-2, 3));
    posed.scan.returns.push_back(r);
  }
  for (int i = 0; i < 3; ++i) {
    posed.scan.stamp += std::chrono::milliseconds(100);
    ASSERT_NO_FATAL_FAILURE(expect_sound(perception.step(posed)));
  }
}

TEST(HostileScans, DoNotSpoilTheScansAfterThem) {
  PosedScan car;
  for (int i = 0; i < 60; ++i) {
    const float along = static_cast<float>(i) * 0.09F;
    Return r;
    r.x_m = 10 + (along > 1.8F ? along - 1.8F : 0);
    r.y_m = along > 1.8F ? 1.8F : along;
    car.scan.returns.push_back(r);
  }
  Perception fresh, used;
  HostileWorld world(11);
  for (int i = 0; i < 40; ++i) used.step(world.next());
  for (int i = 0; i < 20; ++i) {
    car.scan.stamp = Time(std::chrono::milliseconds(40 * i));
    const auto expected = fresh.step(car).tracks;
    const auto& found = used.step(car).tracks;
    ASSERT_EQ(found.size(), expected.size()) << "scan " << i;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].state.mean, expected[k].state.mean);
    }
  }
}

}  // namespace
}  // namespace scanfuse::pipeline
