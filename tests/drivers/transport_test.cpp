#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "drivers/sample_scans.hpp"
#include "scanfuse/drivers/stream.hpp"
#include "scanfuse/drivers/transport/device_server.hpp"
#include "scanfuse/drivers/transport/live_sensor.hpp"

// Sockets and threads: loopback only, ports as the system gives them.
namespace scanfuse::drivers {
namespace {

using drivers_testing::pattern_deg;
using drivers_testing::sample_scan;
using SteadyClock = std::chrono::steady_clock;
using std::chrono::milliseconds;

template <class Condition>
bool wait_until(Condition&& condition, milliseconds patience = milliseconds(8000)) {
  const auto end = SteadyClock::now() + patience;
  while (SteadyClock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return condition();
}

LiveOptions quick() {
  LiveOptions options;
  options.first_wait = milliseconds(10);
  options.longest_wait = milliseconds(80);
  options.silence = milliseconds(300);
  return options;
}

Scan next_scan(int i, const BeamPattern& beams = pattern_deg(-90, 1, 181, 1, 0.5, 20)) {
  Scan scan = sample_scan(beams, 0, 0, false, static_cast<std::uint64_t>(i) + 1, 0.01);
  scan.stamp = std::chrono::system_clock::now();
  scan.frame = i;
  return scan;
}

/// Serves, reads, and counts what came through.
class Chain {
 public:
  explicit Chain(const std::string& address, std::size_t waiting = 4) : queue_(waiting) {
    auto server = DeviceServer::open(*parse_serve_address(address));
    EXPECT_TRUE(server) << server.error().message;
    server_ = std::move(*server);
    auto url = parse_sensor_url(server_->address());
    EXPECT_TRUE(url) << url.error().message;
    sensor_ = std::make_unique<LiveSensor>(*url, 0, DriverOptions{"lidar", ""}, queue_, quick());
  }
  bool connect() {
    return wait_until([&] { return server_->listeners() > 0; });
  }
  void publish(const Scan& scan) { server_->publish(scan, SteadyClock::now()); }
  /// Publishes until `count` more scans came.
  bool carry(int count) {
    for (int i = 0; i < 400 && count > 0; ++i) {
      publish(next_scan(sent_++));
      while (queue_.pop(milliseconds(20))) --count;
    }
    return count <= 0;
  }
  DeviceServer& server() { return *server_; }
  ScanQueue& queue() { return queue_; }
  LiveSensor& sensor() { return *sensor_; }
  void stop_server() { server_.reset(); }
  void restart_server(const std::string& address) {
    auto server = DeviceServer::open(*parse_serve_address(address));
    ASSERT_TRUE(server) << server.error().message;
    server_ = std::move(*server);
  }

 private:
  ScanQueue queue_;
  std::unique_ptr<DeviceServer> server_;
  std::unique_ptr<LiveSensor> sensor_;
  int sent_ = 0;
};

TEST(ParallelTransport, CarriesScansOverTcp) {
  Chain chain("sick:0");
  ASSERT_TRUE(chain.connect());
  EXPECT_TRUE(chain.carry(20));
  const auto status = chain.sensor().status();
  EXPECT_TRUE(status.connected);
  EXPECT_EQ(status.connections, 1);
  EXPECT_FALSE(status.diagnostics.any_damage());
}

TEST(ParallelTransport, CarriesScansOverUdp) {
  // A port that is free now; another process may take it before it is used, hence some tries.
  for (int port = 47'311; port < 47'315; ++port) {
    Chain chain("multiscan:" + std::to_string(port));
    if (!chain.carry(5)) continue;
    SUCCEED();
    return;
  }
  FAIL();
}

TEST(ParallelTransport, CarriesScansOverAPseudoTerminal) {
  Chain chain("rplidar");
  ASSERT_TRUE(chain.connect());
  const auto beams = pattern_deg(-180, 0.9, 400, 1, 0.2, 12);
  int heard = 0;
  for (int i = 0; i < 200 && heard < 5; ++i) {
    chain.publish(next_scan(i, beams));
    while (chain.queue().pop(milliseconds(20))) ++heard;
  }
  EXPECT_GE(heard, 5);
}

TEST(ParallelTransport, ConnectsAgainWhenTheDeviceHangsUp) {
  Chain chain("sick:0");
  ASSERT_TRUE(chain.connect());
  ASSERT_TRUE(chain.carry(5));
  for (int i = 0; i < 3; ++i) {
    chain.server().hang_up();
    ASSERT_TRUE(chain.carry(5)) << i;
  }
  const auto status = chain.sensor().status();
  EXPECT_EQ(status.connections, 4);
  EXPECT_EQ(status.diagnostics.count("connection lost"), 3);
  EXPECT_EQ(status.diagnostics.count("connection made anew"), 3);
}

TEST(ParallelTransport, WaitsForADeviceThatRestarts) {
  Chain chain("sick:0");
  ASSERT_TRUE(chain.connect());
  ASSERT_TRUE(chain.carry(5));
  const std::string again = "sick:" + std::to_string(chain.server().port());
  chain.stop_server();
  ASSERT_TRUE(wait_until([&] {
    return chain.sensor().status().diagnostics.count("connection that did not come about") >= 2;
  }));
  chain.restart_server(again);
  EXPECT_TRUE(chain.connect());
  EXPECT_TRUE(chain.carry(5));
}

TEST(ParallelTransport, ConnectsAgainWhenTheDeviceFallsSilent) {
  Chain chain("sick:0");
  ASSERT_TRUE(chain.connect());
  ASSERT_TRUE(chain.carry(3));
  EXPECT_TRUE(wait_until(
      [&] { return chain.sensor().status().diagnostics.count("sensor fell silent") > 0; }));
  EXPECT_TRUE(chain.carry(3));
}

TEST(ParallelTransport, PassesOverGarbageAndHalfTelegrams) {
  Chain chain("sick:0");
  ASSERT_TRUE(chain.connect());
  ASSERT_TRUE(chain.carry(3));
  Bytes garbage;
  for (int i = 0; i < 500; ++i) garbage.push_back(static_cast<std::byte>(i * 7));
  chain.server().send_garbage(garbage);
  ASSERT_TRUE(chain.carry(3));
  chain.server().cut_short(2);
  ASSERT_TRUE(chain.carry(6));
  const auto status = chain.sensor().status();
  EXPECT_GE(status.diagnostics.count(StreamCutter::kGarbage), 500);
  EXPECT_GE(status.diagnostics.count("telegrams missing"), 1);
}

TEST(ParallelTransport, NeverWaitsForWhoDoesNotRead) {
  Chain chain("sick:0", 2);
  ASSERT_TRUE(chain.connect());
  for (int i = 0; i < 50; ++i) {
    chain.publish(next_scan(i));
    std::this_thread::sleep_for(milliseconds(4));
  }
  ASSERT_TRUE(wait_until([&] { return chain.sensor().status().scans >= 49; }));
  const auto status = chain.sensor().status();
  EXPECT_GE(status.dropped, 40);
  EXPECT_EQ(status.diagnostics.count("scan left out: a newer one came before it was tracked"),
            status.dropped);
  // The newest are there.
  auto first = chain.queue().pop(milliseconds(0));
  ASSERT_TRUE(first);
  EXPECT_GE(first->scan.frame, status.scans - 3);
}

TEST(ParallelScanQueue, LetsTheNewestOfEachSensorWin) {
  ScanQueue queue(2);
  for (int i = 0; i < 5; ++i) {
    LiveScan scan;
    scan.scan.frame = i;
    scan.sensor = i % 5 == 0 ? 1 : 0;
    queue.push(std::move(scan));
  }
  EXPECT_EQ(queue.dropped(0), 2);
  EXPECT_EQ(queue.dropped(1), 0);
  std::vector<std::int64_t> left;
  while (auto scan = queue.pop(milliseconds(0))) left.push_back(scan->scan.frame);
  EXPECT_THAT(left, ::testing::ElementsAre(0, 3, 4));
}

TEST(ParallelScanQueue, KeepsItsBoundUnderManyThreads) {
  ScanQueue queue(3);
  std::atomic<int> popped = 0;
  {
    std::vector<std::jthread> threads;
    for (std::size_t sensor = 0; sensor < 4; ++sensor) {
      threads.emplace_back([&queue, sensor] {
        for (int i = 0; i < 500; ++i) {
          LiveScan scan;
          scan.sensor = sensor;
          scan.scan.returns.resize(10);
          queue.push(std::move(scan));
        }
      });
    }
    threads.emplace_back([&] {
      while (queue.pop(milliseconds(50))) ++popped;
    });
  }
  std::int64_t dropped = 0;
  for (std::size_t sensor = 0; sensor < 4; ++sensor) dropped += queue.dropped(sensor);
  EXPECT_EQ(popped + dropped, 2000);
}

TEST(ParallelScanQueue, ReturnsAtOnceWhenClosed) {
  ScanQueue queue(1);
  std::jthread closer([&] { queue.close(); });
  EXPECT_FALSE(queue.pop(std::chrono::minutes(1)));
}

TEST(SensorUrl, IsTakenApart) {
  const auto url = parse_sensor_url("sick://192.168.0.7:2111?name=front&mount=1,2,0");
  ASSERT_TRUE(url) << url.error().message;
  EXPECT_EQ(url->host, "192.168.0.7");
  EXPECT_EQ(url->port, 2111);
  EXPECT_EQ(url->name(), "front");
  EXPECT_EQ(parse_sensor_url("vlp16://")->port, 2368);
  EXPECT_EQ(parse_sensor_url("vlp16://")->host, "0.0.0.0");
  EXPECT_EQ(parse_sensor_url("sick://[::1]:99")->host, "::1");
  EXPECT_EQ(parse_sensor_url("rplidar:///dev/ttyUSB0?baud=256000")->path, "/dev/ttyUSB0");
  EXPECT_EQ(parse_serve_address("sick:2112")->host, "127.0.0.1");
  EXPECT_EQ(parse_serve_address("ibeo:0.0.0.0:12002")->host, "0.0.0.0");
  EXPECT_EQ(parse_serve_address("ibeo")->port, 12002);
}

TEST(SensorUrl, SaysWhatIsWrong) {
  for (const auto& [text, why] :
       {std::pair{"192.168.0.1", "no scheme"}, std::pair{"sonar://x", "no device 'sonar'"},
        std::pair{"sick://x:99999", "no port"}, std::pair{"sick://x:1x", "no port"},
        std::pair{"sick://x/y", "no path"}, std::pair{"rplidar://ttyUSB0", "needs a path"},
        std::pair{"sick://x?nme=y", "did you mean 'name'"},
        std::pair{"sick://x?name", "key=value"}}) {
    const auto url = parse_sensor_url(text);
    ASSERT_FALSE(url) << text;
    EXPECT_THAT(url.error().message, ::testing::HasSubstr(why));
  }
}

}  // namespace
}  // namespace scanfuse::drivers
