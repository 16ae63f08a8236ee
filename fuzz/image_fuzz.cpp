#include <cstdlib>

#include "scanfuse/io/image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto image =
      scanfuse::io::parse_image({reinterpret_cast<const char*>(data), size}, "fuzz.png");
  if (!image) return 0;
  const auto pixels =
      static_cast<std::size_t>(image->width_px) * static_cast<std::size_t>(image->height_px);
  if (image->pixels.size() != pixels * static_cast<std::size_t>(image->channels)) std::abort();
  return 0;
}
