#include "scanfuse/classify/recognizer.hpp"

#include "scanfuse/classify/vehicle_box.hpp"
#include "scanfuse/classify/vehicle_rules.hpp"

namespace scanfuse::classify {
namespace {

double score_by_method(const Outline& outline, const RecognizerOptions& options) {
  if (options.method == Method::kLu2018) return is_vehicle_lu2018(outline, options) ? 1 : 0;
  return vehicle_score(outline, options);
}

/// Between a pole and a car: pedestrians, cyclists, motorcycles. What they are is left open.
bool is_small_user(const Outline& outline, const RecognizerOptions& options) {
  return outline.points >= options.min_points && outline.box.length_m >= options.min_user_m &&
         outline.box.length_m <= options.max_width_m && outline.box.width_m <= options.min_width_m;
}

}  // namespace

Recognizer::Recognizer(const RecognizerOptions& options) : options_(options) {}

std::span<const Detection> Recognizer::operator()(std::span<const Outline> outlines) {
  detections_.clear();
  for (const Outline& outline : outlines) add(outline);
  return detections_;
}

void Recognizer::add(const Outline& outline) {
  const double score = score_by_method(outline, options_);
  if (score >= options_.min_score && score > 0) {
    detections_.push_back(complete_vehicle(outline, options_));
    detections_.back().score = score;
  } else if (options_.keep == Keep::kRoadUsers && is_small_user(outline, options_)) {
    detections_.push_back(as_seen(outline));
    detections_.back().object_class = ObjectClass::kUnknown;
    detections_.back().score = 0.5;
  }
}

}  // namespace scanfuse::classify
