#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "scanfuse/io/mcap/scene.hpp"
#include "scanfuse/serve/foxglove_messages.hpp"
#include "scanfuse/serve/server.hpp"
#include "scanfuse/serve/workbench.hpp"

namespace scanfuse::serve {

/// Shows the same recording to Foxglove and Lichtblick: from the first subscription on it is played
/// at its own speed, over and over; what runs live is passed on as it comes. Channels: a cloud for
/// each sensor, /tf, /scanfuse/markers, /diagnostics (CDR, ros2msg) and /scanfuse/scene (JSON).
class FoxgloveDesk {
 public:
  FoxgloveDesk(const Workbench& bench, std::function<void(ClientId, Message)> send);
  ~FoxgloveDesk();
  FoxgloveDesk(const FoxgloveDesk&) = delete;
  FoxgloveDesk& operator=(const FoxgloveDesk&) = delete;

  // From the server's thread.
  void open(ClientId client);
  void receive(ClientId client, std::string text);
  void close(ClientId client);

 private:
  struct Client {
    bool greeted = false;
    std::size_t channels_told = 0;
    std::map<std::uint32_t, std::uint32_t> channel_of;  ///< by subscription
    std::vector<std::string> unread;
  };
  void loop();
  /// Says what is new to clients and hears what they said; whether anybody listens.
  bool attend();
  void hear(ClientId id, Client& client, const std::string& text);
  void update_channels();
  /// Whether the next frame is due.
  bool is_due();
  void publish(std::uint32_t frame);
  void publish_to(std::uint32_t channel, Time stamp, std::string_view payload, bool newest_wins);
  [[nodiscard]] std::string diagnostics_payload(Time stamp) const;

  const Workbench& bench_;
  std::function<void(ClientId, Message)> send_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::map<ClientId, Client> clients_;
  bool stopping_ = false;

  // Of the thread alone.
  std::vector<FoxgloveChannel> channels_;
  std::vector<std::uint32_t> sensor_channels_;  ///< by the sensor's number
  io::mcap::SceneBuilder scene_{"world"};
  std::uint32_t next_ = 0;  ///< frame
  std::chrono::steady_clock::time_point started_;
  double started_at_s_ = 0;
  std::thread thread_;
};

}  // namespace scanfuse::serve
