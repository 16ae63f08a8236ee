#pragma once

#include <map>
#include <span>

#include "scanfuse/evaluate/evaluate.hpp"

namespace scanfuse::evaluate {

/// One class of road user against tracks said to be of it.
struct ClassEvaluation {
  Evaluation score;
  std::optional<double> precision;  ///< matched within match_m, over tracks of the class
  std::optional<double> recall;     ///< the same over objects of the class
};

/// Each class alone, as road benchmarks do it: objects of the class against the confirmed tracks
/// that say so in that scan. A track on an object of another class is a false one, an object whose
/// track says another class is missed. For vehicles, pedestrians and cyclists, as far as truth or
/// tracks have them. AMOTA is left out.
[[nodiscard]] std::map<ObjectClass, ClassEvaluation> evaluate_by_class(
    std::span<const StepResult> steps, std::span<const TruthFrame> truth,
    const EvaluateOptions& options = {});

}  // namespace scanfuse::evaluate
