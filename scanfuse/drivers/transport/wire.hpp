#pragma once

#include <chrono>
#include <span>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/bytes.hpp"
#include "scanfuse/drivers/transport/descriptor.hpp"
#include "scanfuse/drivers/transport/sensor_url.hpp"

namespace scanfuse::drivers {

using Milliseconds = std::chrono::milliseconds;

/// A connection to a device: a TCP connection, a UDP port that it sends to, or a serial line.
class Wire {
 public:
  /// Connects, and gives up after `patience` or when woken. Errors name the address and the reason.
  [[nodiscard]] static Result<Wire> connect(const SensorUrl& url, Milliseconds patience,
                                            const WakeUp& wake);

  /// The next bytes of the stream, or one datagram, as many as fit `into`. 0: none came within
  /// `patience`, or it was woken. An error: the connection is over.
  [[nodiscard]] Result<std::size_t> read(std::span<std::byte> into, Milliseconds patience,
                                         const WakeUp& wake) const;
  /// Sends all of it, or fails: a device that takes no request for a second is as good as gone.
  [[nodiscard]] Result<void> write(ByteView bytes) const;

 private:
  explicit Wire(Descriptor descriptor, Link link)
      : descriptor_(std::move(descriptor)), link_(link) {}
  Descriptor descriptor_;
  Link link_ = Link::kTcp;
};

/// A socket that listens for connections (TCP) or sends to `url` (UDP); for simulated devices.
[[nodiscard]] Result<Descriptor> listen_at(const SensorUrl& url);
[[nodiscard]] Result<Descriptor> send_to(const SensorUrl& url);
/// The port that a socket has got.
[[nodiscard]] int port_of(const Descriptor& socket);

}  // namespace scanfuse::drivers
