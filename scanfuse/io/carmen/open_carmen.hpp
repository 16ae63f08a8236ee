#pragma once

#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/text/line_reader.hpp"

namespace scanfuse::io {

/// A log of the CARMEN toolkit (.log, .clf). Understood lines:
///   FLASER, RLASER          n, n ranges, laser pose x y theta, robot pose x y theta
///   ROBOTLASER1, 2          the same with the scanner's angles, remissions and two poses
///   RAWLASER1, 2, ...       angles and ranges without poses
///   ODOM                    x y theta, speed, yaw rate
/// each ending in `ipc_timestamp ipc_hostname logger_timestamp`. The ipc timestamp, given by the
/// module that made the message, is the stamp; the logger's, when the line was written, is not
/// used, since it counts from another zero. Old logs hold too few digits, or zeros: equal stamps
/// are noted and kept.
///
/// Topics: each scanner by its keyword in lower case ("/flaser"), "/odom" with the robot's pose of
/// the scan lines (corrected, in corrected logs), "/odom_wheels" with the ODOM lines, "/tf" with
/// where the scanner sits on the robot ("base_link" to the scan's frame). That comes from the first
/// scan line; later robot poses are the laser pose less this offset, so that a corrected laser pose
/// beside an uncorrected robot pose stays right.
///
/// FLASER and RLASER look 180 degrees wide from right to left. An even count n is half open (step
/// 180/n, the last beam at 90 degrees less one step), an odd one closed (step 180/(n - 1)). They
/// carry no maximum range: at one degree (n <= 181, SICK PLS and LMS) readings of 50 m and more are
/// "no return" codes, else those of 80 m and more.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> open_carmen(LineReader lines,
                                                                   const OpenOptions& options);

/// Whether a line starts with a word that CARMEN logs use.
[[nodiscard]] bool is_carmen_line(std::string_view line);

}  // namespace scanfuse::io
