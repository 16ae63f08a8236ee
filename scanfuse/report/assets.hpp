#pragma once

#include <string_view>

namespace scanfuse::report {

/// The files marks.js with viewer.js, passive_tracks.js, page.css, turntable_viewer.js, and
/// turntable.css, which comes after page.css; embedded when building.
[[nodiscard]] std::string_view viewer_script();
[[nodiscard]] std::string_view passive_tracks_script();
[[nodiscard]] std::string_view page_style();
[[nodiscard]] std::string_view turntable_script();
[[nodiscard]] std::string_view turntable_style();

}  // namespace scanfuse::report
