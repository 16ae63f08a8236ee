#include "scanfuse/serve/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <thread>
#include <utility>

// After <utility>: Asio of Boost 1.74 forgets to include it.
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "scanfuse/serve/assets.hpp"
#include "scanfuse/serve/http_rules.hpp"

namespace scanfuse::serve {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
namespace net = boost::asio;
using tcp = net::ip::tcp;
using boost::system::error_code;
using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

constexpr auto kRequestTime = std::chrono::seconds(15);
constexpr int kPortsTried = 20;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }
beast::string_view view(std::string_view text) { return {text.data(), text.size()}; }

RequestHead head_of(const Request& request) {
  return {view(request.method_string()),      view(request.target()),
          view(request[http::field::host]),   view(request[http::field::origin]),
          view(request[http::field::cookie]), view(request[http::field::authorization])};
}

Response plain(const Request& request, int status, std::string_view text) {
  Response response(static_cast<http::status>(status), request.version());
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.body() = std::string(text) + "\n";
  return response;
}

Response page(const Request& request, const AccessRules& rules) {
  const RequestHead head = head_of(request);
  if (const Refusal no = check_request(rules, head); no.status != 0) {
    return plain(request, no.status, no.reason);
  }
  const auto asset = find_asset(path_of(head.target));
  if (!asset) return plain(request, 404, "no such page");
  Response response(http::status::ok, request.version());
  response.set(http::field::content_type, view(asset->content_type));
  response.set(http::field::content_encoding, "gzip");
  if (brings_token_in_query(rules, head)) {
    response.set(http::field::set_cookie,
                 "scanfuse_token=" + rules.token + "; HttpOnly; SameSite=Strict; Path=/");
  }
  response.body().assign(reinterpret_cast<const char*>(asset->gzip.data()), asset->gzip.size());
  return response;
}

/// What every answer says besides.
Response finished(const Request& request, Response response) {
  response.set("Content-Security-Policy", view(kContentSecurityPolicy));
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set(http::field::cache_control, "no-store");
  if (response.result() == http::status::method_not_allowed) {
    response.set(http::field::allow, "GET, HEAD");
  }
  response.keep_alive(request.keep_alive());
  response.prepare_payload();
  if (request.method() == http::verb::head) response.body().clear();
  return response;
}

}  // namespace

struct Server::State {
  class Connection;
  class Socket;

  State(ServerOptions o, Handler h) : options(std::move(o)), handler(std::move(h)) {}

  void accept();
  void join(const std::shared_ptr<Socket>& socket, std::string_view protocol);
  void leave(ClientId id);

  ServerOptions options;
  Handler handler;
  AccessRules rules;
  ClientId next_id = 1;  ///< this and `connections` on the io thread only
  int connections = 0;   ///< outlives `io`, whose connections count themselves out
  net::io_context io{1};
  tcp::acceptor acceptor{io};
  net::steady_timer pause{io};
  std::map<ClientId, std::shared_ptr<Socket>> sockets;  ///< on the io thread only
  std::atomic<std::uint64_t> refused{0}, replaced{0}, dropped{0};
  std::thread thread;
};

/// A websocket, from its handshake on.
class Server::State::Socket : public std::enable_shared_from_this<Socket> {
 public:
  Socket(tcp::socket socket, State& state, ClientId id)
      : stream_(std::move(socket)), state_(state), id_(id) {
    ++state_.connections;
  }
  ~Socket() { --state_.connections; }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void start(Request request) {
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.handshake_timeout = kRequestTime;
    timeout.idle_timeout = std::chrono::seconds(60);
    stream_.set_option(timeout);
    stream_.read_message_max(state_.options.max_message_bytes);
    stream_.auto_fragment(false);
    protocol_ = choose_protocol(view(request[http::field::sec_websocket_protocol]));
    stream_.set_option(websocket::stream_base::decorator([this](websocket::response_type& r) {
      if (!protocol_.empty())
        r.set(http::field::sec_websocket_protocol, view(std::string_view(protocol_)));
    }));
    request_ = std::move(request);
    stream_.async_accept(request_, [self = shared_from_this()](error_code error) {
      if (error) return;
      self->state_.join(self, self->protocol_);
      self->read();
    });
  }

