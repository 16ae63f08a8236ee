#pragma once

#include <string>

namespace scanfuse::pipeline {

/// scanfuse/pipeline/classes.toml, set into the library when it is built.
[[nodiscard]] std::string default_classes_text();

}  // namespace scanfuse::pipeline
