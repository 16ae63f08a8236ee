#include "scanfuse/io/pcd/pcd_header.hpp"

#include <algorithm>
#include <optional>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kMostPcdPoints = 200'000'000;
constexpr std::int64_t kMostPcdHeaderLines = 1000;

std::vector<std::string_view> pcd_words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t\r", i);
    if (begin == line.npos) break;
    i = std::min(line.find_first_of(" \t\r", begin), line.size());
    words.push_back(line.substr(begin, i - begin));
  }
  return words;
}

/// Collects the header's entries line by line.
class PcdHeaderReader {
 public:
  explicit PcdHeaderReader(const std::string& name) : name_(name) {}

  /// True once the DATA line was read.
  Result<bool> take(std::string_view line) {
    ++line_;
    const auto words = pcd_words(line);
    if (words.empty() || words[0].starts_with('#')) return false;
    const std::vector<std::string_view> values(words.begin() + 1, words.end());
    Result<void> outcome;
    if (words[0] == "FIELDS" || words[0] == "COLUMNS") {
      outcome = take_fields(values);
    } else if (words[0] == "SIZE" || words[0] == "TYPE" || words[0] == "COUNT") {
      outcome = take_layout(words[0], values);
    } else if (words[0] == "WIDTH" || words[0] == "HEIGHT" || words[0] == "POINTS") {
      outcome = take_size(words[0], values);
    } else if (words[0] == "VIEWPOINT") {
      header_.moved_viewpoint = !is_identity(values);
    } else if (words[0] == "DATA") {
      if (auto data = take_data(values); !data) return tl::unexpected(data.error());
      return true;
    } else if (words[0] != "VERSION") {
      return wrong("unknown entry '{:.40}'", words[0]);
    }
    if (!outcome) return tl::unexpected(outcome.error());
    return false;
  }

  Result<PcdHeader> finish() {
    if (header_.fields.empty()) return wrong("no FIELDS before DATA");
    if (!sizes_given_) return wrong("no SIZE before DATA");
    if (!types_given_) return wrong("no TYPE before DATA");
    for (PcdField& field : header_.fields) {
      field.offset = header_.point_bytes;
      field.column = header_.point_values;
      header_.point_bytes += field.size * field.count;
      header_.point_values += field.count;
    }
    if (!points_ && width_ && height_) points_ = *width_ * *height_;
    if (!points_) return wrong("neither POINTS nor WIDTH and HEIGHT before DATA");
    if (width_ && height_ && *width_ * *height_ != *points_) {
      return wrong("WIDTH {} x HEIGHT {} is not POINTS {}", *width_, *height_, *points_);
    }
    if (*points_ > kMostPcdPoints) return wrong("POINTS {} is more than 200 million", *points_);
    header_.points = *points_;
    header_.data_line = line_;
    return std::move(header_);
  }

 private:
  template <class... Args>
  tl::unexpected<Error> wrong(fmt::format_string<Args...> text, Args&&... args) const {
    return fail(Error::Code::kMalformed, "{}:{}: {}", name_, line_,
                fmt::format(text, std::forward<Args>(args)...));
  }

  Result<void> take_fields(const std::vector<std::string_view>& names) {
    if (!header_.fields.empty()) return wrong("FIELDS stands twice");
    if (names.empty() || names.size() > 1000) return wrong("FIELDS names {} columns", names.size());
    for (const auto field : names) header_.fields.push_back({std::string(field)});
    return {};
  }

