#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::serve {

struct ServerOptions {
  std::string address = "127.0.0.1";  ///< numeric; anything but loopback needs a token
  int port = 8765;                    ///< 0: any that is free
  bool next_free_port = true;         ///< if the port is taken, one of the 20 after it
  std::string token;                  ///< empty: none is needed
  std::vector<std::string> allowed_origins;
  int max_clients = 16;                        ///< connections, of both kinds
  std::size_t max_message_bytes = 1 << 16;     ///< of a client; a longer one closes its connection
  std::size_t max_queue_bytes = 64ULL << 20U;  ///< to a client; see Message::slot
};

/// One connected websocket; never used again once closed.
using ClientId = std::uint64_t;

/// What the server sends.
struct Message {
  std::string bytes;
  bool binary = false;
  /// A message that still waits is replaced by the next with the same slot: newest wins. 0: is
  /// never replaced; a client whose queue of such messages grows past `max_queue_bytes` is closed.
  std::uint32_t slot = 0;
};

/// Called on the server's own thread; must not block.
struct Handler {
  std::function<void(ClientId, std::string_view protocol)> opened;
  std::function<void(ClientId, std::string message, bool binary)> received;
  std::function<void(ClientId)> closed;
};

/// Counted since the start.
struct ServerCounters {
  std::uint64_t refused = 0;   ///< requests by the rules of http_rules.hpp, and clients too many
  std::uint64_t replaced = 0;  ///< messages that a newer one replaced before they were sent
  std::uint64_t dropped = 0;   ///< clients closed because they did not keep up
};

/// Serves the embedded page over HTTP and websockets beside it, on one thread of its own.
/// A client that sends nothing sensible, too much, or too slowly harms none but itself.
class Server {
 public:
  /// Listens before it returns. An address that is not numeric or not loopback without a token, or
  /// a port that is taken, is an error.
  [[nodiscard]] static Result<Server> start(const ServerOptions& options, Handler handler);
  Server(Server&&) noexcept;
  Server& operator=(Server&&) noexcept;
  /// Closes all connections and joins the thread; the handler is not called afterwards.
  ~Server();

  [[nodiscard]] int port() const;
  /// From any thread; messages to a client that is gone are dropped.
  void send(ClientId client, Message message);
  [[nodiscard]] ServerCounters counters() const;

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scanfuse::serve
