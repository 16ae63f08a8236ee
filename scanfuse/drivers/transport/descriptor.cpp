#include "scanfuse/drivers/transport/descriptor.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>

namespace scanfuse::drivers {

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

WakeUp::WakeUp() : event_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

void WakeUp::call() const {
  const std::uint64_t one = 1;
  // Fails only where the counter is full: then the wait has ended already.
  if (::write(event_.get(), &one, sizeof one) < 0) return;
}

void WakeUp::clear() const {
  std::uint64_t count = 0;
  if (::read(event_.get(), &count, sizeof count) < 0) return;
}

}  // namespace scanfuse::drivers
