#pragma once

#include <span>
#include <vector>

#include "scanfuse/classify/vehicle_options.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::classify {

/// Tells which outlines are vehicles and completes them to whole ones. In and out: the levelled
/// sensor frame, the sensor at its origin. Keeps its buffer between scans: one object per thread.
class Recognizer {
 public:
  explicit Recognizer(const RecognizerOptions& options = {});

  /// Detections in order of the outlines. Valid until the next call.
  [[nodiscard]] std::span<const Detection> operator()(std::span<const Outline> outlines);

 private:
  void add(const Outline& outline);

  RecognizerOptions options_;
  std::vector<Detection> detections_;
};

}  // namespace scanfuse::classify
