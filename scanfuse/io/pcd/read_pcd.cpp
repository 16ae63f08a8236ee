#include "scanfuse/io/pcd/read_pcd.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scanfuse/io/folder/scan_folder.hpp"
#include "scanfuse/io/pcd/lzf.hpp"
#include "scanfuse/io/pcd/pcd_header.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

static_assert(std::endian::native == std::endian::little, "PCD and KITTI files are little-endian");

/// The fields that a scan takes; null where the file has none.
struct PcdScanFields {
  const PcdField *x, *y, *z, *intensity, *layer, *beam, *time;
  double time_unit_s = 1;
};

PcdScanFields pick_pcd_fields(const PcdHeader& header) {
  const auto first = [&](std::initializer_list<std::string_view> names) -> const PcdField* {
    for (const auto name : names) {
      if (const PcdField* field = header.find(name)) return field;
    }
    return nullptr;
  };
  PcdScanFields fields{first({"x"}),
                       first({"y"}),
                       first({"z"}),
                       first({"intensity", "reflectivity", "i"}),
                       first({"ring", "layer", "laser", "channel", "profile"}),
                       first({"beam"}),
                       first({"time_offset", "time", "t"})};
  if (fields.time != nullptr && fields.time->type != 'F') {
    const bool nanoseconds = fields.time->name == "t" && fields.time->size == 4;
    if (!nanoseconds) fields.time = nullptr;
    fields.time_unit_s = 1e-9;
  }
  return fields;
}

template <class T>
double load_as(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return static_cast<double>(value);
}

double load_pcd_value(const PcdField& field, const char* from) {
  switch (field.type) {
    case 'F':
      return field.size == 4   ? load_as<float>(from)
             : field.size == 8 ? load_as<double>(from)
                               : std::nan("");
    case 'I':
      return field.size == 1   ? load_as<std::int8_t>(from)
             : field.size == 2 ? load_as<std::int16_t>(from)
             : field.size == 4 ? load_as<std::int32_t>(from)
                               : load_as<std::int64_t>(from);
    default:
      return field.size == 1   ? load_as<std::uint8_t>(from)
             : field.size == 2 ? load_as<std::uint16_t>(from)
             : field.size == 4 ? load_as<std::uint32_t>(from)
                               : load_as<std::uint64_t>(from);
  }
}

/// Makes a return of the values that `value(field)` gives; false where it is none.
template <class Value>
bool make_pcd_return(const PcdScanFields& fields, const Value& value, Return& r) {
  const double x = value(*fields.x), y = value(*fields.y);
  const double z = fields.z != nullptr ? value(*fields.z) : 0;
  const auto possible = [](double v) { return std::abs(v) <= kFarthestCoordinate_m; };
  if (!possible(x) || !possible(y) || !possible(z)) return false;
  r.x_m = static_cast<float>(x);
  r.y_m = static_cast<float>(y);
  r.z_m = static_cast<float>(z);
  if (fields.intensity != nullptr) {
    const double intensity = value(*fields.intensity);
    r.intensity = possible(intensity) ? static_cast<float>(intensity) : 0;
  }
  if (fields.layer != nullptr) {
    const double layer = value(*fields.layer);
    r.layer = layer >= 0 && layer <= INT16_MAX ? static_cast<std::int16_t>(layer) : std::int16_t{0};
  }
  if (fields.beam != nullptr) {
    const double beam = value(*fields.beam);
    r.beam = beam >= 0 && beam <= INT32_MAX ? static_cast<std::int32_t>(beam) : -1;
  }
  if (fields.time != nullptr) {
    const double offset_s = value(*fields.time) * fields.time_unit_s;
    r.time_offset_s = std::abs(offset_s) <= 10 ? static_cast<float>(offset_s) : 0;
  }
  return true;
}

/// One file in the making: header, bytes and what became of them.
struct PcdDecoding {
  const std::string& name;
  const PcdHeader& header;
  PcdScanFields fields;
  Diagnostics& diagnostics;
  Scan scan;
  std::int64_t not_finite = 0;

  template <class Value>
  void take(const Value& value) {
    Return r;
    if (make_pcd_return(fields, value, r)) {
      scan.returns.push_back(r);
    } else {
      ++not_finite;
    }
  }
};

/// Points one after the other; `bytes` may hold fewer than announced.
void decode_pcd_binary(PcdDecoding& decoding, std::string_view bytes) {
  const PcdHeader& header = decoding.header;
  const std::size_t whole = std::min(header.points, bytes.size() / header.point_bytes);
  if (whole < header.points) {
    decoding.diagnostics.damage(
        "cut off points",
        fmt::format("{}: byte {}: {} of {} points", decoding.name,
                    header.data_offset + bytes.size(), whole, header.points),
        static_cast<std::int64_t>(header.points - whole));
  }
  decoding.scan.returns.reserve(whole);
  for (std::size_t i = 0; i < whole; ++i) {
    const char* point = bytes.data() + i * header.point_bytes;
    decoding.take(
        [&](const PcdField& field) { return load_pcd_value(field, point + field.offset); });
  }
}

