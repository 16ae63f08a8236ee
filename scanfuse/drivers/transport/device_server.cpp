#include "scanfuse/drivers/transport/device_server.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

namespace scanfuse::drivers {
namespace {

constexpr std::size_t kMostUnsent = std::size_t{4} << 20;
constexpr std::size_t kMostClients = 16;
constexpr std::size_t kMostDue = 4096;

struct Terminal {
  Descriptor master, slave;
  std::string path;
};

/// The slave side is held open, so that the line lives on while no driver has it.
Result<Terminal> open_terminal() {
  Terminal terminal;
  terminal.master = Descriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  std::array<char, 128> name{};
  const int fd = terminal.master.get();
  if (fd < 0 || ::grantpt(fd) != 0 || ::unlockpt(fd) != 0 ||
      ::ptsname_r(fd, name.data(), name.size()) != 0) {
    return fail(Error::Code::kNotFound, "no pseudo terminal to be had ({})", std::strerror(errno));
  }
  terminal.path = name.data();
  terminal.slave = Descriptor(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  if (::tcgetattr(terminal.slave.get(), &settings) == 0) {
    ::cfmakeraw(&settings);
    ::tcsetattr(terminal.slave.get(), TCSANOW, &settings);
  }
  return terminal;
}

}  // namespace

DeviceServer::DeviceServer(SensorUrl url, Descriptor socket)
    : url_(std::move(url)), socket_(std::move(socket)) {}

Result<void> DeviceServer::set_up() {
  if (url_.device->link == Link::kTcp) {
    port_ = port_of(socket_);
    return {};
  }
  Client client;
  client.device = url_.device->make_simulator();
  if (url_.device->link == Link::kUdp) {
    client.socket = std::exchange(socket_, Descriptor());
    port_ = url_.port;
  } else {
    auto terminal = open_terminal();
    if (!terminal) return tl::unexpected(terminal.error());
    client.socket = std::move(terminal->master);
    socket_ = std::move(terminal->slave);
    path_ = terminal->path;
    if (!url_.path.empty()) {
      if (::symlink(path_.c_str(), url_.path.c_str()) != 0) {
        return fail(Error::Code::kNotFound, "{}: cannot be made a link to {} ({})", url_.path,
                    path_, std::strerror(errno));
      }
      path_ = url_.path;
    }
  }
  clients_.push_back(std::move(client));
  return {};
}

Result<std::unique_ptr<DeviceServer>> DeviceServer::open(const SensorUrl& url) {
  Descriptor socket;
  if (url.device->link != Link::kSerial) {
    auto opened = url.device->link == Link::kTcp ? listen_at(url) : send_to(url);
    if (!opened) return tl::unexpected(opened.error());
    socket = std::move(*opened);
  }
  std::unique_ptr<DeviceServer> server(new DeviceServer(url, std::move(socket)));
  if (auto done = server->set_up(); !done) return tl::unexpected(done.error());
  server->thread_ = std::jthread([s = server.get()](const std::stop_token& stop) { s->run(stop); });
  return server;
}

DeviceServer::~DeviceServer() {
  thread_.request_stop();
  wake_.call();
  if (thread_.joinable()) thread_.join();
  if (url_.device->link == Link::kSerial && !url_.path.empty() && path_ == url_.path) {
    ::unlink(url_.path.c_str());
  }
}

std::string DeviceServer::address() const {
  if (url_.device->link == Link::kSerial) {
    return fmt::format("{}://{}", url_.device->scheme, path_);
  }
  return fmt::format("{}://{}:{}", url_.device->scheme, url_.host, port_);
}

int DeviceServer::listeners() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(std::ranges::count_if(
      clients_, [](const Client& c) { return !c.gone && c.device->is_streaming(); }));
}

void DeviceServer::publish(const Scan& scan, SteadyTime begins) {
  {
    const std::lock_guard lock(mutex_);
    for (Client& client : clients_) {
      if (client.gone || !client.device->is_streaming()) continue;
      for (Telegram& telegram : client.device->encode(scan)) {
        if (client.due.size() >= kMostDue) break;
        const auto after = duration_from_seconds(telegram.after_s);
        client.due.push_back({begins + after, std::move(telegram.bytes)});
      }
    }
  }
  wake_.call();
}

void DeviceServer::send_garbage(ByteView bytes) {
  {
    const std::lock_guard lock(mutex_);
    for (Client& client : clients_) push(client, bytes);
  }
  wake_.call();
}

void DeviceServer::hang_up() {
  {
    const std::lock_guard lock(mutex_);
    // The thread that polls their sockets is the one to close them.
    for (Client& client : clients_) client.gone = url_.device->link == Link::kTcp;
  }
  wake_.call();
}

void DeviceServer::cut_short(int count) {
  const std::lock_guard lock(mutex_);
  to_cut_ += count;
}

void DeviceServer::leave_out(int count) {
  const std::lock_guard lock(mutex_);
  to_leave_out_ += count;
}

void DeviceServer::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    wait_for_work();
    wake_.clear();
    if (url_.device->link == Link::kTcp) accept_client();
    const std::lock_guard lock(mutex_);
    const SteadyTime now = std::chrono::steady_clock::now();
    for (Client& client : clients_) {
      listen_to(client);
      send_due(client, now);
    }
    if (url_.device->link == Link::kTcp) {
      clients_.remove_if([](const Client& client) { return client.gone; });
    }
  }
}

