#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "scanfuse/evaluate/class_score.hpp"
#include "scanfuse/pipeline/learn_classes.hpp"

namespace scanfuse::app {

struct LearnRequest {
  std::vector<std::string> inputs;
  std::vector<std::string> truths;  ///< one each, or none: the recordings carry it
  std::string ego;
  std::string output;
  std::string report;
  bool vary = false;  ///< what is learned from, not what is tested on
  bool json = false;
};

/// [truth row][said row], rows of the learned classes; intervals may say none: the last column.
using DetectionConfusion =
    std::array<std::array<std::int64_t, classify::kLearnedClasses + 1>, classify::kLearnedClasses>;

struct LearnOutcome {
  pipeline::Classes classes;
  std::int64_t fit_outlines = 0, calibration_outlines = 0, test_outlines = 0;
  std::int64_t calibration_tracks = 0;
  bool cut_by_time = false;        ///< too few recordings to set whole ones apart
  evaluate::Reliability outlines;  ///< of the softmax on the test's outlines
  DetectionConfusion softmax{}, intervals{};
  evaluate::ClassScore tracks;  ///< by the whole chain on the test's scans
  Diagnostics diagnostics;
};

[[nodiscard]] Result<LearnOutcome> run_learn(const LearnRequest& request,
                                             const CommonOptions& common);

}  // namespace scanfuse::app
