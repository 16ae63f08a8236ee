#include "scanfuse/drivers/ros2/blob_type.hpp"

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace scanfuse::drivers {
namespace {

/// A message, padded to a multiple of 4. Cyclone counts its references and frees it.
struct Blob : ddsi_serdata {
  Bytes bytes;
  std::size_t size = 0;  ///< of the message, without the padding
};

const Blob& as_blob(const ddsi_serdata* data) { return *static_cast<const Blob*>(data); }

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

Blob* new_blob(const ddsi_sertype* type, ddsi_serdata_kind kind, std::size_t size) {
  auto* blob = new Blob;
  ddsi_serdata_init(blob, type, kind);
  blob->hash = type->serdata_basehash;  // no keys: all of one instance
  blob->size = size;
  blob->bytes.resize(padded(size));
  return blob;
}

// What Cyclone asks of a message (`ddsi_serdata_ops`).

bool is_same_instance(const ddsi_serdata*, const ddsi_serdata*) { return true; }

std::uint32_t size_of(const ddsi_serdata* data) {
  return static_cast<std::uint32_t>(as_blob(data).size);
}

/// From the network: `fragment` begins a list of pieces in order, which may overlap.
ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  Blob* blob = new_blob(type, kind, size);
  std::size_t filled = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    const std::size_t begin = fragment->min, end = fragment->maxp1;
    if (begin > filled || end > size) break;
    if (end <= filled) continue;
    const unsigned char* payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::memcpy(blob->bytes.data() + filled, payload + (filled - begin), end - filled);
    filled = end;
  }
  if (filled == size) return blob;
  ddsi_serdata_unref(blob);
  return nullptr;
}

ddsi_serdata* from_pieces(const ddsi_sertype* type, ddsi_serdata_kind kind,
                          ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* pieces, std::size_t size) {
  Blob* blob = new_blob(type, kind, size);
  std::size_t filled = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count) && filled < size; ++i) {
    const std::size_t more = std::min<std::size_t>(pieces[i].iov_len, size - filled);
    std::memcpy(blob->bytes.data() + filled, pieces[i].iov_base, more);
    filled += more;
  }
  return blob;
}

ddsi_serdata* from_key(const ddsi_sertype* type, const ddsi_keyhash*) {
  return new_blob(type, SDK_KEY, 0);
}

/// From `dds_write`.
ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  const ByteView bytes = kind == SDK_DATA ? *static_cast<const ByteView*>(sample) : ByteView{};
  Blob* blob = new_blob(type, kind, bytes.size());
  std::copy(bytes.begin(), bytes.end(), blob->bytes.begin());
  return blob;
}

void copy_out(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* to) {
  std::memcpy(to, as_blob(data).bytes.data() + offset, size);
}

ddsi_serdata* lend(const ddsi_serdata* data, std::size_t offset, std::size_t size,
                   ddsrt_iovec_t* to) {
  const auto* bytes = as_blob(data).bytes.data() + offset;
  to->iov_base = const_cast<std::byte*>(bytes);  // C has no other word for it; it is only read
  to->iov_len = size;
  return ddsi_serdata_ref(data);
}

void give_back(ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); }

bool to_sample(const ddsi_serdata*, void*, void**, void*) { return false; }
bool key_to_sample(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) { return false; }

ddsi_serdata* without_type(const ddsi_serdata* data) {
  Blob* blob = new_blob(data->type, SDK_KEY, 0);
  blob->type = nullptr;
  return blob;
}

void free_blob(ddsi_serdata* data) { delete static_cast<Blob*>(data); }

std::size_t print(const ddsi_sertype*, const ddsi_serdata* data, char* to, std::size_t size) {
  const int wanted = std::snprintf(to, size, "%zu bytes", as_blob(data).size);
  return wanted < 0 ? 0 : static_cast<std::size_t>(wanted);
}

void no_key(const ddsi_serdata*, ddsi_keyhash* key, bool) { *key = {}; }

// What Cyclone asks of a type (`ddsi_sertype_ops`): types of one name are the same.

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete type;
}
void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void resize_samples(void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}
bool is_same_type(const ddsi_sertype*, const ddsi_sertype*) { return true; }
std::uint32_t hash_of_type(const ddsi_sertype*) { return 0; }

const ddsi_serdata_ops& blob_ops() {
  static const ddsi_serdata_ops ops = [] {
    ddsi_serdata_ops all{};
    all.eqkey = is_same_instance;
    all.get_size = size_of;
    all.from_ser = from_fragments;
    all.from_ser_iov = from_pieces;
    all.from_keyhash = from_key;
    all.from_sample = from_sample;
    all.to_ser = copy_out;
    all.to_ser_ref = lend;
    all.to_ser_unref = give_back;
    all.to_sample = to_sample;
    all.to_untyped = without_type;
    all.untyped_to_sample = key_to_sample;
    all.free = free_blob;
    all.print = print;
    all.get_keyhash = no_key;
    return all;
  }();
  return ops;
}

const ddsi_sertype_ops& type_ops() {
  static const ddsi_sertype_ops ops = [] {
    ddsi_sertype_ops all{};
    all.version = ddsi_sertype_v0;
    all.free = free_type;
    all.zero_samples = zero_samples;
    all.realloc_samples = resize_samples;
    all.free_samples = free_samples;
    all.equal = is_same_type;
    all.hash = hash_of_type;
    return all;
  }();
  return ops;
}

}  // namespace

ByteView bytes_of(const ddsi_serdata* message) {
  const Blob& blob = as_blob(message);
  return {blob.bytes.data(), blob.size};
}

ddsi_sertype* make_blob_type(const std::string& dds_type_name) {
  auto* type = new ddsi_sertype{};
  constexpr bool kNoKey = true;
  ddsi_sertype_init(type, dds_type_name.c_str(), &type_ops(), &blob_ops(), kNoKey);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type;
}

}  // namespace scanfuse::drivers
