#pragma once

#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/text/line_reader.hpp"

namespace scanfuse::io {

/// Points in CSV: `frame,time_s,x_m,y_m[,z_m][,layer][,intensity][,sensor]`, one return a row, the
/// rows of a frame together; each sensor of a frame makes one scan. Rows of a frame may differ in
/// time (the time of each beam): the scan's stamp is the earliest. A file with columns `x,y` (or
/// `x_m,y_m`) and neither frame nor time is one scan at time 0: the lists of [Lu2018].
///
/// With `options.paper_axes` x is lateral (right) and y forward, as in [Lu2018]; they are turned to
/// REP-103: x = y_paper, y = -x_paper.
///
/// Holds one frame at a time. Rows that cannot be read are counted as damage with their line; a
/// file without a good row is an error.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> open_csv_points(LineReader lines,
                                                                       const OpenOptions& options);

}  // namespace scanfuse::io
