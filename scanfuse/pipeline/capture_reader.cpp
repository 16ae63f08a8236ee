#include "scanfuse/pipeline/capture_reader.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <vector>

#include "scanfuse/drivers/device.hpp"
#include "scanfuse/io/pcap/payload_reader.hpp"

namespace scanfuse::pipeline {
namespace {

using drivers::Device;
using io::pcap::Flow;
using io::pcap::Payload;
using io::pcap::PayloadReader;
using io::pcap::Protocol;

bool is_capture_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  auto source = io::open_bytes(path);
  if (!source) return false;
  const auto start = io::read_start(**source, 8);
  return start && io::pcap::is_capture(*start);
}

bool fits(const Device& device, const Flow& flow) {
  if (device.link == drivers::Link::kTcp) {
    return flow.protocol == Protocol::kTcp && flow.from.port == device.port;
  }
  return device.link == drivers::Link::kUdp && flow.protocol == Protocol::kUdp &&
         flow.to.port == device.port;
}

/// Which device speaks in a flow; none: not a sensor's.
const Device* device_of(const CaptureOptions& options, const Flow& flow) {
  for (const Device& device : drivers::devices()) {
    if (!options.device.empty() && device.scheme != options.device) continue;
    if (fits(device, flow)) return &device;
  }
  return nullptr;
}

/// The sensors of a capture, in the order of their first words.
struct Speakers {
  std::vector<std::pair<std::string, const Device*>> by_address;

  const Device* find(const std::string& address) const {
    const auto found = std::ranges::find(by_address, address, [](auto& s) { return s.first; });
    return found == by_address.end() ? nullptr : found->second;
  }
  [[nodiscard]] std::string name(const std::string& address) const {
    const Device* device = find(address);
    const auto alike = std::ranges::count(by_address, device, [](auto& s) { return s.second; });
    std::string name(device->scheme);
    return alike > 1 ? name + "@" + address : name;
  }
};

class CaptureReader final : public io::RecordingReader {
 public:
  CaptureReader(const std::filesystem::path& path, PayloadReader payloads, Speakers speakers,
                io::OpenOptions open, CaptureOptions options)
      : payloads_(std::move(payloads)),
        speakers_(std::move(speakers)),
        open_(std::move(open)),
        options_(std::move(options)) {
    info_.path = path;
    info_.format = payloads_.format();
    info_.compression = "none";
    for (const auto& [address, device] : speakers_.by_address) {
      const std::string name = speakers_.name(address);
      info_.topics.push_back(
          {name, "packets of " + std::string(device->scheme), "packets", 0, false, true, true});
      drivers::DriverOptions driver{name, options_.metadata};
      drivers_[address] = device->make_driver(driver);
    }
  }

  const io::RecordingInfo& info() const override { return info_; }

  Result<std::optional<io::Event>> next() override {
    while (ready_.empty() && !at_end_) read_one();
    if (ready_.empty()) return std::nullopt;
    io::Event event = std::move(ready_.front());
    ready_.pop_front();
    return event;
  }
  const Diagnostics& diagnostics() const override {
    diagnostics_ = all_diagnostics();
    return diagnostics_;
  }

 private:
  void read_one() {
    const auto payload = payloads_.next();
    if (!payload) {
      at_end_ = true;
      for (auto& [address, driver] : drivers_) {
        drivers::Output out;
        driver->finish(out);
        emit(out, last_time_);
      }
      return;
    }
    const Device* device = speakers_.find(payload->flow.from.address);
    if (device == nullptr || device_of(options_, payload->flow) != device) return;
    auto& driver = *drivers_[payload->flow.from.address];
    if (payload->after_gap || payload->start) driver.lost();
    last_time_ = payload->time;
    drivers::Output out;
    driver.take(payload->bytes, payload->time, out);
    emit(out, payload->time);
  }

  void emit(drivers::Output& out, Time time) {
    for (Scan& scan : out.scans) {
      const auto& wanted = open_.topics;
      if (!wanted.empty() && std::ranges::find(wanted, scan.sensor) == wanted.end()) continue;
      std::string topic = scan.sensor;
      ready_.push_back({time, std::move(topic), std::move(scan)});
    }
  }

  [[nodiscard]] Diagnostics all_diagnostics() const {
    Diagnostics all = payloads_.diagnostics();
    for (const auto& [address, driver] : drivers_) all.merge(driver->diagnostics());
    return all;
  }

  PayloadReader payloads_;
  Speakers speakers_;
  io::OpenOptions open_;
  CaptureOptions options_;
  io::RecordingInfo info_;
  std::map<std::string, std::unique_ptr<drivers::Driver>> drivers_;
  std::deque<io::Event> ready_;
  Time last_time_;
  bool at_end_ = false;
  mutable Diagnostics diagnostics_;
};

/// Who the sensors are. The first 20 000 payloads tell.
Result<Speakers> find_speakers(const std::filesystem::path& path, const CaptureOptions& options) {
  auto packets = io::pcap::PacketReader::open(path);
  if (!packets) return tl::unexpected(packets.error());
  PayloadReader payloads(std::move(*packets));
  Speakers speakers;
  for (int i = 0; i < 20'000; ++i) {
    const auto payload = payloads.next();
    if (!payload) break;
    const Device* device = device_of(options, payload->flow);
    const std::string& address = payload->flow.from.address;
    if (device == nullptr || speakers.find(address) != nullptr) continue;
    speakers.by_address.emplace_back(address, device);
  }
  if (!speakers.by_address.empty()) return speakers;
  return fail(Error::Code::kUnsupported,
              "{}: a capture without packets from or to the port of a known device{}",
              path.string(), options.device.empty() ? "" : " '" + options.device + "'");
}

}  // namespace

Result<std::unique_ptr<io::RecordingReader>> open_any_recording(const std::filesystem::path& path,
                                                                const io::OpenOptions& open,
                                                                const CaptureOptions& capture) {
  if (!is_capture_file(path)) return io::open_recording(path, open);
  if (!capture.device.empty()) {
    if (auto known = drivers::find_device(capture.device); !known) {
      return tl::unexpected(known.error());
    }
  }
  auto speakers = find_speakers(path, capture);
  if (!speakers) return tl::unexpected(speakers.error());
  auto packets = io::pcap::PacketReader::open(path);
  if (!packets) return tl::unexpected(packets.error());
  return std::make_unique<CaptureReader>(path, PayloadReader(std::move(*packets)),
                                         std::move(*speakers), open, capture);
}

}  // namespace scanfuse::pipeline
