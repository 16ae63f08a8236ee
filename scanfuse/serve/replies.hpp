#pragma once

#include <string>
#include <string_view>

#include "scanfuse/serve/labels.hpp"
#include "scanfuse/serve/workbench.hpp"

/// What the server tells in JSON; docs/viewer-protocol.md.
namespace scanfuse::serve {

[[nodiscard]] std::string hello_json(const Workbench& bench, const Labels& labels);
[[nodiscard]] std::string status_json(const Workbench& bench);
[[nodiscard]] std::string problem_json(std::string_view op, std::string_view what);
[[nodiscard]] std::string missing_frame_json(const FrameRequest& request);
/// The options form: every option of the library with its value, default, range and doc.
[[nodiscard]] std::string options_json(std::string_view preset,
                                       const pipeline::PerceptionOptions& options);
[[nodiscard]] std::string metrics_json(const Workbench::Comparison& comparison);
/// The resolved configuration as a file for --config.
[[nodiscard]] std::string export_json(RunName run, const pipeline::PerceptionOptions& options);
/// All objects, and the boxes of one frame; with `csv` also the file's text.
[[nodiscard]] std::string labels_json(const Labels& labels, const ScanLog& log,
                                      const LabelRequest& request);

}  // namespace scanfuse::serve
