#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/mcap/byte_source.hpp"
#include "scanfuse/io/raw_message_source.hpp"

namespace scanfuse::io {

/// Opens an MCAP file as a source of serialised messages; `topics` empty: all. Without an index the
/// first 64 MiB are read ahead, so that `info()` and `channels()` know what is in there; counts are
/// then given when that was the whole file.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_mcap(
    const std::filesystem::path& path, const std::vector<std::string>& topics = {});

/// The same over any bytes.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_mcap(
    std::unique_ptr<mcap::ByteSource> source, const std::vector<std::string>& topics = {});

}  // namespace scanfuse::io
