#pragma once

#include <optional>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/raw_message.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// A container of serialised messages, read front to back.
class RawMessageSource {
 public:
  virtual ~RawMessageSource() = default;
  /// May grow while reading when the container has no index; never reordered.
  [[nodiscard]] virtual const std::vector<RawChannel>& channels() const = 0;
  /// The next message; nothing at the end. An error is final.
  [[nodiscard]] virtual Result<std::optional<RawMessage>> next() = 0;
  [[nodiscard]] virtual const Diagnostics& diagnostics() const = 0;
  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
};

}  // namespace scanfuse::io