  Result<void> take_layout(std::string_view entry, const std::vector<std::string_view>& values) {
    if (values.size() != header_.fields.size()) {
      return wrong("FIELDS names {} columns, {} {}", header_.fields.size(), entry, values.size());
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      PcdField& field = header_.fields[k];
      const auto number = parse_whole(values[k]);
      if (entry == "TYPE") {
        if (values[k] != "F" && values[k] != "I" && values[k] != "U") {
          return wrong("TYPE '{:.40}' is none of F, I, U", values[k]);
        }
        field.type = values[k][0];
      } else if (entry == "SIZE") {
        if (!number || (*number != 1 && *number != 2 && *number != 4 && *number != 8)) {
          return wrong("SIZE '{:.40}' is none of 1, 2, 4, 8", values[k]);
        }
        field.size = static_cast<std::size_t>(*number);
      } else {
        if (!number || *number < 0 || *number > 100'000) {
          return wrong("COUNT '{:.40}' is not in 0 .. 100000", values[k]);
        }
        field.count = static_cast<std::size_t>(*number);
      }
    }
    sizes_given_ = sizes_given_ || entry == "SIZE";
    types_given_ = types_given_ || entry == "TYPE";
    return {};
  }

  Result<void> take_size(std::string_view entry, const std::vector<std::string_view>& values) {
    const auto number = values.size() == 1 ? parse_whole(values[0]) : std::nullopt;
    if (!number || *number < 0 || *number > 2'000'000'000) {
      return wrong("{} needs one whole number, 0 .. 2000000000", entry);
    }
    (entry == "WIDTH"    ? width_
     : entry == "HEIGHT" ? height_
                         : points_) = static_cast<std::size_t>(*number);
    return {};
  }

  Result<void> take_data(const std::vector<std::string_view>& values) {
    using enum PcdHeader::Encoding;
    const std::string_view kind = values.empty() ? std::string_view{} : values[0];
    if (kind == "ascii") {
      header_.encoding = kAscii;
    } else if (kind == "binary") {
      header_.encoding = kBinary;
    } else if (kind == "binary_compressed") {
      header_.encoding = kBinaryCompressed;
    } else {
      return wrong("DATA '{:.40}' is none of ascii, binary, binary_compressed", kind);
    }
    return {};
  }

  static bool is_identity(const std::vector<std::string_view>& values) {
    constexpr double kIdentity[] = {0, 0, 0, 1, 0, 0, 0};
    if (values.size() != 7) return false;
    for (std::size_t k = 0; k < 7; ++k) {
      if (parse_number(values[k]) != kIdentity[k]) return false;
    }
    return true;
  }

  const std::string& name_;
  PcdHeader header_;
  std::int64_t line_ = 0;
  bool sizes_given_ = false;
  bool types_given_ = false;
  std::optional<std::size_t> width_, height_, points_;
};

}  // namespace

const PcdField* PcdHeader::find(std::string_view name) const {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const PcdField& field) {
    return field.name == name && field.count > 0;
  });
  return found == fields.end() ? nullptr : &*found;
}

bool is_pcd(std::string_view first_bytes) {
  while (first_bytes.starts_with('#')) {
    if (first_bytes.starts_with("# .PCD")) return true;
    const std::size_t end = first_bytes.find('\n');
    if (end == first_bytes.npos) return false;
    first_bytes.remove_prefix(end + 1);
  }
  for (const std::string_view entry : {"VERSION ", "VERSION\t", "FIELDS ", "FIELDS\t"}) {
    if (first_bytes.starts_with(entry)) return true;
  }
  return false;
}

Result<PcdHeader> parse_pcd_header(std::string_view file, const std::string& name) {
  PcdHeaderReader reader(name);
  std::size_t begin = 0;
  for (std::int64_t line = 0; begin < file.size() && line < kMostPcdHeaderLines; ++line) {
    const std::size_t end = std::min(file.find('\n', begin), file.size());
    const auto done = reader.take(file.substr(begin, end - begin));
    if (!done) return tl::unexpected(done.error());
    begin = std::min(end + 1, file.size());
    if (!*done) continue;
    auto header = reader.finish();
    if (header) header->data_offset = begin;
    return header;
  }
  return fail(Error::Code::kMalformed, "{}: no DATA line: the header is cut off, or this is no PCD",
              name);
}

}  // namespace scanfuse::io
