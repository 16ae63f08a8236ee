#include "scanfuse/evaluate/per_class.hpp"

#include <algorithm>

namespace scanfuse::evaluate {
namespace {

constexpr std::array kRoadUsers{ObjectClass::kVehicle, ObjectClass::kPedestrian,
                                ObjectClass::kCyclist};

std::vector<StepResult> tracks_of(ObjectClass kind, std::span<const StepResult> steps) {
  std::vector<StepResult> kept;
  kept.reserve(steps.size());
  for (const auto& step : steps) {
    StepResult& copy = kept.emplace_back();
    copy.stamp = step.stamp;
    copy.frame = step.frame;
    copy.world_from_ego = step.world_from_ego;
    copy.coordinate_frame = step.coordinate_frame;
    std::ranges::copy_if(step.tracks, std::back_inserter(copy.tracks),
                         [&](const Track& track) { return track.object_class == kind; });
  }
  return kept;
}

std::vector<TruthFrame> objects_of(ObjectClass kind, std::span<const TruthFrame> truth) {
  std::vector<TruthFrame> kept(truth.begin(), truth.end());
  for (auto& frame : kept) {
    std::erase_if(frame.objects, [&](const TruthObject& o) { return o.object_class != kind; });
  }
  return kept;
}

}  // namespace

std::map<ObjectClass, ClassEvaluation> evaluate_by_class(std::span<const StepResult> steps,
                                                         std::span<const TruthFrame> truth,
                                                         const EvaluateOptions& options) {
  EvaluateOptions without_amota = options;
  without_amota.amota_levels = 0;
  std::map<ObjectClass, ClassEvaluation> classes;
  for (const ObjectClass kind : kRoadUsers) {
    ClassEvaluation one;
    one.score = evaluate(tracks_of(kind, steps), objects_of(kind, truth), without_amota);
    const auto found = one.score.detection.find(kind);
    if (found == one.score.detection.end()) continue;
    one.precision = found->second.precision;
    one.recall = found->second.recall;
    classes.emplace(kind, std::move(one));
  }
  return classes;
}

}  // namespace scanfuse::evaluate
