#include "scanfuse/pipeline/live_reader.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace scanfuse::pipeline {
namespace {

/// "sick", "sick2", "sick3", ...
std::string free_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int i = 2; !taken.insert(name).second; ++i) name = wanted + std::to_string(i);
  return name;
}

}  // namespace

Result<std::unique_ptr<LiveReader>> LiveReader::create(std::vector<LiveSource> sources,
                                                       const LiveReaderOptions& options) {
  if (sources.empty()) return fail(Error::Code::kNotFound, "no sensor named");
  std::unique_ptr<LiveReader> reader(new LiveReader(options.scans_waiting));
  reader->info_.format = "live";
  std::set<std::string> taken;
  for (LiveSource& source : sources) {
    const std::string name = free_name(source.url.name(), taken);
    const std::string type = std::string(source.url.device->scheme) + " live";
    reader->info_.topics.push_back({name, type, "packets", 0, false, true, true});
    if (source.mount) reader->mounts_.push_back({{}, "base_link", name, *source.mount, true});
    const std::size_t index = reader->sensors_.size();
    reader->sensors_.push_back(std::make_unique<drivers::LiveSensor>(
        std::move(source.url), index, drivers::DriverOptions{name, source.metadata}, reader->queue_,
        options.connection));
  }
  return reader;
}

std::optional<io::Event> LiveReader::next_within(drivers::Milliseconds patience) {
  if (!std::exchange(mounted_, true) && !mounts_.empty()) {
    return io::Event{{}, "/tf_static", mounts_};
  }
  auto live = queue_.pop(patience);
  if (!live) return std::nullopt;
  last_byte_ = live->last_byte;
  if (sensors_.size() > 1) put_in_order(live->scan);
  std::string topic = live->scan.sensor;
  return io::Event{live->received, std::move(topic), std::move(live->scan)};
}

void LiveReader::put_in_order(Scan& scan) {
  float last_s = 0;
  for (const Return& r : scan.returns) last_s = std::max(last_s, r.time_offset_s);
  Time stamp = scan.stamp + duration_from_seconds(last_s);
  // A clock that was set back for good must not hold up everything: after a second it is followed.
  if (newest_ && stamp < *newest_ && *newest_ - stamp < std::chrono::seconds(1)) stamp = *newest_;
  newest_ = stamp;
  const auto later_s = static_cast<float>(to_seconds(stamp - scan.stamp));
  for (Return& r : scan.returns) r.time_offset_s -= later_s;
  scan.stamp = stamp;
}

std::vector<std::pair<std::string, drivers::SensorStatus>> LiveReader::status() const {
  std::vector<std::pair<std::string, drivers::SensorStatus>> all;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    all.emplace_back(info_.topics[i].name, sensors_[i]->status());
  }
  return all;
}

const Diagnostics& LiveReader::diagnostics() const {
  diagnostics_ = {};
  for (const auto& sensor : sensors_) diagnostics_.merge(sensor->status().diagnostics);
  return diagnostics_;
}

}  // namespace scanfuse::pipeline
