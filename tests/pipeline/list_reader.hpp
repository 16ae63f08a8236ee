#pragma once

#include <vector>

#include "scanfuse/io/recording.hpp"

namespace scanfuse::pipeline {

inline Time at(double seconds) { return time_from_seconds(1000 + seconds); }

/// Plays a list of events.
class ListReader final : public io::RecordingReader {
 public:
  explicit ListReader(std::vector<io::Event> events, std::vector<io::TopicInfo> topics = {})
      : events_(std::move(events)) {
    info_.topics = std::move(topics);
  }
  const io::RecordingInfo& info() const override { return info_; }
  Result<std::optional<io::Event>> next() override {
    if (place_ == events_.size()) return std::nullopt;
    return events_[place_++];
  }
  const Diagnostics& diagnostics() const override { return diagnostics_; }

 private:
  io::RecordingInfo info_;
  Diagnostics diagnostics_;
  std::vector<io::Event> events_;
  std::size_t place_ = 0;
};

}  // namespace scanfuse::pipeline
