#include <cstdlib>
#include <string>

#include "scanfuse/io/pcap/payload_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse::io;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  auto packets = pcap::PacketReader::open("fuzz.pcap", open_memory("fuzz.pcap", bytes));
  if (!packets) return 0;
  pcap::PayloadReader payloads(std::move(*packets));
  std::size_t said = 0;
  while (const auto payload = payloads.next()) said += payload->bytes.size();
  // Fragments may be said again and again, but not more than each ends a datagram once.
  if (said > (size + 1) * (size + 1)) std::abort();
  return 0;
}
