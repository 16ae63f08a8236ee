#include "scanfuse/classify/recognizer.hpp"

#include <algorithm>

#include "scanfuse/classify/class_model.hpp"
#include "scanfuse/classify/features.hpp"
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
  return outline.expected >= 0 && options.method != Method::kLu2018 &&
         options.method != Method::kGuoIntervals && outline.points >= options.min_points &&
         outline.inlier_share >= options.min_expected_inlier_share &&
         outline.box.length_m <= options.max_length_m + options.size_slack_m &&
         outline.box.width_m <= options.max_width_m + options.size_slack_m;
}

/// Scenes differ from those learned from: where the rules see a vehicle, one in ten is theirs to
/// say.
ClassProbabilities heed_rules(ClassProbabilities p) {
  constexpr double kRules = 0.1;
  for (double& value : p) value *= 1 - kRules;
  p[static_cast<std::size_t>(ObjectClass::kVehicle)] += kRules;
  return p;
}

/// The likeliest road user of the three.
ObjectClass likeliest_user(const ClassProbabilities& p) {
  const auto first = p.begin() + static_cast<int>(ObjectClass::kVehicle);
  const auto best = std::max_element(first, p.begin() + static_cast<int>(ObjectClass::kOther));
  return static_cast<ObjectClass>(best - p.begin());
}

}  // namespace

Recognizer::Recognizer(const RecognizerOptions& options) : options_(options) {
  const bool learned =
      options_.method == Method::kSoftmax || options_.method == Method::kGuoIntervals;
  if (learned && !options_.model) options_.method = Method::kScore;
}

std::span<const Detection> Recognizer::operator()(std::span<const Outline> outlines) {
  detections_.clear();
  sources_.clear();
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (options_.method == Method::kSoftmax) {
      add_by_softmax(outlines, i);
    } else if (options_.method == Method::kGuoIntervals) {
      add_by_intervals(outlines[i]);
    } else {
      add(outlines[i]);
    }
    sources_.resize(detections_.size(), static_cast<std::uint32_t>(i));
  }
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

void Recognizer::add_as(const Outline& outline, ObjectClass kind, double score) {
  if (options_.keep == Keep::kVehicles && kind != ObjectClass::kVehicle) return;
  const bool vehicle = kind == ObjectClass::kVehicle;
  detections_.push_back(vehicle ? complete_vehicle(outline, options_) : as_seen(outline));
  detections_.back().object_class = kind;
  detections_.back().score = score;
}

void Recognizer::add_by_softmax(std::span<const Outline> outlines, std::size_t of) {
  const Outline& outline = outlines[of];
  if (outline.points < options_.min_points) return;
  const double by_rules = vehicle_score(outline, options_);
  auto p = options_.model->softmax(features_of(outlines, of, by_rules, scale_));
  const bool expected = is_expected_vehicle(outline, options_);
  if (expected || by_rules >= options_.min_score) p = heed_rules(p);
  const double other = p[static_cast<std::size_t>(ObjectClass::kOther)];
  if (!expected && other > options_.max_other_probability) return;
  const ObjectClass kind = expected ? ObjectClass::kVehicle : likeliest_user(p);
  const std::size_t before = detections_.size();
  add_as(outline, kind, std::max(1 - other, expected ? kLeastExpectedScore : 0.0));
  if (detections_.size() > before) {
    detections_.back().class_probability = p;
    detections_.back().cues = cues_of(outline, scale_);
  }
}

void Recognizer::add_by_intervals(const Outline& outline) {
  if (outline.points < options_.min_points) return;
  const auto kind = class_by_intervals(outline, options_.model->intervals, scale_);
  if (kind) add_as(outline, *kind, 1);
}

}  // namespace scanfuse::classify
