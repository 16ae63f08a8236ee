#include <algorithm>
#include <array>
#include <string>

#include "scanfuse/io/carmen/open_carmen.hpp"
#include "scanfuse/io/csv/csv_points.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"
#include "scanfuse/io/folder/stamps.hpp"
#include "scanfuse/io/kitti/open_kitti.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/pcd/pcd_header.hpp"
#include "scanfuse/io/pcd/read_pcd.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/ros/decoding_reader.hpp"
#include "scanfuse/io/rosbag/open_rosbag.hpp"
#include "scanfuse/io/rosbag2/open_rosbag2.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

using std::filesystem::path;
using Opened = Result<std::unique_ptr<RecordingReader>>;

constexpr std::string_view kKnownFormats =
    "known are MCAP, ROS 1 bags, rosbag2 folders and .db3 files, CARMEN logs, PCD files, KITTI "
    ".bin "
    "files and CSV points (the text formats also as .gz and .xz)";

/// What is known of a file before it is opened.
struct Probe {
  path file;
  std::string first_bytes;     ///< as they stand in the file
  std::string first_unpacked;  ///< behind gzip or xz
  std::string first_line;      ///< of text: the first that is neither blank nor a comment
};

/// One entry of the table below: whether a file is of a format, and how it is opened.
struct Format {
  bool (*matches)(const Probe& probe);
  Opened (*open)(const path& file, const OpenOptions& options);
};

Opened open_lines(const path& file, const OpenOptions& options,
                  Opened (*open)(LineReader, const OpenOptions&)) {
  auto lines = LineReader::open(file);
  if (!lines) return tl::unexpected(lines.error());
  return open(std::move(*lines), options);
}

Opened open_messages(Result<std::unique_ptr<RawMessageSource>> source, const OpenOptions& options) {
  if (!source) return tl::unexpected(source.error());
  return decode_messages(std::move(*source), options, &mcap::truth_from_json);
}

const auto kFormats = std::to_array<Format>({
    {[](const Probe& probe) { return probe.first_bytes.starts_with("\x89MCAP"); },
     [](const path& file, const OpenOptions& options) {
       return open_messages(open_mcap(file, options.topics), options);
     }},
    {[](const Probe& probe) { return probe.first_bytes.starts_with("#ROSBAG V"); },
     [](const path& file, const OpenOptions& options) {
       return open_messages(open_rosbag(file, options.topics), options);
     }},
    {[](const Probe& probe) { return probe.first_bytes.starts_with("SQLite format 3"); },
     [](const path& file, const OpenOptions& options) {
       return open_messages(open_rosbag2(file, options.topics), options);
     }},
    {[](const Probe& probe) { return is_pcd(probe.first_unpacked); }, &open_pcd},
    {[](const Probe& probe) { return is_carmen_line(probe.first_line); },
     [](const path& file, const OpenOptions& options) {
       return open_lines(file, options, &open_carmen);
     }},
    {[](const Probe& probe) {
       return table_kind_of_header(probe.first_line) == TableKind::kPoints;
     },
     [](const path& file, const OpenOptions& options) {
       return open_lines(file, options, &open_csv_points);
     }},
    {[](const Probe& probe) { return probe.file.extension() == ".bin"; }, &open_kitti},
});

std::string first_content_line(const Probe& probe) {
  Diagnostics ignored;
  LineReader lines(probe.file.string(), open_memory(probe.file.string(), probe.first_unpacked));
  return std::string(lines.peek_content(ignored));
}

Result<Probe> probe_file(const path& file) {
  constexpr std::size_t kProbed = 1 << 16;
  Probe probe{file, {}, {}, {}};
  auto source = open_bytes(file);
  if (!source) return tl::unexpected(source.error());
  auto unpacked = read_start(**source, kProbed);
  if (!unpacked) return tl::unexpected(unpacked.error());
  probe.first_unpacked = std::move(*unpacked);
  if ((*source)->packing() == "none") probe.first_bytes = probe.first_unpacked;
  probe.first_line = first_content_line(probe);
  return probe;
}

/// Formats that are recognised only to say what to do.
std::optional<Error> refusal(const Probe& probe) {
  const std::string name = probe.file.string();
  const auto unsupported = [&](std::string_view what) {
    return Error{Error::Code::kUnsupported, fmt::format("{}: {}", name, what)};
  };
  if (probe.first_unpacked.empty()) {
    return Error{Error::Code::kMalformed, fmt::format("{}: is empty", name)};
  }
  if (probe.first_bytes.starts_with("PK\x03\x04")) {
    return unsupported("is a zip archive: unzip it and name the file or folder inside");
  }
  if (probe.first_bytes.starts_with("7z\xbc\xaf\x27\x1c") ||
      probe.first_bytes.starts_with("\x28\xb5\x2f\xfd") || probe.first_bytes.starts_with("BZh")) {
    return unsupported("is a packed file: unpack it first");
  }
  const TableKind kind = table_kind_of_header(probe.first_line);
  if (kind == TableKind::kTracks || kind == TableKind::kTruth || kind == TableKind::kEgo ||
      kind == TableKind::kDetections || kind == TableKind::kBearings) {
    return unsupported(fmt::format("is a table of {}, not a recording of points", to_string(kind)));
  }
  return std::nullopt;
}

Opened open_file(const path& file, const OpenOptions& options) {
  const auto probe = probe_file(file);
  if (!probe) return tl::unexpected(probe.error());
  if (const auto refused = refusal(*probe)) return tl::unexpected(*refused);
  for (const Format& format : kFormats) {
    if (format.matches(*probe)) return format.open(file, options);
  }
  return fail(Error::Code::kUnsupported, "{}: unknown format; {}", file.string(), kKnownFormats);
}

/// A folder with metadata.yaml, .db3 or .mcap files, also packed as whole files.
bool is_rosbag2_folder(const path& folder) {
  std::error_code error;
  if (std::filesystem::exists(folder / "metadata.yaml", error)) return true;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    for (const std::string_view ending : {".db3", ".mcap", ".db3.zstd", ".mcap.zstd"}) {
      if (name.ends_with(ending)) return true;
    }
  }
  return false;
}

Opened open_folder(const path& folder, const OpenOptions& options) {
  if (is_rosbag2_folder(folder)) {
    return open_messages(open_rosbag2(folder, options.topics), options);
  }
  if (!files_of(folder, ".pcd").empty()) return open_pcd(folder, options);
  if (!kitti_scan_folder(folder).empty()) return open_kitti(folder, options);
  return fail(Error::Code::kNotFound, "{}: a folder without a recording; {}", folder.string(),
              kKnownFormats);
}

}  // namespace

Opened open_recording(const path& path, const OpenOptions& options) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return fail(Error::Code::kNotFound, "{}: no such file or folder", path.string());
  }
  return std::filesystem::is_directory(status) ? open_folder(path, options)
                                               : open_file(path, options);
}

}  // namespace scanfuse::io
