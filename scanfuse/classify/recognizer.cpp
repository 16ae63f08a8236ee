#include "scanfuse/classify/recognizer.hpp"

#include <algorithm>

#include "scanfuse/classify/vehicle_box.hpp"
#include "scanfuse/classify/vehicle_rules.hpp"

namespace scanfuse::classify {
namespace {

constexpr double kLeastExpectedScore = 0.25;

double score_by_method(const Outline& outline, const RecognizerOptions& options) {
  if (options.method == Method::kLu2018) return is_vehicle_lu2018(outline, options) ? 1 : 0;
  return vehicle_score(outline, options);
}

/// Between a pole and a car: pedestrians, cyclists, motorcycles. What they are is left open.
bool is_small_user(const Outline& outline, const RecognizerOptions& options) {
  return outline.points >= options.min_points && outline.box.length_m >= options.min_user_m &&
         outline.box.length_m <= options.max_width_m && outline.box.width_m <= options.min_width_m;
}

/// A piece of a vehicle that a track expects here need not look like a whole one; it must only not
/// look like something else.
bool is_expected_vehicle(const Outline& outline, const RecognizerOptions& options) {
  return outline.expected >= 0 && options.method == Method::kScore &&
         outline.points >= options.min_points &&
         outline.inlier_share >= options.min_expected_inlier_share &&
         outline.box.length_m <= options.max_length_m + options.size_slack_m &&
         outline.box.width_m <= options.max_width_m + options.size_slack_m;
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
  if (is_expected_vehicle(outline, options_) && score < options_.min_score) {
    detections_.push_back(complete_vehicle(outline, options_));
    detections_.back().score = std::max(score, kLeastExpectedScore);
  } else if (score >= options_.min_score && score > 0) {
    detections_.push_back(complete_vehicle(outline, options_));
    detections_.back().score = score;
  } else if (options_.keep == Keep::kRoadUsers && is_small_user(outline, options_)) {
    detections_.push_back(as_seen(outline));
    detections_.back().object_class = ObjectClass::kUnknown;
    detections_.back().score = 0.5;
  }
}

}  // namespace scanfuse::classify
