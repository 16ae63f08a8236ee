#pragma once

#include <algorithm>
#include <cstddef>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/drivers/bytes.hpp"

namespace scanfuse::drivers {

/// What stands at the front of a stream: bytes of no telegram, then a telegram. Both 0: more bytes
/// must come before anything can be said.
struct Cut {
  std::size_t garbage = 0;
  std::size_t telegram = 0;
};

/// Cuts a stream that comes in any pieces into telegrams.
class StreamCutter {
 public:
  /// Appends a piece, then calls `use(telegram)` for each that `cut(bytes)` finds whole. What
  /// nobody claims is counted in `diagnostics`.
  template <class CutFront, class Use>
  void feed(ByteView piece, CutFront&& cut, Use&& use, Diagnostics& diagnostics) {
    append(buffer_, piece);
    std::size_t place = 0;
    while (place < buffer_.size()) {
      const Cut found = cut(ByteView(buffer_).subspan(place));
      if (found.garbage == 0 && found.telegram == 0) break;
      if (found.garbage > 0) diagnostics.note(kGarbage, {}, static_cast<int>(found.garbage));
      place += found.garbage;
      if (found.telegram == 0) continue;
      use(ByteView(buffer_).subspan(place, found.telegram));
      place += found.telegram;
    }
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(place));
  }
  /// The connection ended: what is left is no telegram.
  void clear(Diagnostics& diagnostics) {
    if (!buffer_.empty()) diagnostics.note("telegram cut off by the end of the connection");
    buffer_.clear();
  }

  static constexpr const char* kGarbage = "bytes that belong to no telegram";

 private:
  Bytes buffer_;
};

/// How many bytes from the front on are not `mark`; all of them where it does not occur.
[[nodiscard]] inline std::size_t until(ByteView bytes, std::byte mark, std::size_t from = 0) {
  const auto at = std::find(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), mark);
  return static_cast<std::size_t>(at - bytes.begin());
}

}  // namespace scanfuse::drivers
