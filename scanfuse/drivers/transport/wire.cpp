#include "scanfuse/drivers/transport/wire.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace scanfuse::drivers {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

std::string place(const SensorUrl& url) {
  return url.path.empty() ? fmt::format("{}:{}", url.host, url.port) : url.path;
}

tl::unexpected<Error> failed(const SensorUrl& url, std::string_view what, int reason) {
  return fail(Error::Code::kNotFound, "{}: {} ({})", place(url), what, std::strerror(reason));
}

Result<Addresses> resolve(const SensorUrl& url, bool passive) {
  addrinfo hints{};
  hints.ai_socktype = url.device->link == Link::kUdp ? SOCK_DGRAM : SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV | (passive ? AI_PASSIVE : 0);
  addrinfo* found = nullptr;
  const int error =
      ::getaddrinfo(url.host.c_str(), std::to_string(url.port).c_str(), &hints, &found);
  if (error != 0) {
    return fail(Error::Code::kNotFound, "{}: no such host ({})", place(url), ::gai_strerror(error));
  }
  return Addresses(found, &::freeaddrinfo);
}

Descriptor socket_for(const addrinfo& address) {
  return Descriptor(::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                             address.ai_protocol));
}

void set(const Descriptor& socket, int level, int option, int value) {
  // An option that cannot be set costs speed, not service.
  (void)::setsockopt(socket.get(), level, option, &value, sizeof value);
}

/// Waits for the descriptor; false when the time is over or the wake-up was called.
bool wait(int fd, short events, Milliseconds patience, const WakeUp* wake) {
  std::array<pollfd, 2> all{{{fd, events, 0}, {wake != nullptr ? wake->get() : -1, POLLIN, 0}}};
  const int ready = ::poll(all.data(), all.size(), static_cast<int>(patience.count()));
  return ready > 0 && all[0].revents != 0 && all[1].revents == 0;
}

Result<Descriptor> connect_tcp(const SensorUrl& url, Milliseconds patience, const WakeUp& wake) {
  const auto addresses = resolve(url, false);
  if (!addresses) return tl::unexpected(addresses.error());
  int reason = ECONNREFUSED;
  for (const addrinfo* at = addresses->get(); at != nullptr; at = at->ai_next) {
    Descriptor socket = socket_for(*at);
    if (!socket.is_open()) continue;
    set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
    if (::connect(socket.get(), at->ai_addr, at->ai_addrlen) == 0) return socket;
    reason = errno;
    if (reason != EINPROGRESS) continue;
    if (!wait(socket.get(), POLLOUT, patience, &wake)) return failed(url, "no answer", ETIMEDOUT);
    socklen_t size = sizeof reason;
    ::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &reason, &size);
    if (reason == 0) return socket;
  }
  return failed(url, "cannot connect", reason);
}

Result<Descriptor> bind_udp(const SensorUrl& url) {
  const auto addresses = resolve(url, true);
  if (!addresses) return tl::unexpected(addresses.error());
  const addrinfo& at = **addresses;
  Descriptor socket = socket_for(at);
  if (!socket.is_open()) return failed(url, "cannot open a socket", errno);
  set(socket, SOL_SOCKET, SO_RCVBUF, 8 << 20);
  set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  if (::bind(socket.get(), at.ai_addr, at.ai_addrlen) != 0) {
    return failed(url, "cannot listen there; is it an address of this machine?", errno);
  }
  return socket;
}

speed_t speed_of(const std::string& baud) {
  for (const auto& [name, speed] :
       {std::pair{"9600", B9600}, std::pair{"19200", B19200}, std::pair{"57600", B57600},
        std::pair{"115200", B115200}, std::pair{"230400", B230400}, std::pair{"460800", B460800},
        std::pair{"1000000", B1000000}}) {
    if (baud == name) return speed;
  }
  return B0;
}

