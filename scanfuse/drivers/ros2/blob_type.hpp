#pragma once

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <string>

#include "scanfuse/drivers/bytes.hpp"

namespace scanfuse::drivers {

/// A message without keys, held as the bytes that go over the wire, padded to a multiple of 4.
/// Cyclone counts its references and frees it.
struct Blob : ddsi_serdata {
  Bytes bytes;
  std::size_t size = 0;  ///< of the message, without the padding
};

/// A type of such messages under a name of the bus. The topic that is made with it owns it.
/// `dds_write` takes a `const ByteView*`, `dds_takecdr` gives `Blob`s.
[[nodiscard]] ddsi_sertype* make_blob_type(const std::string& dds_type_name);

}  // namespace scanfuse::drivers
