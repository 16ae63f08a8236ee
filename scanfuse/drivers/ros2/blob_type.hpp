#pragma once

#include <string>

#include "scanfuse/drivers/bytes.hpp"

struct ddsi_serdata;
struct ddsi_sertype;

namespace scanfuse::drivers {

/// A type under a name of the bus whose messages have no keys and are held as the bytes that go
/// over the wire. The topic that is made with it owns it. `dds_write` takes a `const ByteView*`.
[[nodiscard]] ddsi_sertype* make_blob_type(const std::string& dds_type_name);

/// What `dds_takecdr` gave of such a type, as long as it is not given back.
[[nodiscard]] ByteView bytes_of(const ddsi_serdata* message);

}  // namespace scanfuse::drivers
