#include <cstddef>
#include <cstdint>
#include <vector>

#include "scanfuse/io/ros/decoding_reader.hpp"
#include "scanfuse/io/rosbag2/bag_metadata.hpp"
#include "scanfuse/io/rosbag2/db3_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse::io;
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  (void)rosbag2::parse_metadata({reinterpret_cast<const char*>(data), size});
  auto database = rosbag2::Database::open(std::vector<std::byte>(bytes, bytes + size), "fuzz.db3");
  if (!database) return 0;
  auto source = rosbag2::open_db3(std::move(*database), {});
  if (!source) return 0;
  const auto reader = decode_messages(std::move(*source));
  for (auto event = reader->next(); event && *event; event = reader->next()) {
  }
  return 0;
}
