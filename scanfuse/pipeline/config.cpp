#include "scanfuse/pipeline/config.hpp"

#include <algorithm>

#include "scanfuse/pipeline/classes.hpp"

namespace scanfuse::pipeline {

std::vector<OptionView> view_config(const PerceptionOptions& options) {
  std::vector<OptionView> all;
  for_each_section(options, [&](std::string_view section, const auto& part) {
    const auto views = view_options(section, part);
    all.insert(all.end(), views.begin(), views.end());
  });
  return all;
}

Result<void> set_config(PerceptionOptions& options, std::string_view section, std::string_view name,
                        std::string_view value) {
  Result<void> outcome;
  bool found = false;
  std::vector<std::string> sections;
  for_each_section(options, [&](std::string_view known, auto& part) {
    sections.emplace_back(known);
    if (known != section) return;
    found = true;
    outcome = set_option(part, name, value);
  });
  if (!found) {
    return fail(Error::Code::kNotFound, "unknown section '{}'; did you mean '{}'?", section,
                nearest_name(section, sections));
  }
  if (!outcome) return fail(outcome.error().code, "{}.{}", section, outcome.error().message);
  if (section == "classify" && (name == "method" || name == "classes_file")) {
    return load_classes(options);
  }
  return {};
}

Result<void> set_config(PerceptionOptions& options, std::string_view assignment) {
  const auto setting = split_setting(assignment);
  if (!setting) {
    return fail(Error::Code::kMalformed, "'{}' is not of the form section.option=value",
                assignment);
  }
  return set_config(options, setting->section, setting->name, setting->value);
}

std::vector<std::string> preset_names() {
  return {"vehicle-pag", "vehicle-pag-literal", "vehicle-model", "road-users",
          "road-users-literal"};
}

namespace {

PerceptionOptions literal_chain() {
  PerceptionOptions options;
  options.segment.method = segment::SegmentMethod::kPagLiteral;
  options.shape.outline.lines = shape::LineMethod::kIepfLiteral;
  options.shape.join.method = shape::JoinMethod::kNone;
  options.classify.method = classify::Method::kLu2018;
  options.track = track::literal_options();
  return options;
}

/// Models drive livelier for their size, and their scanners see few but exact points of them.
PerceptionOptions model_chain() {
  PerceptionOptions options;
  options.pipeline.scale = 0.1;
  options.preprocess.sigma_range_m = 0.06;
  options.classify.min_points = 6;
  options.track.sigma_accel = 4;
  return options;
}

/// A vehicle seen in part must not take over a small object's track, nor the reverse. What is
/// hidden beside a road may be anything: it is followed there for a shorter time.
PerceptionOptions road_users_chain() {
  PerceptionOptions options;
  options.classify.keep = classify::Keep::kRoadUsers;
  options.classify.method = classify::Method::kSoftmax;
  use_classes(options, default_classes());
  options.track.class_mismatch_cost = 100;
  options.track.coast_hidden_share = 1.5;
  return options;
}

/// The tracker has no literal of its own: nearest neighbour by Euclidean distance, tracks that live
/// a time unseen.
PerceptionOptions road_users_literal_chain() {
  PerceptionOptions options = road_users_chain();
  options.preprocess.outliers = preprocess::OutlierMethod::kMedianReplace;
  options.segment.method = segment::SegmentMethod::kAdaptive;
  options.shape.outline.lines = shape::LineMethod::kIepfLiteral;
  options.shape.join.method = shape::JoinMethod::kGuo;
  options.shape.join.expected_margin_m = 0;
  options.shape.join.limb_m = 0;
  options.track.measurement = track::MeasuredAs::kCentre;
  options.track.associator = associate::Method::kNearest;
  options.track.distance = track::Distance::kEuclidean;
  options.track.motion = track::Motion::kCv;
  options.track.moving_from = 0;
  options.track.lost_s = 0;
  options.track.confirm_hits = 1;
  options.track.confirm_window = 1;
  options.track.births_inside_tracks = true;
  return options;
}

}  // namespace

Result<PerceptionOptions> preset(std::string_view name) {
  if (name == "vehicle-pag") return PerceptionOptions{};
  if (name == "vehicle-pag-literal") return literal_chain();
  if (name == "vehicle-model") return model_chain();
  if (name == "road-users") return road_users_chain();
  if (name == "road-users-literal") return road_users_literal_chain();
  return fail(Error::Code::kNotFound, "unknown preset '{}'; did you mean '{}'? Known: {}", name,
              nearest_name(name, preset_names()), fmt::join(preset_names(), ", "));
}

}  // namespace scanfuse::pipeline
