#include <cmath>
#include <cstdlib>

#include "scanfuse/io/pcd/read_pcd.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scanfuse::Diagnostics diagnostics;
  const auto scan =
      scanfuse::io::read_pcd({reinterpret_cast<const char*>(data), size}, "fuzz.pcd", diagnostics);
  if (!scan) return 0;
  for (const scanfuse::Return& r : scan->returns) {
    if (!std::isfinite(r.squared_range()) || !std::isfinite(r.z_m)) std::abort();
  }
  return 0;
}