/// Until a client says something or takes something, a telegram is due, or somebody calls.
void DeviceServer::wait_for_work() {
  std::vector<pollfd> all{{wake_.get(), POLLIN, 0}};
  if (url_.device->link == Link::kTcp) all.push_back({socket_.get(), POLLIN, 0});
  SteadyTime next = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  {
    const std::lock_guard lock(mutex_);
    for (const Client& client : clients_) {
      const short events = client.unsent.empty() ? POLLIN : POLLIN | POLLOUT;
      // An address where nobody listens answers with errors all the time.
      if (url_.device->link != Link::kUdp) all.push_back({client.socket.get(), events, 0});
      if (!client.due.empty()) next = std::min(next, client.due.front().when);
    }
  }
  const Duration left = std::max(Duration{0}, Duration(next - std::chrono::steady_clock::now()));
  const timespec patience{static_cast<time_t>(left.count() / 1'000'000'000),
                          static_cast<long>(left.count() % 1'000'000'000)};
  (void)::ppoll(all.data(), all.size(), &patience, nullptr);
}

void DeviceServer::accept_client() {
  while (true) {
    Descriptor socket(::accept4(socket_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.is_open()) return;
    const std::lock_guard lock(mutex_);
    if (clients_.size() >= kMostClients) return;
    Client client;
    client.socket = std::move(socket);
    client.device = url_.device->make_simulator();
    clients_.push_back(std::move(client));
  }
}

void DeviceServer::listen_to(Client& client) const {
  std::array<std::byte, 4096> buffer{};
  while (!client.gone) {
    const ssize_t got = ::read(client.socket.get(), buffer.data(), buffer.size());
    if (got > 0) {
      const Bytes answer =
          client.device->answer(ByteView(buffer).first(static_cast<std::size_t>(got)));
      push(client, answer);
      continue;
    }
    const bool may_come = got < 0 && (errno == EAGAIN || errno == EINTR);
    client.gone = !may_come && url_.device->link == Link::kTcp;
    return;
  }
}

void DeviceServer::damage(Bytes& bytes) {
  if (to_leave_out_ > 0) {
    --to_leave_out_;
    bytes.clear();
  } else if (to_cut_ > 0) {
    --to_cut_;
    bytes.resize(bytes.size() / 2);
  }
}

void DeviceServer::send_due(Client& client, SteadyTime now) {
  while (!client.due.empty() && client.due.front().when <= now) {
    Bytes bytes = std::move(client.due.front().bytes);
    client.due.pop_front();
    damage(bytes);
    push(client, bytes);
  }
  if (!client.unsent.empty()) push(client, {});
}

void DeviceServer::push(Client& client, ByteView bytes) const {
  if (client.gone) return;
  if (url_.device->link == Link::kUdp) {
    // Nobody listening there, or no room: such is UDP.
    if (!bytes.empty()) (void)::send(client.socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return;
  }
  if (client.unsent.size() + bytes.size() <= kMostUnsent) append(client.unsent, bytes);
  std::size_t sent = 0;
  while (sent < client.unsent.size()) {
    const ssize_t took = url_.device->link == Link::kTcp
                             ? ::send(client.socket.get(), client.unsent.data() + sent,
                                      client.unsent.size() - sent, MSG_NOSIGNAL)
                             : ::write(client.socket.get(), client.unsent.data() + sent,
                                       client.unsent.size() - sent);
    if (took > 0) {
      sent += static_cast<std::size_t>(took);
      continue;
    }
    client.gone = took < 0 && errno != EAGAIN && errno != EINTR && url_.device->link == Link::kTcp;
    break;
  }
  client.unsent.erase(client.unsent.begin(),
                      client.unsent.begin() + static_cast<std::ptrdiff_t>(sent));
}

}  // namespace scanfuse::drivers
