#pragma once

#include <map>
#include <optional>
#include <string>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/time.hpp"

namespace scanfuse::io {

/// Notes what is odd about the stamps of a stream: standing still, running backwards, leaping ahead
/// by more than ten seconds.
class StampWatch {
 public:
  void see(const std::string& stream, Time stamp, std::string_view where,
           Diagnostics& diagnostics) {
    auto& last = last_[stream];
    if (last && stamp == *last) diagnostics.note("equal stamps", where);
    if (last && stamp < *last) diagnostics.note("time runs backwards", where);
    if (last && to_nanos(stamp) / 2 - to_nanos(*last) / 2 > 5'000'000'000) {
      diagnostics.note("time jump of more than 10 s", where);
    }
    last = stamp;
  }

 private:
  std::map<std::string, std::optional<Time>> last_;
};

}  // namespace scanfuse::io
