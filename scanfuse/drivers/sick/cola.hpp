#pragma once

#include <string_view>

#include "scanfuse/drivers/bytes.hpp"
#include "scanfuse/drivers/stream.hpp"

namespace scanfuse::drivers::sick {

/// The two dialects of SICK's command language [Sick2020, section 2]: A is text between STX and
/// ETX, B is binary behind four STX and a length, with the exclusive or of its content at the end.
enum class Cola { kA, kB };

/// The front of a stream in either dialect.
[[nodiscard]] Cut cut_cola(ByteView bytes);

/// The content of a whole telegram, from "sRA" on, and its dialect.
struct ColaTelegram {
  Cola dialect = Cola::kB;
  ByteView content;
};
[[nodiscard]] ColaTelegram open_cola(ByteView telegram);
[[nodiscard]] Bytes close_cola(Cola dialect, ByteView content);

/// "sEN LMDscandata 1": scans from now on, or (`on` false) no more.
[[nodiscard]] Bytes scan_request(Cola dialect, bool on);

}  // namespace scanfuse::drivers::sick