/// All values of a field, then those of the next, packed by LZF behind two sizes.
Result<void> decode_pcd_compressed(PcdDecoding& decoding, std::string_view bytes) {
  const PcdHeader& header = decoding.header;
  const auto broken = [&](std::string_view what) {
    return fail(Error::Code::kMalformed, "{}: byte {}: {}", decoding.name, header.data_offset,
                what);
  };
  if (bytes.size() < 8) return broken("the compressed points are cut off");
  const auto packed_size = static_cast<std::size_t>(load_as<std::uint32_t>(bytes.data()));
  const auto size = static_cast<std::size_t>(load_as<std::uint32_t>(bytes.data() + 4));
  if (packed_size > bytes.size() - 8) return broken("the compressed points are cut off");
  if (size != header.points * header.point_bytes) {
    return broken(fmt::format("{} bytes announced for {} points of {} bytes", size, header.points,
                              header.point_bytes));
  }
  const auto unpacked = unpack_lzf(bytes.substr(8, packed_size), size);
  if (!unpacked) return broken("the compressed points are damaged");
  decoding.scan.returns.reserve(header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    decoding.take([&](const PcdField& field) {
      const char* column = unpacked->data() + field.offset * header.points;
      return load_pcd_value(field, column + i * field.size * field.count);
    });
  }
  return {};
}

void decode_pcd_ascii(PcdDecoding& decoding, std::string_view text) {
  std::vector<std::string_view> words;
  std::int64_t line_number = decoding.header.data_line;
  std::size_t points = 0;
  while (!text.empty() && points < decoding.header.points) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    words.clear();
    for (std::size_t i = line.find_first_not_of(" \t\r"); i < line.size();
         i = line.find_first_not_of(" \t\r", i)) {
      const std::size_t stop = std::min(line.find_first_of(" \t\r", i), line.size());
      words.push_back(line.substr(i, stop - i));
      i = stop;
    }
    if (words.empty()) continue;
    ++points;
    bool readable = words.size() == decoding.header.point_values;
    const auto value = [&](const PcdField& field) {
      const std::string_view word = words[field.column];
      const auto number = parse_number(word);
      if (!number && word != "nan" && word != "-nan" && word != "inf" && word != "-inf" &&
          word != "NaN") {
        readable = false;
      }
      return number.value_or(std::nan(""));
    };
    const auto had = decoding.scan.returns.size();
    const auto had_not = decoding.not_finite;
    if (readable) decoding.take(value);
    if (!readable) {
      decoding.scan.returns.resize(had);
      decoding.not_finite = had_not;
      decoding.diagnostics.damage("bad row skipped",
                                  fmt::format("{}:{}: not {} numbers", decoding.name, line_number,
                                              decoding.header.point_values));
    }
  }
  if (points < decoding.header.points) {
    decoding.diagnostics.damage("cut off points",
                                fmt::format("{}:{}: {} of {} points", decoding.name, line_number,
                                            points, decoding.header.points),
                                static_cast<std::int64_t>(decoding.header.points - points));
  }
}

}  // namespace

Result<Scan> read_pcd(std::string_view file, const std::string& name, Diagnostics& diagnostics) {
  const auto header = parse_pcd_header(file, name);
  if (!header) return tl::unexpected(header.error());
  const PcdScanFields fields = pick_pcd_fields(*header);
  if (fields.x == nullptr || fields.y == nullptr) {
    return fail(Error::Code::kUnsupported, "{}: FIELDS has no x and y", name);
  }
  if (header->moved_viewpoint) diagnostics.note("VIEWPOINT not applied", name);
  PcdDecoding decoding{name, *header, fields, diagnostics, {}};
  const std::string_view data = file.substr(header->data_offset);
  if (header->points > 0 && data.empty()) {
    return fail(Error::Code::kMalformed, "{}: ends before its {} points", name, header->points);
  }
  switch (header->encoding) {
    case PcdHeader::Encoding::kAscii:
      decode_pcd_ascii(decoding, data);
      break;
    case PcdHeader::Encoding::kBinary:
      decode_pcd_binary(decoding, data);
      break;
    case PcdHeader::Encoding::kBinaryCompressed:
      if (auto done = decode_pcd_compressed(decoding, data); !done) {
        return tl::unexpected(done.error());
      }
  }
  if (decoding.not_finite > 0) {
    diagnostics.note("points that are not finite dropped", name, decoding.not_finite);
  }
  return std::move(decoding.scan);
}

Result<std::unique_ptr<RecordingReader>> open_pcd(const std::filesystem::path& path,
                                                  const OpenOptions& options) {
  ScanFolder folder;
  folder.path = path;
  folder.format = "pcd";
  folder.topic = "/points";
  folder.type = "pcd points";
  std::error_code ignored;
  const bool many = std::filesystem::is_directory(path, ignored);
  folder.files =
      stamp_files(path, many ? files_of(path, ".pcd") : std::vector{path}, folder.diagnostics);
  if (folder.files.empty()) {
    return fail(Error::Code::kNotFound, "{}: no .pcd file in it", path.string());
  }
  folder.read = read_pcd;
  return read_scan_folder(std::move(folder), options);
}

}  // namespace scanfuse::io
