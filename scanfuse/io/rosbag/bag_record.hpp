#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"

namespace scanfuse::io::rosbag {

/// What a record is for: its field `op`. Numbers as the bag format defines them.
enum class Op : std::uint8_t {
  kNone = 0,
  kMessage = 2,
  kBagHeader = 3,
  kIndexData = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

/// The `name=value` fields of a record's header. Views into the bytes it was parsed from.
class RecordFields {
 public:
  [[nodiscard]] static Result<RecordFields> parse(std::span<const std::byte> bytes);

  [[nodiscard]] std::optional<std::span<const std::byte>> find(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;  ///< empty where missing
  [[nodiscard]] std::optional<std::uint32_t> u32(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint64_t> u64(std::string_view name) const;
  [[nodiscard]] std::optional<Time> time(std::string_view name) const;
  [[nodiscard]] Op op() const;

 private:
  struct Entry {
    std::string_view name;
    std::span<const std::byte> value;
  };
  std::vector<Entry> entries_;
};

/// Little-endian number at the start of `bytes`, which must be long enough.
[[nodiscard]] std::uint32_t load_u32(std::span<const std::byte> bytes);

/// A record in memory: header fields and data.
struct RecordView {
  RecordFields fields;
  std::span<const std::byte> data;
  std::size_t bytes = 0;  ///< length of the whole record
};

/// The record at the start of `bytes`.
[[nodiscard]] Result<RecordView> view_record(std::span<const std::byte> bytes);

/// A record in the file whose data have not been read.
struct FileRecord {
  std::vector<std::byte> header;
  RecordFields fields;  ///< views into `header`
  std::uint64_t data_begin = 0;
  std::uint64_t data_bytes = 0;
  bool whole = true;  ///< false: the file ends before the data do; data_bytes is what is left
  [[nodiscard]] std::uint64_t end() const { return data_begin + data_bytes; }
};

/// Reads pieces of a bag by place.
class BagFile {
 public:
  BagFile(std::unique_ptr<std::istream> stream, std::filesystem::path name);
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& name() const { return name_; }
  [[nodiscard]] Result<std::vector<std::byte>> read(std::uint64_t offset, std::uint64_t count);
  /// The record at `offset`; fails unless its header is whole.
  [[nodiscard]] Result<FileRecord> record_at(std::uint64_t offset);
  /// "drive.bag: byte 4117", for messages.
  [[nodiscard]] std::string place(std::uint64_t offset) const;

 private:
  std::unique_ptr<std::istream> stream_;
  std::filesystem::path name_;
  std::uint64_t size_ = 0;
};

}  // namespace scanfuse::io::rosbag
