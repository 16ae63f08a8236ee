#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scanfuse::testing {

/// A client that writes what it is told, byte by byte, so that tests can break every rule.
class RawClient {
 public:
  explicit RawClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    timeval limit{5, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&place), sizeof(place)) == 0;
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  [[nodiscard]] bool connected() const { return connected_; }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto done = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (done <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
  }

  /// Until the text is in what was read, or the other side closes.
  std::string read_until(std::string_view text) {
    while (read_.find(text) == read_.npos && more()) {
    }
    return read_;
  }

  /// The head and body of one answer.
  std::string get(std::string_view target, std::string_view headers = "Host: localhost\r\n",
                  std::string_view method = "GET") {
    write(std::string(method) + " " + std::string(target) + " HTTP/1.1\r\n" + std::string(headers) +
          "Connection: close\r\n\r\n");
    while (more()) {
    }
    return read_;
  }

  /// The answer to a websocket handshake; what follows stays to be read.
  std::string upgrade(std::string_view headers = "Host: localhost\r\n",
                      std::string_view target = "/ws",
                      std::string_view protocol = "scanfuse.viewer.v1") {
    write("GET " + std::string(target) +
          " HTTP/1.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
          "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: " +
          std::string(protocol) + "\r\n" + std::string(headers) + "\r\n");
    const std::string all = read_until("\r\n\r\n");
    const auto end = all.find("\r\n\r\n");
    read_ = end == all.npos ? "" : all.substr(end + 4);
    return all.substr(0, end);
  }

  /// A whole masked frame; `opcode` 1 is text.
  void send_frame(std::string_view payload, int opcode = 1) {
    std::string frame(1, static_cast<char>(0x80 | opcode));
    if (payload.size() < 126) {
      frame += static_cast<char>(0x80 | payload.size());
    } else {
      const bool is_long = payload.size() > 0xffff;  // the shortest form, as RFC 6455 wants it
      frame += static_cast<char>(0x80 | (is_long ? 127 : 126));
      for (int shift = is_long ? 56 : 8; shift >= 0; shift -= 8) {
        frame += static_cast<char>(static_cast<std::uint64_t>(payload.size()) >> shift & 0xff);
      }
    }
    frame.append(4, '\0');  // a mask of zeros
    frame += payload;
    write(frame);
  }

  struct Frame {
    int opcode = 0;
    std::string payload;
  };
  /// The next frame; nothing when the connection ends.
  std::optional<Frame> next_frame() {
    const auto need = [&](std::size_t size) {
      while (read_.size() < size && more()) {
      }
      return read_.size() >= size;
    };
    if (!need(2)) return std::nullopt;
    std::size_t head = 2;
    std::uint64_t size = static_cast<unsigned char>(read_[1]) & 0x7fU;
    const int extra = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (!need(head + static_cast<std::size_t>(extra))) return std::nullopt;
    if (extra > 0) size = 0;
    for (int i = 0; i < extra; ++i) size = size << 8U | static_cast<unsigned char>(read_[head++]);
    if (!need(head + size)) return std::nullopt;
    Frame frame{read_[0] & 0x0f, read_.substr(head, size)};
    read_.erase(0, head + size);
    return frame;
  }

  /// The next text that holds `wanted`; others are passed over.
  std::string next_text(std::string_view wanted) {
    while (auto frame = next_frame()) {
      if (frame->opcode == 1 && frame->payload.find(wanted) != std::string::npos) {
        return frame->payload;
      }
    }
    return "";
  }
  /// The next binary message of a kind; others are passed over.
  std::string next_binary(std::uint8_t kind) {
    while (auto frame = next_frame()) {
      if (frame->opcode == 2 && !frame->payload.empty() &&
          static_cast<std::uint8_t>(frame->payload[0]) == kind) {
        return frame->payload;
      }
    }
    return "";
  }

 private:
  bool more() {
    char buffer[4096];
    const auto got = ::recv(socket_, buffer, sizeof(buffer), 0);
    if (got <= 0) return false;
    read_.append(buffer, static_cast<std::size_t>(got));
    return true;
  }

  int socket_;
  bool connected_ = false;
  std::string read_;
};

}  // namespace scanfuse::testing
