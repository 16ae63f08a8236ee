#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include "scanfuse/io/ros/decoding_reader.hpp"
#include "scanfuse/io/rosbag/open_rosbag.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse::io;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  auto source = open_rosbag(std::make_unique<std::istringstream>(std::move(bytes)), "fuzz.bag");
  if (!source) return 0;
  const auto reader = decode_messages(std::move(*source));
  for (auto event = reader->next(); event && *event; event = reader->next()) {
  }
  return 0;
}