Result<Descriptor> open_serial(const SensorUrl& url) {
  const auto asked = url.query.find("baud");
  const speed_t speed = speed_of(asked == url.query.end() ? "115200" : asked->second);
  if (speed == B0) return failed(url, "baud is one of 9600 to 1000000, as termios has it", EINVAL);
  Descriptor line(::open(url.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!line.is_open()) return failed(url, "cannot be opened", errno);
  termios settings{};
  if (::tcgetattr(line.get(), &settings) != 0) return failed(url, "is no serial line", errno);
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  if (::tcsetattr(line.get(), TCSANOW, &settings) != 0) {
    return failed(url, "cannot be set up", errno);
  }
  // The motor of an RPLidar A1 turns while DTR is off; pseudo terminals have none.
  int dtr = TIOCM_DTR;
  (void)::ioctl(line.get(), TIOCMBIC, &dtr);
  return line;
}

}  // namespace

Result<Wire> Wire::connect(const SensorUrl& url, Milliseconds patience, const WakeUp& wake) {
  const Link link = url.device->link;
  auto descriptor = link == Link::kTcp   ? connect_tcp(url, patience, wake)
                    : link == Link::kUdp ? bind_udp(url)
                                         : open_serial(url);
  if (!descriptor) return tl::unexpected(descriptor.error());
  return Wire(std::move(*descriptor), link);
}

Result<std::size_t> Wire::read(std::span<std::byte> into, Milliseconds patience,
                               const WakeUp& wake) const {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const ssize_t got = ::read(descriptor_.get(), into.data(), into.size());
    if (got > 0) return static_cast<std::size_t>(got);
    if (got == 0 && link_ == Link::kUdp) return std::size_t{0};
    if (got == 0) return fail(Error::Code::kNotFound, "the device closed the connection");
    if (errno != EAGAIN && errno != EINTR) {
      return fail(Error::Code::kNotFound, "the connection broke ({})", std::strerror(errno));
    }
    if (attempt == 0 && !wait(descriptor_.get(), POLLIN, patience, &wake)) break;
  }
  return std::size_t{0};
}

Result<void> Wire::write(ByteView bytes) const {
  while (!bytes.empty() && link_ != Link::kUdp) {
    const ssize_t sent = link_ == Link::kTcp
                             ? ::send(descriptor_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL)
                             : ::write(descriptor_.get(), bytes.data(), bytes.size());
    if (sent > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if ((errno != EAGAIN && errno != EINTR) ||
               !wait(descriptor_.get(), POLLOUT, Milliseconds(1000), nullptr)) {
      return fail(Error::Code::kNotFound, "the device takes no requests ({})",
                  std::strerror(errno));
    }
  }
  return {};
}

Result<Descriptor> listen_at(const SensorUrl& url) {
  const auto addresses = resolve(url, true);
  if (!addresses) return tl::unexpected(addresses.error());
  const addrinfo& at = **addresses;
  Descriptor socket = socket_for(at);
  if (!socket.is_open()) return failed(url, "cannot open a socket", errno);
  set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  if (::bind(socket.get(), at.ai_addr, at.ai_addrlen) != 0 || ::listen(socket.get(), 8) != 0) {
    return failed(url, "cannot listen there; is the port taken?", errno);
  }
  return socket;
}

Result<Descriptor> send_to(const SensorUrl& url) {
  const auto addresses = resolve(url, false);
  if (!addresses) return tl::unexpected(addresses.error());
  const addrinfo& at = **addresses;
  Descriptor socket = socket_for(at);
  if (!socket.is_open()) return failed(url, "cannot open a socket", errno);
  set(socket, SOL_SOCKET, SO_SNDBUF, 8 << 20);
  if (::connect(socket.get(), at.ai_addr, at.ai_addrlen) != 0) {
    return failed(url, "cannot send there", errno);
  }
  return socket;
}

int port_of(const Descriptor& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  std::array<char, 8> port{};
  if (::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
      ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, nullptr, 0, port.data(),
                    port.size(), NI_NUMERICSERV) != 0) {
    return 0;
  }
  return std::atoi(port.data());
}

}  // namespace scanfuse::drivers