  void send(Message message) {
    if (is_closing_) return;
    if (replace_waiting(message)) return;
    waiting_bytes_ += message.bytes.size();
    waiting_.push_back(std::move(message));
    if (waiting_bytes_ > state_.options.max_queue_bytes) {
      state_.dropped.fetch_add(1);
      return close();
    }
    if (waiting_.size() == 1) write();
  }

  /// Without the closing handshake: for clients that do not answer, and at the end.
  void close() {
    is_closing_ = true;
    error_code ignored;
    (void)beast::get_lowest_layer(stream_).socket().shutdown(tcp::socket::shutdown_both, ignored);
    (void)beast::get_lowest_layer(stream_).socket().close(ignored);
  }

  [[nodiscard]] ClientId id() const { return id_; }

 private:
  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->state_.leave(self->id_);
      auto& buffer = self->buffer_;
      self->state_.handler.received(self->id_, beast::buffers_to_string(buffer.data()),
                                    self->stream_.got_binary());
      buffer.consume(buffer.size());
      self->read();
    });
  }

  /// The first one is being written and stays.
  bool replace_waiting(Message& message) {
    if (message.slot == 0) return false;
    for (std::size_t i = 1; i < waiting_.size(); ++i) {
      if (waiting_[i].slot != message.slot) continue;
      waiting_bytes_ += message.bytes.size() - waiting_[i].bytes.size();
      waiting_[i] = std::move(message);
      state_.replaced.fetch_add(1);
      return true;
    }
    return false;
  }

  void write() {
    stream_.binary(waiting_.front().binary);
    stream_.async_write(net::buffer(waiting_.front().bytes),
                        [self = shared_from_this()](error_code error, std::size_t) {
                          if (error) return self->close();
                          self->waiting_bytes_ -= self->waiting_.front().bytes.size();
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) self->write();
                        });
  }

  websocket::stream<beast::tcp_stream> stream_;
  State& state_;
  ClientId id_;
  Request request_;
  std::string protocol_;
  beast::flat_buffer buffer_;
  std::deque<Message> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool is_closing_ = false;
};

/// A connection that speaks HTTP, until it asks to become a websocket.
class Server::State::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, State& state) : stream_(std::move(socket)), state_(state) {
    ++state_.connections;
  }
  ~Connection() { --state_.connections; }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(8192);
    parser_->body_limit(0);
    stream_.expires_after(kRequestTime);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (!error) self->handle(self->parser_->release());
                     });
  }

 private:
  void handle(Request request) {
    if (websocket::is_upgrade(request)) return upgrade(std::move(request));
    write(finished(request, page(request, state_.rules)));
  }

  void upgrade(Request request) {
    const Refusal no = check_websocket(state_.rules, head_of(request));
    if (no.status != 0) return write(finished(request, plain(request, no.status, no.reason)));
    if (static_cast<int>(state_.sockets.size()) >= state_.options.max_clients) {
      return write(finished(request, plain(request, 503, "too many clients are connected")));
    }
    stream_.expires_never();
    std::make_shared<Socket>(stream_.release_socket(), state_, state_.next_id++)
        ->start(std::move(request));
  }

  void write(Response response) {
    const bool keep_alive = response.keep_alive();
    const auto status = response.result_int();
    if (status == 401 || status == 403 || status == 503) state_.refused.fetch_add(1);
    response_ = std::move(response);
    stream_.expires_after(kRequestTime);
    http::async_write(stream_, response_,
                      [self = shared_from_this(), keep_alive](error_code error, std::size_t) {
                        if (error) return;
                        if (keep_alive) return self->read();
                        error_code ignored;
                        (void)self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                      });
  }

  beast::tcp_stream stream_;
  State& state_;
  beast::flat_buffer buffer_{16384};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Response response_;
};

