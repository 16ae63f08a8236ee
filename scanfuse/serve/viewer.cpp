#include "scanfuse/serve/viewer.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "scanfuse/serve/desk.hpp"
#include "scanfuse/serve/foxglove.hpp"
#include "scanfuse/serve/http_rules.hpp"

namespace scanfuse::serve {

/// The server calls the desk, the desk sends through the server: what the desk says before the
/// server stands waits for it.
struct Viewer::State {
  State(Workbench& bench, Labels& labels)
      : desk(bench, labels, sender()), foxglove(bench, sender()) {}
  ~State() {
    {
      const std::lock_guard lock(guard);
      stopping = true;
    }
    ready.notify_all();
    server.reset();  // first: it calls the desk
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void send(ClientId client, Message message) {
    std::unique_lock lock(guard);
    ready.wait(lock, [&] { return stopping || server; });
    if (!stopping) server->send(client, std::move(message));
  }

  [[nodiscard]] std::function<void(ClientId, Message)> sender() {
    return [this](ClientId client, Message message) { send(client, std::move(message)); };
  }

  /// Called on the server's thread; a client that names no protocol is taken for a page.
  [[nodiscard]] Handler handler() {
    return {[this](ClientId client, std::string_view protocol) {
              if (is_foxglove(protocol)) {
                foxglove_clients.insert(client);
                foxglove.open(client);
              } else {
                desk.open(client);
              }
            },
            [this](ClientId client, std::string message, bool binary) {
              if (binary) return;
              if (foxglove_clients.contains(client)) {
                foxglove.receive(client, std::move(message));
              } else {
                desk.receive(client, std::move(message));
              }
            },
            [this](ClientId client) {
              if (foxglove_clients.erase(client) > 0) {
                foxglove.close(client);
              } else {
                desk.close(client);
              }
            }};
  }

  std::mutex guard;
  std::condition_variable ready;
  bool stopping = false;
  std::optional<Server> server;
  std::set<ClientId> foxglove_clients;  ///< on the server's thread only
  Desk desk;
  FoxgloveDesk foxglove;
};

Viewer::Viewer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Viewer::Viewer(Viewer&&) noexcept = default;
Viewer& Viewer::operator=(Viewer&&) noexcept = default;
Viewer::~Viewer() = default;

Result<Viewer> Viewer::start(Workbench& bench, Labels& labels, const ServerOptions& options) {
  auto state = std::make_unique<State>(bench, labels);
  auto server = Server::start(options, state->handler());
  if (!server) return tl::unexpected(server.error());
  {
    const std::lock_guard lock(state->guard);
    state->server = std::move(*server);
  }
  state->ready.notify_all();
  return Viewer(std::move(state));
}

int Viewer::port() const { return state_->server->port(); }
ServerCounters Viewer::counters() const { return state_->server->counters(); }

}  // namespace scanfuse::serve
