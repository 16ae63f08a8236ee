// A stand-in for a ROS 2 node, of another vendor's DDS (Fast DDS, what ROS 2 itself uses by
// default) and with another vendor's serialiser (Fast CDR): publishes the scans of a passing car on
// /scan, listens to /scanfuse/tracks, and says at the end what it heard, as one JSON object. Usage:
// ros2_peer SECONDS; ROS_DOMAIN_ID holds; on loopback only.
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastcdr::Cdr;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Header {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::string frame_id;
};

struct LaserScan {
  Header header;
  float angle_min = 0, angle_max = 0, angle_increment = 0, time_increment = 0, scan_time = 0;
  float range_min = 0, range_max = 0;
  std::vector<float> ranges, intensities;
};

struct Pose {
  std::array<double, 3> position{};
  std::array<double, 4> orientation{};
};

struct Detection {
  Header header;
  std::string class_id;
  double score = 0;
  Pose pose, centre;
  std::array<double, 36> covariance{};
  std::array<double, 3> size{};
  std::string id;
};

struct Detections {
  Header header;
  std::vector<Detection> detections;
};

void write(Cdr& cdr, const LaserScan& scan) {
  cdr << scan.header.sec << scan.header.nanosec << scan.header.frame_id;
  cdr << scan.angle_min << scan.angle_max << scan.angle_increment << scan.time_increment;
  cdr << scan.scan_time << scan.range_min << scan.range_max << scan.ranges << scan.intensities;
}
void read(Cdr&, LaserScan&) {}

void read(Cdr& cdr, Header& header) { cdr >> header.sec >> header.nanosec >> header.frame_id; }
void read(Cdr& cdr, Pose& pose) { cdr >> pose.position >> pose.orientation; }
void read(Cdr& cdr, Detections& all) {
  read(cdr, all.header);
  std::uint32_t count = 0;
  cdr >> count;
  for (std::uint32_t i = 0; i < count; ++i) {
    Detection one;
    read(cdr, one.header);
    std::uint32_t hypotheses = 0;
    cdr >> hypotheses;
    for (std::uint32_t k = 0; k < hypotheses; ++k) {
      cdr >> one.class_id >> one.score;
      read(cdr, one.pose);
      cdr >> one.covariance;
    }
    read(cdr, one.centre);
    cdr >> one.size >> one.id;
    all.detections.push_back(one);
  }
}
void write(Cdr&, const Detections&) {}

template <class T>
class MessageType final : public fdds::TopicDataType {
 public:
  explicit MessageType(const char* name) {
    setName(name);
    m_typeSize = 1 << 20;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    payload->encapsulation = CDR_LE;
    cdr.serialize_encapsulation();
    write(cdr, *static_cast<const T*>(data));
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    auto& message = *static_cast<T*>(data);
    message = {};
    read(cdr, message);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return std::uint32_t{1 << 20}; };
  }
  void* createData() override { return new T; }
  void deleteData(void* data) override { delete static_cast<T*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

/// A car that passes the scanner from left to right, 8 m in front of it.
struct Car {
  double speed_m_per_s = 6, length_m = 4.4, width_m = 1.8;
  [[nodiscard]] std::array<double, 2> centre(double t) const { return {8, 18 - speed_m_per_s * t}; }
};

/// Where the ray meets the car's box; beyond 30 m: nowhere.
double range_at(const Car& car, double t, double angle) {
  const auto [x, y] = car.centre(t);
  const std::array<double, 2> way{std::cos(angle), std::sin(angle)};
  const std::array<double, 2> low{x - car.width_m / 2, y - car.length_m / 2};
  const std::array<double, 2> high{x + car.width_m / 2, y + car.length_m / 2};
  double enter = 0, leave = 1e9;
  for (std::size_t i = 0; i < 2; ++i) {
    const double a = low[i] / way[i], b = high[i] / way[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave && enter > 0 ? enter : std::numeric_limits<double>::infinity();
}

LaserScan scan_at(const Car& car, double t, std::chrono::system_clock::time_point now) {
  constexpr int kBeams = 541;
  constexpr double kStep = 0.5 * kPi / 180;
  LaserScan scan;
  const auto since = now.time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since);
  scan.header.sec = static_cast<std::int32_t>(seconds.count());
  scan.header.nanosec = static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(since - seconds).count());
  scan.header.frame_id = "laser";
  scan.angle_min = static_cast<float>(-135 * kPi / 180);
  scan.angle_max = -scan.angle_min;
  scan.angle_increment = static_cast<float>(kStep);
  scan.scan_time = 0.05F;
  scan.range_min = 0.1F;
  scan.range_max = 30;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = -135 * kPi / 180 + i * kStep;
    scan.ranges.push_back(static_cast<float>(range_at(car, t, angle)));
  }
  return scan;
}