void Server::State::accept() {
  acceptor.async_accept([this](error_code error, tcp::socket socket) {
    if (error == net::error::operation_aborted) return;
    if (error) {  // out of descriptors, most likely: try again a little later
      pause.expires_after(std::chrono::milliseconds(100));
      return pause.async_wait([this](error_code stopped) {
        if (!stopped) accept();
      });
    }
    if (connections < 4 * options.max_clients + 16) {
      (void)socket.set_option(tcp::no_delay(true), error);
      std::make_shared<Connection>(std::move(socket), *this)->read();
    } else {
      refused.fetch_add(1);  // closed as it goes out of scope
    }
    accept();
  });
}

void Server::State::join(const std::shared_ptr<Socket>& socket, std::string_view protocol) {
  sockets.emplace(socket->id(), socket);
  handler.opened(socket->id(), protocol);
}

void Server::State::leave(ClientId id) {
  const auto found = sockets.find(id);
  if (found == sockets.end()) return;
  found->second->close();
  sockets.erase(found);
  handler.closed(id);
}

namespace {

/// Binds to the port, or to one of those after it.
error_code listen(tcp::acceptor& acceptor, const net::ip::address& address,
                  const ServerOptions& options) {
  error_code error;
  const int tries = options.port != 0 && options.next_free_port ? kPortsTried : 1;
  for (int i = 0; i < tries && options.port + i < 65536; ++i) {
    const tcp::endpoint place(address, static_cast<unsigned short>(options.port + i));
    (void)acceptor.close(error);
    (void)acceptor.open(place.protocol(), error);
    if (error) return error;
    (void)acceptor.set_option(net::socket_base::reuse_address(true), error);
    (void)acceptor.bind(place, error);
    if (!error) (void)acceptor.listen(net::socket_base::max_listen_connections, error);
    if (error != net::error::address_in_use) return error;
  }
  return error;
}

}  // namespace

Result<Server> Server::start(const ServerOptions& options, Handler handler) {
  error_code error;
  const std::string numeric = options.address == "localhost" ? "127.0.0.1" : options.address;
  const auto address = net::ip::make_address(numeric, error);
  if (error) {
    return fail(Error::Code::kMalformed,
                "--listen {}: not a numeric address; 127.0.0.1 is this machine only, 0.0.0.0 all "
                "of its networks",
                options.address);
  }
  if (!address.is_loopback() && options.token.empty()) {
    return fail(Error::Code::kUnsupported, "--listen {}: outside loopback a token is needed",
                options.address);
  }
  auto state = std::make_unique<State>(options, std::move(handler));
  if (const auto failed = listen(state->acceptor, address, options); failed) {
    return fail(Error::Code::kUnsupported, "cannot listen on {}, port {}: {}; name another --port",
                options.address, options.port, failed.message());
  }
  const auto bound = state->acceptor.local_endpoint(error);
  state->rules = {address.is_loopback(), bound.port(), options.token, options.allowed_origins};
  state->accept();
  state->thread = std::thread([raw = state.get()] { raw->io.run(); });
  return Server(std::move(state));
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}
Server::Server(Server&&) noexcept = default;
Server& Server::operator=(Server&&) noexcept = default;

Server::~Server() {
  if (!state_) return;
  net::post(state_->io, [state = state_.get()] { state->io.stop(); });
  state_->thread.join();
  state_->sockets.clear();
}

int Server::port() const { return state_->rules.port; }

void Server::send(ClientId client, Message message) {
  net::post(state_->io, [state = state_.get(), client, message = std::move(message)]() mutable {
    const auto found = state->sockets.find(client);
    if (found != state->sockets.end()) found->second->send(std::move(message));
  });
}

ServerCounters Server::counters() const {
  return {state_->refused.load(), state_->replaced.load(), state_->dropped.load()};
}

}  // namespace scanfuse::serve
