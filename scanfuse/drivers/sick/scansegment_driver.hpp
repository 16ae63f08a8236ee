#pragma once

#include <memory>

#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/sick/scansegment.hpp"

namespace scanfuse::drivers::sick {

/// multiScan and picoScan over UDP, port 2115, in the compact or the msgpack format. A scan has all
/// segments of a revolution; how many there are is known after the first. Layers are told apart by
/// their elevation, 0 is the lowest of those seen.
[[nodiscard]] std::unique_ptr<Driver> make_scansegment_driver(const DriverOptions& options);
/// Sends the compact format, a segment for each of 12 equal parts of a revolution.
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_scansegment_simulator();

}  // namespace scanfuse::drivers::sick
