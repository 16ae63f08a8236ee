#include "scanfuse/drivers/device.hpp"

#include <array>
#include <string>

#include "scanfuse/drivers/hokuyo/scip.hpp"
#include "scanfuse/drivers/ibeo/lux.hpp"
#include "scanfuse/drivers/ouster/ouster.hpp"
#include "scanfuse/drivers/rplidar/rplidar.hpp"
#include "scanfuse/drivers/sick/lmd_driver.hpp"
#include "scanfuse/drivers/sick/scansegment_driver.hpp"
#include "scanfuse/drivers/velodyne/vlp16.hpp"

namespace scanfuse::drivers {
namespace {

constexpr auto kDevices = std::to_array<Device>({
    {"sick", "SICK LMS1xx, LMS5xx, TiM5xx, TiM7xx, MRS1000: scan telegrams over TCP", Link::kTcp,
     2112, &sick::make_lmd_driver, &sick::make_lmd_simulator},
    {"multiscan", "SICK multiScan, picoScan: segments, compact or msgpack, over UDP", Link::kUdp,
     2115, &sick::make_scansegment_driver, &sick::make_scansegment_simulator},
    {"ibeo", "ibeo LUX, LD-MRS: scan data over TCP", Link::kTcp, 12002, &ibeo::make_lux_driver,
     &ibeo::make_lux_simulator},
    {"hokuyo", "Hokuyo: SCIP 2.2 over TCP", Link::kTcp, 10940, &hokuyo::make_scip_driver,
     &hokuyo::make_scip_simulator},
    {"vlp16", "Velodyne VLP-16 over UDP", Link::kUdp, 2368, &velodyne::make_vlp16_driver,
     &velodyne::make_vlp16_simulator},
    {"ouster", "Ouster, profile LEGACY, over UDP; ?metadata=FILE.json", Link::kUdp, 7502,
     &ouster::make_ouster_driver, &ouster::make_ouster_simulator},
    {"rplidar", "RPLidar, standard scan over a serial line; ?baud=115200", Link::kSerial, 0,
     &rplidar::make_rplidar_driver, &rplidar::make_rplidar_simulator},
    {"rplidar-express", "RPLidar, express scan over a serial line", Link::kSerial, 0,
     &rplidar::make_express_driver, &rplidar::make_rplidar_simulator},
});

}  // namespace

std::span<const Device> devices() { return kDevices; }

Result<const Device*> find_device(std::string_view scheme) {
  std::string known;
  for (const Device& device : kDevices) {
    if (device.scheme == scheme) return &device;
    known += (known.empty() ? "" : ", ") + std::string(device.scheme);
  }
  return fail(Error::Code::kNotFound, "no device '{}'; known are {}", scheme, known);
}

}  // namespace scanfuse::drivers
