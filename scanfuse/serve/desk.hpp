#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "scanfuse/serve/labels.hpp"
#include "scanfuse/serve/server.hpp"
#include "scanfuse/serve/workbench.hpp"

namespace scanfuse::serve {

/// Answers the pages: takes their requests in order, on a thread of its own, so that the server's
/// is never kept waiting. A client may have 64 requests waiting; past that its oldest is dropped.
class Desk {
 public:
  /// `send` may be called from the desk's thread at once.
  Desk(Workbench& bench, Labels& labels, std::function<void(ClientId, Message)> send);
  ~Desk();
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  // From the server's thread.
  void open(ClientId client);
  void receive(ClientId client, std::string text);
  void close(ClientId client);

 private:
  struct Waiting {
    ClientId client = 0;
    std::string text;
  };
  struct Reply;
  void loop();
  void answer(ClientId client, const std::string& text);
  void tell_status();

  Workbench& bench_;
  Labels& labels_;
  std::function<void(ClientId, Message)> send_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<Waiting> waiting_;
  std::map<ClientId, bool> clients_;  ///< whether it was greeted
  bool stopping_ = false;
  std::string last_status_;
  std::chrono::steady_clock::time_point last_told_;
  std::thread thread_;
};

}  // namespace scanfuse::serve
