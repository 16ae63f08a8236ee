#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <variant>

#include "scanfuse/io/ros/decode.hpp"
#include "scanfuse/io/ros/encode.hpp"

namespace {

using namespace scanfuse;

/// What every reader promises: all coordinates finite.
void check(const Scan& scan) {
  for (const auto& point : scan.returns) {
    const bool finite = std::isfinite(point.x_m) && std::isfinite(point.y_m) &&
                        std::isfinite(point.z_m) && std::isfinite(point.intensity) &&
                        std::isfinite(point.time_offset_s);
    if (!finite) std::abort();
  }
  (void)io::ros::encode_cdr(scan);
}

}  // namespace

/// The first byte chooses type and encoding, the rest is the message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kTypes{"sensor_msgs/LaserScan",
                              "sensor_msgs/MultiEchoLaserScan",
                              "sensor_msgs/PointCloud2",
                              "nav_msgs/Odometry",
                              "geometry_msgs/PoseStamped",
                              "geometry_msgs/PoseWithCovarianceStamped",
                              "sensor_msgs/Imu",
                              "tf2_msgs/TFMessage",
                              "tf/tfMessage",
                              "geometry_msgs/TransformStamped"};
  if (size == 0) return 0;
  const io::RawChannel channel{"/fuzz", kTypes[(data[0] & 0x7fU) % kTypes.size()],
                               (data[0] & 0x80U) != 0 ? "cdr" : "ros1", ""};
  const auto bytes = std::span(reinterpret_cast<const std::byte*>(data), size).subspan(1);
  const auto decoded = io::ros::decode_message(channel, bytes);
  if (!decoded) return 0;
  if (const auto* scan = std::get_if<Scan>(&decoded->payload)) check(*scan);
  return 0;
}
