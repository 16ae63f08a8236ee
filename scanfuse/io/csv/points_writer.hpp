#pragma once

#include <filesystem>
#include <string>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::io {

/// Writes scans as CSV points, `frame,time_s,x_m,y_m,z_m,layer,intensity,sensor`: a row a return,
/// with the scan's stamp. Scans without returns leave no row; the times of single beams, echoes and
/// the beam pattern are not kept. Appears under its name when finished.
class CsvPointsWriter {
 public:
  [[nodiscard]] static Result<CsvPointsWriter> create(const std::filesystem::path& path);
  [[nodiscard]] Result<void> write(const Scan& scan);
  [[nodiscard]] Result<void> finish();

 private:
  explicit CsvPointsWriter(AtomicFile file) : file_(std::move(file)) {}
  AtomicFile file_;
};

[[nodiscard]] std::string point_rows(const Scan& scan);

}  // namespace scanfuse::io
