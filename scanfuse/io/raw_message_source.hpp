#pragma once

#include <optional>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/raw_message.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// A container of serialised messages, read front to back; knows nothing of what they say.
class RawMessageSource {
 public:
  virtual ~RawMessageSource() = default;
  /// May grow while reading (files without an index); an index stays valid.
  [[nodiscard]] virtual const std::vector<RawChannel>& channels() const = 0;
  /// Topics as the container lists them; `decoded` and `is_scan` are not filled in here.
  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
  /// The next message; nothing at the end. An error is final; damage is counted and skipped.
  [[nodiscard]] virtual Result<std::optional<RawMessage>> next() = 0;
  [[nodiscard]] virtual const Diagnostics& diagnostics() const = 0;
};

}  // namespace scanfuse::io
