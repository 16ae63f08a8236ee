#pragma once

#include <span>
#include <vector>

#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::evaluate {

struct Alignment {
  std::vector<int> step_of_truth;  ///< for each truth frame the index of its step, -1 for none
  bool by_frame = true;            ///< frame numbers mean the same on both sides
};

/// No step is used twice. The rule stands at `make_sequence`.
[[nodiscard]] Alignment align_in_time(std::span<const StepResult> steps,
                                      std::span<const TruthFrame> truth);

}  // namespace scanfuse::evaluate
