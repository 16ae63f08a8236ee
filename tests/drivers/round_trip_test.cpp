#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "drivers/sample_scans.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/drivers/device.hpp"
#include "scanfuse/drivers/ouster/ouster.hpp"

// What every device must keep, whatever its protocol: the scan that its simulator says is the one
// its driver hears, however the bytes are cut up, and whatever garbage comes between.
namespace scanfuse::drivers {
namespace {

using drivers_testing::pattern_deg;
using drivers_testing::sample_scan;

/// A device, how it measures, and how exactly its protocol can say it.
struct Case {
  std::string scheme;
  BeamPattern beams;
  double lowest_deg = 0;
  double layer_step_deg = 0;
  bool clockwise = false;
  double position_m = 0.01;  ///< at 10 m
  double stamp_s = 1e-5;
  double offset_s = 1e-3;
  bool has_clock = true;
  double least_share = 1;  ///< of the returns that come through
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.scheme; }

class Devices : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    device_ = *find_device(GetParam().scheme);
    DriverOptions options{"lidar", ""};
    if (GetParam().scheme == "ouster") {
      options.metadata = ouster::metadata_of(ouster::simulated_beams());
    }
    driver_ = device_->make_driver(options);
    simulator_ = device_->make_simulator();
    shake_hands();
  }

  /// Until neither has anything to say.
  void shake_hands() {
    Bytes to_device = driver_->hello();
    for (int i = 0; i < 10 && !to_device.empty(); ++i) {
      const Bytes answer = simulator_->answer(to_device);
      Output out;
      if (!answer.empty()) driver_->take(answer, now_, out);
      to_device = out.reply;
    }
    ASSERT_TRUE(simulator_->is_streaming());
  }

  /// The scans of some turns, with their stamps a turn apart.
  std::vector<Scan> turns(int count) const {
    std::vector<Scan> scans;
    for (int i = 0; i < count; ++i) {
      const Case& c = GetParam();
      Scan scan = sample_scan(c.beams, c.lowest_deg, c.layer_step_deg, c.clockwise,
                              static_cast<std::uint64_t>(i) + 7);
      scan.stamp += i * std::chrono::milliseconds(100);
      scan.frame = i;
      scans.push_back(std::move(scan));
    }
    return scans;
  }

  using Damage = std::function<void(Bytes&, std::size_t)>;

  std::vector<Scan> hear(const std::vector<Scan>& said, const Damage& damage = nullptr) {
    Output out;
    std::size_t count = 0;
    for (const Scan& scan : said) {
      for (Telegram& telegram : simulator_->encode(scan)) {
        if (damage) damage(telegram.bytes, count++);
        pass_on(telegram.bytes, scan.stamp + duration_from_seconds(telegram.after_s), out);
      }
    }
    driver_->finish(out);
    return std::move(out.scans);
  }

  /// Streams come in pieces of any length, datagrams whole.
  void pass_on(ByteView bytes, Time received, Output& out) {
    if (device_->link == Link::kUdp) return driver_->take(bytes, received, out);
    while (!bytes.empty()) {
      const auto count = std::min<std::size_t>(1 + random_.below(700), bytes.size());
      driver_->take(bytes.first(count), received, out);
      bytes = bytes.subspan(count);
    }
  }

  const Device* device_ = nullptr;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<DeviceSimulator> simulator_;
  RandomStream random_{3};
  Time now_ = time_from_nanos(1'700'000'000'000'000'000);
};

/// How many of the returns said were heard at their place.
int matched(const Scan& said, const Scan& heard, const Case& c) {
  auto sorted = heard.returns;
  std::ranges::sort(sorted, {}, &Return::x_m);
  int count = 0;
  for (const Return& r : said.returns) {
    const double near_m = c.position_m * (1 + std::hypot(r.x_m, r.y_m, r.z_m) / 10);
    const auto first = std::ranges::lower_bound(sorted, r.x_m - near_m, {}, &Return::x_m);
    for (auto it = first; it != sorted.end() && it->x_m < r.x_m + near_m; ++it) {
      if (it->layer != r.layer || std::abs(it->intensity - r.intensity) > 50) continue;
      if (std::hypot(it->x_m - r.x_m, it->y_m - r.y_m, it->z_m - r.z_m) > near_m) continue;
      const double said_at = r.time_offset_s + to_seconds(said.stamp - heard.stamp);
      if (c.has_clock && std::abs(it->time_offset_s - said_at) > c.offset_s) continue;
      ++count;
      break;
    }
  }
  return count;
}

TEST_P(Devices, HearWhatTheirSimulatorsSay) {
  const auto said = turns(5);
  const auto heard = hear(said);
  // The first turn may only tell where turns begin, the last may wait for the next.
  ASSERT_GE(heard.size(), 3U);
  ASSERT_LE(heard.size(), 5U);
  const Case& c = GetParam();
  for (const Scan& scan : heard) {
    const auto nearest = std::ranges::min_element(
        said, {}, [&](const Scan& s) { return std::abs(to_seconds(s.stamp - scan.stamp)); });
    if (c.has_clock) {
      // Turns whose first beams see nothing begin a little later.
      EXPECT_NEAR(to_seconds(scan.stamp - nearest->stamp), 0, std::max(c.stamp_s, c.offset_s));
    }
    int best = 0;
    for (const Scan& s : said) best = std::max(best, matched(s, scan, c));
    EXPECT_GE(best, c.least_share * static_cast<double>(nearest->returns.size()))
        << "scan " << scan.frame << ": " << scan.returns.size() << " returns of "
        << nearest->returns.size();
    EXPECT_LE(scan.returns.size(), nearest->returns.size() + 10);
  }
  EXPECT_FALSE(driver_->diagnostics().any_damage());
}

