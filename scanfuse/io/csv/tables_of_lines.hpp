#pragma once

#include <vector>

#include "scanfuse/io/tables.hpp"
#include "scanfuse/io/text/line_reader.hpp"

/// The tables of tables.hpp over any lines: what the functions of paths call, and tests with text.
namespace scanfuse::io {

[[nodiscard]] Result<std::vector<StepResult>> read_track_table(LineReader lines,
                                                               Diagnostics& diagnostics);
[[nodiscard]] Result<std::vector<TruthFrame>> read_truth_table(LineReader lines,
                                                               Diagnostics& diagnostics);
[[nodiscard]] Result<std::vector<PoseSample>> read_ego_table(LineReader lines,
                                                             Diagnostics& diagnostics);
[[nodiscard]] Result<std::vector<DetectionFrame>> read_detection_table(LineReader lines,
                                                                       Diagnostics& diagnostics);

/// The class that a cell names; unknown names count as "other" and are noted.
[[nodiscard]] ObjectClass class_of(std::string_view text, const std::string& where,
                                   Diagnostics& diagnostics);

[[nodiscard]] TableKind table_kind_of_header(std::string_view header);

[[nodiscard]] std::string truth_header();
[[nodiscard]] std::string truth_rows(const TruthFrame& frame);
[[nodiscard]] std::string ego_header();
[[nodiscard]] std::string ego_row(const PoseSample& sample);

}  // namespace scanfuse::io
