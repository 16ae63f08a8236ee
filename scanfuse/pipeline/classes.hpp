#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "scanfuse/classify/class_model.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/track/class_belief.hpp"

namespace scanfuse::pipeline {

/// Everything learned about classes: of single outlines and of tracks. Kept in one TOML file.
struct Classes {
  classify::ClassModel recognizer;
  track::BeliefModel belief;
};

/// Errors name file, and the key that is missing, unknown or out of range.
[[nodiscard]] Result<Classes> parse_classes(std::string_view text, const std::string& name);
[[nodiscard]] Result<Classes> read_classes(const std::filesystem::path& path);
[[nodiscard]] std::string write_classes(const Classes& classes);

/// What comes with the library: learned by tools/learn_classes.sh from simulated scenes.
[[nodiscard]] std::shared_ptr<const Classes> default_classes();

/// Puts `classes` into the recogniser and, where that tells probabilities, the tracker.
void use_classes(PerceptionOptions& options, const std::shared_ptr<const Classes>& classes);

/// Fills in what `classify.method` needs and is not there: the file named by
/// `classify.classes_file`, else what comes with the library. Reads the file each time.
[[nodiscard]] Result<void> load_classes(PerceptionOptions& options);

}  // namespace scanfuse::pipeline
