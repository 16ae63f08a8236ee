#pragma once

#include "scanfuse/pipeline/scan_feed.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::pipeline {

/// Every length and speed times `factor`; times, angles and probabilities stay. A model car of 1:10
/// seen through factor 10 looks and moves as a real one, so one set of options serves both.
[[nodiscard]] PosedScan scaled(PosedScan posed, double factor);
[[nodiscard]] Detection scaled(Detection detection, double factor);
[[nodiscard]] Track scaled(Track track, double factor);
[[nodiscard]] VirtualScan scaled(VirtualScan scan, double factor);

}  // namespace scanfuse::pipeline
