#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/pipeline/perception.hpp"

namespace scanfuse::pipeline {

/// Calls `visit(section name, option struct)` for every section of a configuration, in the order in
/// which they are printed.
template <class Options, class Visit>
void for_each_section(Options& options, Visit&& visit) {
  visit("pipeline", options.pipeline);
  visit("preprocess", options.preprocess);
  visit("segment", options.segment);
  visit("pag", options.segment.pag);
  visit("pag_literal", options.segment.pag_literal);
  visit("surface", options.segment.surface);
  visit("breakpoint", options.segment.breakpoint);
  visit("adaptive", options.segment.adaptive);
  visit("distance_threshold", options.segment.distance_threshold);
  visit("euclidean", options.segment.euclidean);
  visit("outline", options.shape.outline);
  visit("iepf", options.shape.iepf);
  visit("faces", options.shape.faces);
  visit("occlusion", options.shape.occlusion);
  visit("join", options.shape.join);
  visit("classify", options.classify);
  visit("track", options.track);
}

/// Every option as text, section by section.
[[nodiscard]] std::vector<OptionView> view_config(const PerceptionOptions& options);

/// `--set section.name=value`. Unknown section or name: an error naming the nearest known one.
[[nodiscard]] Result<void> set_config(PerceptionOptions& options, std::string_view section,
                                      std::string_view name, std::string_view value);

/// The same from one text "section.name=value".
[[nodiscard]] Result<void> set_config(PerceptionOptions& options, std::string_view assignment);

/// A named set of options:
/// - `vehicle-pag`: vehicles by the default chain;
/// - `vehicle-pag-literal`: the chain of [Lu2018] as printed, to compare and to reproduce;
/// - `vehicle-model`: vehicle-pag for models of about 1:10;
/// - `road-users`: vehicles, pedestrians and cyclists, told apart by the learned classifier;
/// - `road-users-literal`: the chain of [Guo] as printed as far as it goes, to compare: median,
///   adaptive threshold of two lambdas, IEPF, its merging, nearest neighbours.
[[nodiscard]] Result<PerceptionOptions> preset(std::string_view name);
[[nodiscard]] std::vector<std::string> preset_names();

}  // namespace scanfuse::pipeline
