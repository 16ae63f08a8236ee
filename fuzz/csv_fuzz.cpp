#include <cmath>
#include <cstdlib>

#include "scanfuse/io/csv/csv_points.hpp"
#include "scanfuse/io/csv/tables_of_lines.hpp"

// Points, and the tables of tracks, truth, ego motion and detections, plain and packed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto lines = [&] { return io::LineReader("fuzz", io::open_memory("fuzz", text)); };
  if (auto reader = io::open_csv_points(lines(), {})) {
    for (;;) {
      const auto event = (*reader)->next();
      if (!event || !*event) break;
      for (const Return& r : std::get<Scan>((*event)->payload).returns) {
        if (!std::isfinite(r.squared_range()) || !std::isfinite(r.time_offset_s)) std::abort();
      }
    }
  }
  Diagnostics diagnostics;
  (void)io::read_track_table(lines(), diagnostics);
  (void)io::read_truth_table(lines(), diagnostics);
  (void)io::read_ego_table(lines(), diagnostics);
  (void)io::read_detection_table(lines(), diagnostics);
  return 0;
}
