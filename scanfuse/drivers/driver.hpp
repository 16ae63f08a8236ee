#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/drivers/bytes.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::drivers {

/// What a driver makes of bytes.
struct Output {
  std::vector<Scan> scans;
  Bytes reply;  ///< to send to the device
};

/// Speaks one device's protocol, without a socket: bytes in, scans and replies out. The same
/// bytes, receptions and calls give the same scans, whatever pieces a stream comes in.
/// Scans are in the device's frame by REP-103, stamps UTC by the device's own clock where it has
/// one (`ClockMap`). Garbage is passed over and counted in `diagnostics`, never trusted.
class Driver {
 public:
  virtual ~Driver() = default;
  /// What to send once connected.
  [[nodiscard]] virtual Bytes hello() { return {}; }
  /// The next piece of a stream, or one datagram, received at `received`.
  virtual void take(ByteView bytes, Time received, Output& out) = 0;
  /// The connection ended: half a telegram will not be completed.
  virtual void lost() = 0;
  /// A recording ended: what was waiting for more is given as it is.
  virtual void finish(Output& out) { (void)out; }
  /// What to send before hanging up.
  [[nodiscard]] virtual Bytes farewell() { return {}; }
  [[nodiscard]] virtual const Diagnostics& diagnostics() const = 0;
};

/// A telegram of a stream, or a datagram, and when it leaves the device.
struct Telegram {
  Bytes bytes;
  double after_s = 0;  ///< after the scan's stamp
};

/// Plays a device: answers requests, and says scans in its protocol. One for each connection.
class DeviceSimulator {
 public:
  virtual ~DeviceSimulator() = default;
  /// The next piece of what a client sent; the answer to it, maybe empty.
  [[nodiscard]] virtual Bytes answer(ByteView request) = 0;
  /// Whether a client has asked for scans, or the device sends them unasked.
  [[nodiscard]] virtual bool is_streaming() const = 0;
  /// A scan as the device sends it, in order of time. The device's clock says `scan.stamp` at the
  /// first beam. Ranges, angles and times are rounded to what the protocol can
  /// say; returns it cannot say are left out.
  [[nodiscard]] virtual std::vector<Telegram> encode(const Scan& scan) = 0;
};

/// How a driver is told about its device.
struct DriverOptions {
  std::string sensor = "scan";  ///< name of the sensor, and of its topic
  std::string metadata;         ///< Ouster: the sensor's own description in JSON
};

}  // namespace scanfuse::drivers
