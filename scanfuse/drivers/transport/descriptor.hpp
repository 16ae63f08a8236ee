#pragma once

#include <utility>

namespace scanfuse::drivers {

/// A file descriptor that is closed with its owner. -1: none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor();
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool is_open() const { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

/// Ends another thread's wait: that one polls `get()` for reading.
class WakeUp {
 public:
  WakeUp();
  void call() const;   ///< from any thread
  void clear() const;  ///< by the thread that was woken
  [[nodiscard]] int get() const { return event_.get(); }

 private:
  Descriptor event_;
};

}  // namespace scanfuse::drivers
