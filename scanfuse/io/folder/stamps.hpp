#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/time.hpp"

namespace scanfuse::io {

/// One scan of a folder: its file and when it was taken.
struct ScanFile {
  std::filesystem::path path;
  Time stamp;
};

/// A stamp in text: seconds since 1970 with a fraction, whole milli-, micro- or nanoseconds (told
/// by their size), or "2011-09-26 13:02:25.964389445" (UTC). Nothing where it is none of these.
[[nodiscard]] std::optional<Time> parse_stamp(std::string_view text);

/// The files of a folder with this extension (".pcd"), in natural order of their names.
[[nodiscard]] std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder,
                                                          std::string_view extension);

/// Gives each file its stamp: from timestamps.txt in the folder (or, for a folder named "data",
/// beside it), one line a file; else from names that are stamps; else, with a note, ten a second
/// from 0.
[[nodiscard]] std::vector<ScanFile> stamp_files(const std::filesystem::path& folder,
                                                std::vector<std::filesystem::path> files,
                                                Diagnostics& diagnostics);

/// The stamps of a timestamps.txt, unreadable lines empty; nothing where there is no such file.
[[nodiscard]] std::vector<std::optional<Time>> read_stamps(const std::filesystem::path& file,
                                                           Diagnostics& diagnostics);

}  // namespace scanfuse::io
