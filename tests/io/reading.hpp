#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/text/line_reader.hpp"

namespace scanfuse::io_testing {

/// Everything that a reader gives, and how it ended.
struct ReadOut {
  std::vector<Scan> scans;
  std::vector<PoseSample> poses;
  std::vector<TransformSample> transforms;
  Diagnostics diagnostics;
  std::optional<Error> error;
};

inline ReadOut read_out(Result<std::unique_ptr<io::RecordingReader>> opened) {
  ReadOut out;
  if (!opened) {
    out.error = opened.error();
    return out;
  }
  for (;;) {
    auto event = (*opened)->next();
    if (!event) out.error = event.error();
    if (!event || !*event) break;
    if (auto* scan = std::get_if<Scan>(&(*event)->payload)) out.scans.push_back(std::move(*scan));
    if (auto* pose = std::get_if<PoseSample>(&(*event)->payload)) out.poses.push_back(*pose);
    if (auto* edges = std::get_if<std::vector<TransformSample>>(&(*event)->payload)) {
      out.transforms.insert(out.transforms.end(), edges->begin(), edges->end());
    }
  }
  out.diagnostics = (*opened)->diagnostics();
  return out;
}

inline io::LineReader lines_of(std::string text, const std::string& name = "test.csv") {
  return io::LineReader(name, io::open_memory(name, std::move(text)));
}

inline bool all_finite(const ReadOut& out) {
  for (const Scan& scan : out.scans) {
    for (const Return& r : scan.returns) {
      if (!std::isfinite(r.x_m) || !std::isfinite(r.y_m) || !std::isfinite(r.z_m) ||
          !std::isfinite(r.intensity) || !std::isfinite(r.squared_range())) {
        return false;
      }
    }
  }
  for (const PoseSample& pose : out.poses) {
    if (!pose.pose.translation_m.allFinite() || !pose.pose.rotation.coeffs().allFinite()) {
      return false;
    }
  }
  return true;
}

}  // namespace scanfuse::io_testing
