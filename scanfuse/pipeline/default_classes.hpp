#pragma once

#include <string_view>

namespace scanfuse::pipeline {

/// scanfuse/pipeline/classes.toml, set into the library when it is built.
[[nodiscard]] std::string_view default_classes_text();

}  // namespace scanfuse::pipeline
