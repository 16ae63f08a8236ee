#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/classify/vehicle_options.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::classify {

/// Tells what outlines are, and completes vehicles to whole ones. In and out: the levelled sensor
/// frame, the sensor at its origin. Keeps its buffers between scans: one object per thread.
class Recognizer {
 public:
  explicit Recognizer(const RecognizerOptions& options = {});

  /// Detections in order of the outlines. Valid until the next call.
  [[nodiscard]] std::span<const Detection> operator()(std::span<const Outline> outlines);

  /// Of which outline each of the last detections is.
  [[nodiscard]] std::span<const std::uint32_t> sources() const { return sources_; }

 private:
  void add(const Outline& outline);
  void add_by_softmax(std::span<const Outline> outlines, std::size_t of);
  void add_by_intervals(const Outline& outline);
  void add_as(const Outline& outline, ObjectClass kind, double score);

  RecognizerOptions options_;
  double scale_ = 1;
  std::vector<Detection> detections_;
  std::vector<std::uint32_t> sources_;
};

}  // namespace scanfuse::classify
