#include "scoring.hpp"

#include <filesystem>

#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/pipeline/topic_truth.hpp"

namespace scanfuse::app {
namespace {

Result<std::vector<TruthFrame>> truth_in_recording(const std::string& path,
                                                   Diagnostics& diagnostics) {
  auto reader = io::open_recording(path);
  if (!reader) return tl::unexpected(reader.error());
  std::vector<TruthFrame> frames;
  while (true) {
    auto event = (*reader)->next();
    if (!event) return tl::unexpected(event.error());
    if (!*event) break;
    if (auto* frame = std::get_if<TruthFrame>(&(*event)->payload)) {
      frames.push_back(std::move(*frame));
    }
  }
  diagnostics.merge((*reader)->diagnostics());
  if (frames.empty()) {
    return fail(Error::Code::kNotFound,
                "{}: holds no truth; give a truth table, a recording "
                "written by `scanfuse simulate`, or the topic of an object's pose (--truth-topic)",
                path);
  }
  return frames;
}

Result<std::vector<TruthFrame>> truth_in_topics(const TruthRequest& request,
                                                std::span<const StepResult> steps,
                                                Diagnostics& diagnostics) {
  if (steps.empty()) return std::vector<TruthFrame>{};
  io::OpenOptions open;
  open.topics = request.topics;
  auto reader = io::open_recording(request.path, open);
  if (!reader) return tl::unexpected(reader.error());
  pipeline::TopicTruthOptions options;
  options.topics = request.topics;
  options.object_class = object_class_from(request.object_class).value_or(ObjectClass::kVehicle);
  if (!request.size_m.empty()) options.size_m = {request.size_m[0], request.size_m[1]};
  if (!request.offset_m.empty()) options.offset_m = {request.offset_m[0], request.offset_m[1]};
  auto frames = pipeline::truth_from_topics(**reader, options, steps, diagnostics);
  diagnostics.merge((*reader)->diagnostics());
  return frames;
}

}  // namespace

void add_truth_options(CLI::App& command, TruthRequest& request) {
  command
      .add_option("--truth-frame", request.frame,
                  "Frame of the truth's coordinates: world (default for tables) or ego")
      ->check(CLI::IsMember({"world", "ego"}));
  command
      .add_option("--truth-topic", request.topics,
                  "Truth is the pose in this topic of the recording; one object each, may be "
                  "repeated")
      ->allow_extra_args(false);
  command.add_option("--truth-size", request.size_m, "L,W in metres: how large those objects are")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(0.0, 1000.0));
  command
      .add_option("--truth-offset", request.offset_m,
                  "X,Y in metres: the centre of the box from the pose, along the object's axes")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(-1000.0, 1000.0));
  command.add_option("--truth-class", request.object_class, "What those objects are")
      ->check(CLI::IsMember({"vehicle", "pedestrian", "cyclist", "other"}))
      ->capture_default_str();
}

Result<std::vector<TruthFrame>> read_truth(const TruthRequest& request,
                                           std::span<const StepResult> steps,
                                           Diagnostics& diagnostics) {
  const bool table = io::table_kind(request.path) != io::TableKind::kNone;
  auto truth = !request.topics.empty() ? truth_in_topics(request, steps, diagnostics)
               : table                 ? io::read_truth(request.path, &diagnostics)
                                       : truth_in_recording(request.path, diagnostics);
  if (!truth) return truth;
  for (auto& frame : *truth) {
    if (!request.frame.empty()) frame.coordinate_frame = request.frame;
  }
  return truth;
}

void add_scoring_options(CLI::App& command, ScoringRequest& request) {
  auto& options = request.options;
  command
      .add_option("--match-m", options.match_m,
                  "A track farther than this from an object is never its match")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command
      .add_option("--similarity-m", options.similarity_m,
                  "Distance at which similarity is 0; CLEAR and identity ask for 0.5")
      ->check(CLI::Range(1e-3, 100.0))
      ->capture_default_str();
  command
      .add_option("--similarity", request.similarity,
                  "centre: by distance of centres; bev_iou: by overlap of boxes from above")
      ->check(CLI::IsMember({"centre", "bev_iou"}))
      ->capture_default_str();
  command.add_option("--gospa-c-m", options.gospa_c_m, "Cut-off distance of GOSPA and OSPA")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  command
      .add_option("--min-visible-points", options.min_visible_points,
                  "Ignore truth objects with fewer returns, and what tracks them")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command
      .add_option("--region", request.region,
                  "X0,X1,Y0,Y1: only what is inside counts, truth frame")
      ->delimiter(',')
      ->expected(4);
  command
      .add_option("--view-deg", request.view_deg,
                  "Only what lies within so many degrees left or right of the ego's nose counts")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
  command.add_option("--view-m", options.view_range_m, "Only what is nearer to the ego counts")
      ->check(CLI::Range(0.0, 1e9));
  command.add_flag("--skip-unlisted", request.skip_unlisted,
                   "Leave out scans that no truth frame belongs to; else they are empty road");
}

Result<evaluate::EvaluateOptions> resolve_scoring(const ScoringRequest& request,
                                                  const TruthRequest& truth) {
  evaluate::EvaluateOptions options = request.options;
  options.view_half_angle_rad = radians(request.view_deg);
  if (request.similarity == "bev_iou") options.similarity = evaluate::SimilarityBy::kBevIou;
  if (request.skip_unlisted || !truth.topics.empty()) {
    options.unlisted_frames = evaluate::UnlistedFrames::kSkip;
  }
  const auto& r = request.region;
  if (r.empty()) return options;
  if (!(r[0] < r[1] && r[2] < r[3])) {
    return fail(Error::Code::kOutOfRange,
                "--region {},{},{},{} is empty; give X0,X1,Y0,Y1 with "
                "X0 < X1 and Y0 < Y1",
                r[0], r[1], r[2], r[3]);
  }
  options.region_x0_m = r[0];
  options.region_x1_m = r[1];
  options.region_y0_m = r[2];
  options.region_y1_m = r[3];
  return options;
}

Result<Scorer> Scorer::create(TruthRequest truth, const ScoringRequest& scoring,
                              const std::string& input) {
  if (truth.path.empty() && !truth.topics.empty()) truth.path = input;
  std::error_code ignored;
  if (!truth.path.empty() && !std::filesystem::exists(truth.path, ignored)) {
    return fail(Error::Code::kNotFound, "{}: no such file or folder", truth.path);
  }
  const auto options = resolve_scoring(scoring, truth);
  if (!options) return tl::unexpected(options.error());
  Scorer scorer;
  scorer.request_ = std::move(truth);
  scorer.options_ = *options;
  return scorer;
}

void Scorer::add(const StepResult& step) {
  if (truth_.empty() && !was_asked()) return;
  steps_.push_back(step);
  steps_.back().detections.clear();
}

void Scorer::add(const TruthFrame& truth) {
  if (!was_asked()) truth_.push_back(truth);
}

Result<void> Scorer::finish(Diagnostics& diagnostics) {
  if (!was_asked()) return {};
  auto truth = read_truth(request_, steps_, diagnostics);
  if (!truth) return tl::unexpected(truth.error());
  truth_ = std::move(*truth);
  return {};
}

std::optional<Score> Scorer::score() const {
  if (truth_.empty()) return std::nullopt;
  return Score{evaluate::evaluate(steps_, truth_, options_),
               evaluate::evaluate_by_class(steps_, truth_, options_)};
}

}  // namespace scanfuse::app
