#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::io {

/// Lines of text with their numbers. Takes \n, \r\n and a byte order mark. A line longer than 1 MiB
/// is passed over, a source that breaks ends the file: both counted as damage.
class LineReader {
 public:
  LineReader(std::string name, std::unique_ptr<ByteSource> source);
  [[nodiscard]] static Result<LineReader> open(const std::filesystem::path& path);

  /// The next line without its end; valid until the next call. Nothing at the end.
  std::optional<std::string_view> next(Diagnostics& diagnostics);

  /// Gives the last line once more.
  void put_back() { again_ = true; }
  /// The first line that is neither blank nor starts with #; it is still to be read.
  std::string_view peek_content(Diagnostics& diagnostics);

  [[nodiscard]] std::string packing() const { return std::string(source_->packing()); }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::int64_t line_number() const { return line_; }
  /// "points.csv:12"
  [[nodiscard]] std::string where() const;
  /// Set once the source has broken off.
  [[nodiscard]] const std::optional<Error>& broken() const { return broken_; }

 private:
  bool refill(Diagnostics& diagnostics);
  std::string_view finish(std::string_view line);

  std::string name_;
  std::unique_ptr<ByteSource> source_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what is not yet given out
  std::size_t end_ = 0;    ///< of what was read
  bool ended_ = false;
  bool again_ = false;
  std::string_view last_;
  std::int64_t line_ = 0;
  std::optional<Error> broken_;
};

}  // namespace scanfuse::io
