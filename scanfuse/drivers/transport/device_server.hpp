#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/transport/scan_queue.hpp"
#include "scanfuse/drivers/transport/wire.hpp"

namespace scanfuse::drivers {

/// Serves a simulated device in a thread of its own: over TCP to as many clients as come (16 at
/// most), over UDP to one address, or on a pseudo terminal. Clients that do not read lose scans.
class DeviceServer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<DeviceServer>> open(const SensorUrl& url);
  ~DeviceServer();
  DeviceServer(const DeviceServer&) = delete;
  DeviceServer& operator=(const DeviceServer&) = delete;

  /// Sends a scan whose first beam is fired at `begins`; its telegrams leave when their last beam
  /// has been. Returns at once.
  void publish(const Scan& scan, SteadyTime begins);

  /// Faults, for tests: bytes of no telegram to every client, all connections ended, the next
  /// `count` telegrams cut in half or left out.
  void send_garbage(ByteView bytes);
  void hang_up();
  void cut_short(int count);
  void leave_out(int count);

  [[nodiscard]] int port() const { return port_; }
  /// Of a serial device: what a driver opens.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Where drivers find it: "sick://127.0.0.1:2112".
  [[nodiscard]] std::string address() const;
  /// Clients that are connected and have asked for scans.
  [[nodiscard]] int listeners() const;

 private:
  struct Due {
    SteadyTime when;
    Bytes bytes;
  };
  struct Client {
    Descriptor socket;
    std::unique_ptr<DeviceSimulator> device;
    std::deque<Due> due;
    Bytes unsent;
    bool gone = false;
  };

  DeviceServer(SensorUrl url, Descriptor socket);
  Result<void> set_up();
  void run(const std::stop_token& stop);
  void wait_for_work();
  void accept_client();
  void listen_to(Client& client) const;
  void send_due(Client& client, SteadyTime now);
  void push(Client& client, ByteView bytes) const;
  void damage(Bytes& bytes);

  SensorUrl url_;
  Descriptor socket_;  ///< that listens (TCP), or of a pseudo terminal's other side, held open
  std::string path_;
  int port_ = 0;
  WakeUp wake_;
  mutable std::mutex mutex_;  ///< of what follows
  std::list<Client> clients_;
  int to_cut_ = 0, to_leave_out_ = 0;
  std::jthread thread_;  ///< last: stops before the rest goes
};

}  // namespace scanfuse::drivers
