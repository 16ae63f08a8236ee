#include "scanfuse/serve/scan_source.hpp"

#include <algorithm>

namespace scanfuse::serve {

Result<std::optional<pipeline::PosedScan>> RecordedScans::next() {
  while (true) {
    auto posed = feed_.next();
    if (!posed || !*posed || sensors_.empty()) return posed;
    if (std::ranges::find(sensors_, (*posed)->scan.sensor) != sensors_.end()) return posed;
  }
}

}  // namespace scanfuse::serve
