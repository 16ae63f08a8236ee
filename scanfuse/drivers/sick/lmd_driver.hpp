#pragma once

#include <memory>

#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/sick/lmd_scandata.hpp"

namespace scanfuse::drivers::sick {

/// The returns of a scan telegram, in the device's frame by REP-103: the device's 90 degrees are
/// straight ahead, a layer angle is positive downwards [Sick2020]. Echo e is channel DIST<e+1>,
/// its intensity RSSI<e+1>. Raw values below 16 are codes for "no echo". `layer` is left at 0.
[[nodiscard]] std::vector<Return> returns_of(const LmdScan& scan);

/// The beams of a scan telegram, as one layer; empty without a distance channel.
[[nodiscard]] std::optional<BeamPattern> beams_of(const LmdScan& scan);

/// LMS1xx, LMS5xx, TiM5xx, TiM7xx and MRS1000 over TCP, port 2112. A scan has all layers of a
/// revolution; which there are is known after the first. Asks for scans in dialect B, after a
/// connection without an answer in dialect A, and so on; understands both at any time.
[[nodiscard]] std::unique_ptr<Driver> make_lmd_driver(const DriverOptions& options);
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_lmd_simulator();

}  // namespace scanfuse::drivers::sick
