#pragma once

#include <memory>
#include <span>

#include "scanfuse/io/raw_message_source.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// Decodes the messages of a type that is no ROS message, "scanfuse.Truth" in JSON.
using TruthDecoder = Result<TruthFrame> (*)(std::span<const std::byte> bytes);

/// A recording from a container of serialised messages. Known types become events; unknown ones are
/// passed over and stay in `info()` with `decoded` false; a message that cannot be decoded is
/// counted as damage. Scans are numbered from 0 for each topic, which is their sensor's name.
/// `truth_decoder`, where given, reads channels of type "scanfuse.Truth" and encoding "json".
[[nodiscard]] std::unique_ptr<RecordingReader> decode_messages(
    std::unique_ptr<RawMessageSource> source, const OpenOptions& options = {},
    TruthDecoder truth_decoder = nullptr);

}  // namespace scanfuse::io
