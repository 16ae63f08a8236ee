#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "scanfuse/drivers/device.hpp"

namespace scanfuse::fuzzing {

/// Gives the bytes to a device's driver in datagrams of so many bytes, or in pieces of a length
/// that the first byte tells, and its simulator the same as a request. Every coordinate and time
/// must be finite.
inline int drive(const char* scheme, const std::uint8_t* data, std::size_t size,
                 std::size_t datagram = 0) {
  if (size < 2 || size > 65536) return 0;
  const auto device = drivers::find_device(scheme);
  if (!device) std::abort();
  const auto driver = (*device)->make_driver({"lidar", ""});
  (void)driver->hello();
  const drivers::ByteView all(reinterpret_cast<const std::byte*>(data + 1), size - 1);
  const std::size_t piece = datagram > 0 ? datagram : 1 + 8U * data[0];
  drivers::Output out;
  Time received = time_from_nanos(1'700'000'000'000'000'000);
  for (std::size_t at = 0; at < all.size(); at += piece) {
    driver->take(all.subspan(at, std::min(piece, all.size() - at)), received, out);
    received += std::chrono::milliseconds(20);
  }
  driver->finish(out);
  driver->lost();
  for (const Scan& scan : out.scans) {
    for (const Return& r : scan.returns) {
      if (!std::isfinite(r.squared_range()) || !std::isfinite(r.z_m) ||
          !std::isfinite(r.time_offset_s) || !std::isfinite(r.intensity)) {
        std::abort();
      }
    }
  }
  (void)(*device)->make_simulator()->answer(all.first(std::min<std::size_t>(all.size(), 4096)));
  return 0;
}

}  // namespace scanfuse::fuzzing
