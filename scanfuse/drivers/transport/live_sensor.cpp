#include "scanfuse/drivers/transport/live_sensor.hpp"

#include <poll.h>

#include <algorithm>
#include <utility>

namespace scanfuse::drivers {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 17;
constexpr Milliseconds kReadPatience{200};

}  // namespace

LiveSensor::LiveSensor(SensorUrl url, std::size_t index, const DriverOptions& driver,
                       ScanQueue& queue, const LiveOptions& options)
    : url_(std::move(url)),
      index_(index),
      queue_(&queue),
      options_(options),
      driver_(url_.device->make_driver(driver)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

LiveSensor::~LiveSensor() {
  thread_.request_stop();
  wake_.call();
}

SensorStatus LiveSensor::status() const {
  const std::lock_guard lock(mutex_);
  SensorStatus status = status_;
  status.dropped = queue_->dropped(index_);
  status.diagnostics.merge(driver_->diagnostics());
  if (status.dropped > 0) {
    status.diagnostics.note("scan left out: a newer one came before it was tracked", url_.name(),
                            status.dropped);
  }
  return status;
}

void LiveSensor::note(std::string_view what, std::string_view where) {
  const std::lock_guard lock(mutex_);
  status_.diagnostics.note(what, where);
  status_.last_error = where;
}

void LiveSensor::sleep(Milliseconds time) const {
  pollfd wake{wake_.get(), POLLIN, 0};
  (void)::poll(&wake, 1, static_cast<int>(time.count()));
}

void LiveSensor::run(const std::stop_token& stop) {
  Milliseconds wait = options_.first_wait;
  while (!stop.stop_requested()) {
    auto wire = Wire::connect(url_, options_.connect_patience, wake_);
    if (stop.stop_requested()) break;
    if (!wire) {
      note("connection that did not come about", wire.error().message);
    } else if (read_from(*wire, stop)) {
      wait = options_.first_wait;
    }
    if (stop.stop_requested()) break;
    sleep(wait);
    wait = std::min(2 * wait, options_.longest_wait);
  }
}

bool LiveSensor::read_from(const Wire& wire, const std::stop_token& stop) {
  Bytes hello;
  std::int64_t scans_before = 0;
  {
    const std::lock_guard lock(mutex_);
    scans_before = status_.scans;
    if (status_.connections++ > 0) status_.diagnostics.note("connection made anew", url_.name());
    status_.connected = true;
    hello = driver_->hello();
  }
  Bytes buffer(kReadBytes);
  SteadyTime heard = std::chrono::steady_clock::now();
  std::string why;
  if (auto sent = wire.write(hello); !sent) why = sent.error().message;
  while (why.empty() && !stop.stop_requested()) {
    const auto got = wire.read(buffer, kReadPatience, wake_);
    if (!got) {
      why = got.error().message;
    } else if (*got > 0) {
      heard = std::chrono::steady_clock::now();
      if (!take(wire, ByteView(buffer).first(*got))) why = "the device takes no requests";
    } else if (std::chrono::steady_clock::now() - heard > options_.silence) {
      note("sensor fell silent", url_.name());
      why = "nothing came for a while";
    }
  }
  if (why.empty()) {
    say_goodbye(wire);
  } else {
    note("connection lost", fmt::format("{}: {}", url_.name(), why));
  }
  const std::lock_guard lock(mutex_);
  driver_->lost();
  status_.connected = false;
  return status_.scans > scans_before;
}

bool LiveSensor::take(const Wire& wire, ByteView bytes) {
  const SteadyTime last_byte = std::chrono::steady_clock::now();
  const Time received = std::chrono::system_clock::now();
  Output out;
  {
    const std::lock_guard lock(mutex_);
    status_.bytes += static_cast<std::int64_t>(bytes.size());
    driver_->take(bytes, received, out);
    status_.scans += static_cast<std::int64_t>(out.scans.size());
  }
  for (Scan& scan : out.scans) queue_->push({std::move(scan), received, last_byte, index_});
  return out.reply.empty() || wire.write(out.reply).has_value();
}

void LiveSensor::say_goodbye(const Wire& wire) {
  Bytes farewell;
  {
    const std::lock_guard lock(mutex_);
    farewell = driver_->farewell();
  }
  // Whoever does not hear it will see the connection end.
  (void)wire.write(farewell);
}

}  // namespace scanfuse::drivers