TEST_P(Devices, FindTheirWayBackAfterGarbage) {
  const auto said = turns(8);
  RandomStream random(5);
  const auto heard = hear(said, [&](Bytes& bytes, std::size_t) {
    if (random.chance(0.02)) {
      Bytes garbage(1 + random.below(300));
      for (auto& b : garbage) b = static_cast<std::byte>(random.below(256));
      bytes.insert(bytes.begin(), garbage.begin(), garbage.end());
    } else if (random.chance(0.02)) {
      bytes.resize(bytes.size() / 2);
    }
  });
  EXPECT_GE(heard.size(), 3U);
  for (const Scan& scan : heard) {
    for (const Return& r : scan.returns) {
      ASSERT_TRUE(std::isfinite(r.x_m) && std::isfinite(r.y_m) && std::isfinite(r.z_m));
    }
  }
}

TEST_P(Devices, DoNotCrashOnAnyDamagedByte) {
  const auto said = turns(2);
  RandomStream random(6);
  Output out;
  for (int round = 0; round < 20; ++round) {
    for (const Scan& scan : said) {
      for (Telegram& telegram : simulator_->encode(scan)) {
        for (int i = 0; i < 5 && !telegram.bytes.empty(); ++i) {
          telegram.bytes[random.below(telegram.bytes.size())] =
              static_cast<std::byte>(random.below(256));
        }
        driver_->take(telegram.bytes, now_ + round * std::chrono::milliseconds(100), out);
      }
    }
  }
  driver_->lost();
  for (const Scan& scan : out.scans) {
    for (const Return& r : scan.returns) ASSERT_TRUE(std::isfinite(r.squared_range()));
  }
}

Case device(std::string scheme, const BeamPattern& beams) {
  Case c;
  c.scheme = std::move(scheme);
  c.beams = beams;
  return c;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back(device("sick", pattern_deg(-135, 0.5, 541, 1, 0.5, 20)));
  all.back().offset_s = 2e-4;
  Case mrs = device("sick", pattern_deg(-137.5, 0.25, 1101, 4, 0.2, 64));
  mrs.lowest_deg = -2.5;
  mrs.layer_step_deg = 2.5;
  mrs.offset_s = 2e-4;
  all.push_back(mrs);
  Case multiscan = device("multiscan", pattern_deg(-180, 1, 360, 16, 0.2, 60));
  multiscan.lowest_deg = -22.5;
  multiscan.layer_step_deg = 3;
  multiscan.offset_s = 1e-3;
  all.push_back(multiscan);
  Case lux = device("ibeo", pattern_deg(-59.875, 0.25, 440, 4, 0.3, 200));
  lux.lowest_deg = -1.2;
  lux.layer_step_deg = 0.8;
  lux.clockwise = true;
  lux.position_m = 0.015;
  all.push_back(lux);
  all.push_back(device("hokuyo", pattern_deg(-135, 0.25, 1081, 1, 0.1, 30)));
  all.back().stamp_s = all.back().offset_s = 0.08;  // it says milliseconds, and its own speed
  Case velodyne = device("vlp16", pattern_deg(-180, 0.2, 1800, 16, 0.5, 100));
  velodyne.lowest_deg = -15;
  velodyne.layer_step_deg = 2;
  velodyne.clockwise = true;
  velodyne.position_m = 0.03;  // the channels of a firing are not fired at once
  all.push_back(velodyne);
  Case ouster =
      device("ouster", pattern_deg(-180 + 0.9 * 360 / 1024, 360.0 / 1024, 1024, 16, 0.5, 100));
  ouster.lowest_deg = -15;
  ouster.layer_step_deg = 2;
  ouster.clockwise = true;
  all.push_back(ouster);
  for (const char* scheme : {"rplidar", "rplidar-express"}) {
    Case c = device(scheme, pattern_deg(-180, 0.9, 400, 1, 0.2, 12));
    c.clockwise = true;
    c.has_clock = false;
    // Turns of the express scan begin at angle 0, those of the simulation at 180 degrees.
    c.least_share = c.scheme == "rplidar" ? 1 : 0.4;
    all.push_back(c);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Devices, ::testing::ValuesIn(cases()));

TEST(KnownDevices, HaveNamesOfTheirOwn) {
  for (const Device& a : devices()) {
    EXPECT_EQ(std::ranges::count(devices(), a.scheme, &Device::scheme), 1) << a.scheme;
    EXPECT_TRUE(find_device(a.scheme));
  }
  const auto unknown = find_device("sonar");
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, ::testing::HasSubstr("vlp16"));
}

}  // namespace
}  // namespace scanfuse::drivers
