#pragma once

#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::io {

/// Unpacks gzip (RFC 1952), also of several members, while reading. A cut or damaged stream gives
/// what could be unpacked, then an error.
[[nodiscard]] std::unique_ptr<ByteSource> unpack_gzip(std::string name,
                                                      std::unique_ptr<ByteSource> packed);

/// Likewise .xz. Streams that ask for more than 256 MiB of memory are refused.
[[nodiscard]] std::unique_ptr<ByteSource> unpack_xz(std::string name,
                                                    std::unique_ptr<ByteSource> packed);

}  // namespace scanfuse::io
