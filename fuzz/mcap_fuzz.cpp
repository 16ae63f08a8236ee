#include <cstddef>
#include <cstdint>
#include <span>

#include "scanfuse/io/mcap/message_reader.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/result_messages.hpp"

namespace mcap = scanfuse::io::mcap;

// Any bytes give messages, an error or counted damage. Read as indexed file, and once more cut
// short.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  for (const std::size_t kept : {size, size - size / 4}) {
    mcap::ReaderOptions options;
    options.max_chunk_bytes = 1 << 20;
    auto reader = mcap::MessageReader::open(
        mcap::bytes_in_memory({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(kept)}),
        options);
    if (!reader) continue;
    for (;;) {
      const auto message = reader->next();
      if (!message || !*message) break;
      (void)mcap::truth_from_json((*message)->data);
      (void)mcap::tracks_from_json((*message)->data);
    }
  }
  auto source = scanfuse::io::open_mcap(mcap::bytes_in_memory({bytes.begin(), bytes.end()}));
  if (!source) return 0;
  for (;;) {
    const auto message = (*source)->next();
    if (!message || !*message) return 0;
    if ((*message)->channel >= (*source)->channels().size()) __builtin_trap();
  }
}
