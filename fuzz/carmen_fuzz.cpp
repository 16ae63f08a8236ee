#include <cmath>
#include <cstdlib>

#include "scanfuse/io/carmen/open_carmen.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse;
  std::string text(reinterpret_cast<const char*>(data), size);
  auto reader =
      io::open_carmen(io::LineReader("fuzz.log", io::open_memory("fuzz.log", std::move(text))), {});
  if (!reader) return 0;
  for (;;) {
    const auto event = (*reader)->next();
    if (!event || !*event) return 0;
    if (const auto* scan = std::get_if<Scan>(&(*event)->payload)) {
      for (const Return& r : scan->returns) {
        if (!std::isfinite(r.squared_range()) || !std::isfinite(r.intensity)) std::abort();
      }
    }
    if (const auto* pose = std::get_if<PoseSample>(&(*event)->payload)) {
      if (!pose->pose.translation_m.allFinite()) std::abort();
    }
  }
}
