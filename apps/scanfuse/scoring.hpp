#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command.hpp"
#include "scanfuse/evaluate/per_class.hpp"

namespace scanfuse::app {

/// Where truth comes from.
struct TruthRequest {
  std::string path;
  std::string frame;                ///< world, ego, or empty: as the file says
  std::vector<std::string> topics;  ///< of poses in a recording
  std::vector<double> size_m;       ///< length, width of what they tell of, or empty
  std::vector<double> offset_m;     ///< centre of the box from the pose, or empty
  std::string object_class = "vehicle";
};
void add_truth_options(CLI::App& command, TruthRequest& request);

/// A table, the truth that stands in a recording, or the poses of its topics at the steps' times.
[[nodiscard]] Result<std::vector<TruthFrame>> read_truth(const TruthRequest& request,
                                                         std::span<const StepResult> steps,
                                                         Diagnostics& diagnostics);

/// How tracks are compared with truth.
struct ScoringRequest {
  evaluate::EvaluateOptions options;
  std::string similarity = "centre";
  std::vector<double> region;
  double view_deg = 180;
  bool skip_unlisted = false;
};
void add_scoring_options(CLI::App& command, ScoringRequest& request);

/// `truth`: of topics counts only where it is known.
[[nodiscard]] Result<evaluate::EvaluateOptions> resolve_scoring(const ScoringRequest& request,
                                                                const TruthRequest& truth);

/// All classes together, and each alone.
struct Score {
  evaluate::Evaluation all;
  std::map<ObjectClass, evaluate::ClassEvaluation> by_class;
};

/// Keeps tracks while `track` runs, where there is truth to compare them with: asked for, or in the
/// recording.
class Scorer {
 public:
  /// A truth topic without a path is one of `input`. An error where what was asked cannot be.
  [[nodiscard]] static Result<Scorer> create(TruthRequest truth, const ScoringRequest& scoring,
                                             const std::string& input);
  void add(const StepResult& step);
  /// What the recording carries; not used where other truth was asked for.
  void add(const TruthFrame& truth);
  /// Reads the truth asked for; call before `score`.
  [[nodiscard]] Result<void> finish(Diagnostics& diagnostics);
  /// Nothing without truth.
  [[nodiscard]] std::optional<Score> score() const;
  [[nodiscard]] bool was_asked() const { return !request_.path.empty(); }
  [[nodiscard]] const std::vector<TruthFrame>& truth() const { return truth_; }

 private:
  TruthRequest request_;
  evaluate::EvaluateOptions options_;
  std::vector<StepResult> steps_;
  std::vector<TruthFrame> truth_;
};

}  // namespace scanfuse::app
