#include "scanfuse/io/csv/points_writer.hpp"

#include <iterator>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

/// A field of CSV, in quotes where it needs them.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos && text == trimmed(text)) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n' || c == '\r') continue;
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::string point_rows(const Scan& scan) {
  const std::string begin = fmt::format("{},{},", scan.frame, print_seconds(scan.stamp));
  const std::string end = "," + csv_field(scan.sensor) + "\n";
  std::string rows;
  for (const Return& r : scan.returns) {
    fmt::format_to(std::back_inserter(rows), "{}{},{},{},{},{}{}", begin, r.x_m, r.y_m, r.z_m,
                   r.layer, r.intensity, end);
  }
  return rows;
}

Result<CsvPointsWriter> CsvPointsWriter::create(const std::filesystem::path& path) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto wrote = file->write("frame,time_s,x_m,y_m,z_m,layer,intensity,sensor\n"); !wrote) {
    return tl::unexpected(wrote.error());
  }
  return CsvPointsWriter(std::move(*file));
}

Result<void> CsvPointsWriter::write(const Scan& scan) { return file_.write(point_rows(scan)); }
Result<void> CsvPointsWriter::finish() { return file_.commit(); }

}  // namespace scanfuse::io
