#include "scanfuse/io/toml.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)scanfuse::io::parse_toml({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  return 0;
}