fdds::DomainParticipant* join() {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  fdds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  rtps::Locator_t loopback;
  rtps::IPLocator::setIPv4(loopback, 127, 0, 0, 1);
  qos.wire_protocol().builtin.initialPeersList.push_back(loopback);
  return fdds::DomainParticipantFactory::get_instance()->create_participant(
      text == nullptr ? 0 : static_cast<std::uint32_t>(std::atoi(text)), qos);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  fdds::DomainParticipant* participant = join();
  if (participant == nullptr) return 1;
  const fdds::TypeSupport scan_type(
      new MessageType<LaserScan>("sensor_msgs::msg::dds_::LaserScan_"));
  const fdds::TypeSupport tracks_type(
      new MessageType<Detections>("vision_msgs::msg::dds_::Detection3DArray_"));
  scan_type.register_type(participant);
  tracks_type.register_type(participant);
  auto* scan_topic =
      participant->create_topic("rt/scan", scan_type.get_type_name(), fdds::TOPIC_QOS_DEFAULT);
  auto* tracks_topic = participant->create_topic("rt/scanfuse/tracks", tracks_type.get_type_name(),
                                                 fdds::TOPIC_QOS_DEFAULT);
  fdds::DataWriterQos writer_qos;
  writer_qos.reliability().kind = fdds::BEST_EFFORT_RELIABILITY_QOS;  // as sensors do
  writer_qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  auto* writer = participant->create_publisher(fdds::PUBLISHER_QOS_DEFAULT)
                     ->create_datawriter(scan_topic, writer_qos);
  fdds::DataReaderQos reader_qos;
  reader_qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;  // as nodes do
  reader_qos.history().depth = 10;
  reader_qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  auto* reader = participant->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT)
                     ->create_datareader(tracks_topic, reader_qos);

  const Car car;
  constexpr double kPassS = 6;  // then it comes again
  const auto start = std::chrono::system_clock::now();
  int sent = 0, arrays = 0, objects = 0;
  double worst_m = 0;
  Detections heard;
  Detection last;
  for (double t = 0; t < seconds; t = 0.05 * ++sent) {
    const auto at = start + std::chrono::microseconds(static_cast<std::int64_t>(1e6 * t));
    std::this_thread::sleep_until(at);
    LaserScan scan = scan_at(car, std::fmod(t, kPassS), at);
    writer->write(&scan);
    fdds::SampleInfo info;
    while (reader->take_next_sample(&heard, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      ++arrays;
      const auto stamp =
          std::chrono::seconds(heard.header.sec) + std::chrono::nanoseconds(heard.header.nanosec);
      const double then = std::fmod(
          std::chrono::duration<double>(stamp - start.time_since_epoch()).count(), kPassS);
      objects += static_cast<int>(heard.detections.size());
      // While it passes in full view; tracks of the pass before may still coast elsewhere.
      if (then < 1.5 || then > 4.5 || heard.detections.empty()) continue;
      const auto [x, y] = car.centre(then);
      const auto distance_m = [at_x = x, at_y = y](const Detection& one) {
        return std::hypot(one.centre.position[0] - at_x, one.centre.position[1] - at_y);
      };
      last = *std::min_element(
          heard.detections.begin(), heard.detections.end(),
          [&](const auto& a, const auto& b) { return distance_m(a) < distance_m(b); });
      worst_m = std::max(worst_m, distance_m(last));
    }
  }
  std::printf(
      "{\"sent\": %d, \"arrays\": %d, \"objects\": %d, \"worst_m\": %.3f, \"frame\": \"%s\", "
      "\"id\": \"%s\", \"class\": \"%s\", \"score\": %.3f, \"length_m\": %.3f, "
      "\"covariance_xx\": %.6f}\n",
      sent, arrays, objects, worst_m, last.header.frame_id.c_str(), last.id.c_str(),
      last.class_id.c_str(), last.score, last.size[0], last.covariance[0]);
  participant->delete_contained_entities();
  fdds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  return 0;
}
