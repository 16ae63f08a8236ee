#include "scanfuse/io/cloud/read_ply.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "scanfuse/io/cloud/cloud_notes.hpp"
#include "scanfuse/io/cloud/point_taker.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is read little-endian");

struct PlyType {
  std::string_view name;
  std::size_t size;
  char kind;  ///< 'i' signed, 'u' unsigned, 'f' floating
};
constexpr std::array<PlyType, 16> kPlyTypes{{{"char", 1, 'i'},
                                             {"int8", 1, 'i'},
                                             {"uchar", 1, 'u'},
                                             {"uint8", 1, 'u'},
                                             {"short", 2, 'i'},
                                             {"int16", 2, 'i'},
                                             {"ushort", 2, 'u'},
                                             {"uint16", 2, 'u'},
                                             {"int", 4, 'i'},
                                             {"int32", 4, 'i'},
                                             {"uint", 4, 'u'},
                                             {"uint32", 4, 'u'},
                                             {"float", 4, 'f'},
                                             {"float32", 4, 'f'},
                                             {"double", 8, 'f'},
                                             {"float64", 8, 'f'}}};

struct PlyProperty {
  const PlyType* type = nullptr;
  double RawCloudPoint::* target = nullptr;  ///< null: passed over
};
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  bool has_list = false;

  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& property : properties) sum += property.type->size;
    return sum;
  }
};
struct PlyHeader {
  bool ascii = false;
  std::vector<PlyElement> elements;
  std::size_t data_offset = 0;
  int lines = 0;
};

double RawCloudPoint::* ply_target(std::string_view name) {
  if (name == "x") return &RawCloudPoint::x;
  if (name == "y") return &RawCloudPoint::y;
  if (name == "z") return &RawCloudPoint::z;
  if (name == "intensity" || name == "scalar_intensity" || name == "scalar_Intensity") {
    return &RawCloudPoint::intensity;
  }
  if (name == "profile") return &RawCloudPoint::profile;
  if (name == "beam") return &RawCloudPoint::beam;
  return nullptr;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t i = line.find_first_not_of(" \t\r"); i < line.size();
       i = line.find_first_not_of(" \t\r", i)) {
    const std::size_t stop = std::min(line.find_first_of(" \t\r", i), line.size());
    words.push_back(line.substr(i, stop - i));
    i = stop;
  }
  return words;
}

/// One header line; an error says what is wrong with it.
Result<void> take_ply_line(std::string_view line, PlyHeader& header, Cloud& cloud) {
  const auto words = words_of(line);
  const auto wrong = [&](std::string_view what) {
    return fail(Error::Code::kMalformed, "{}", what);
  };
  if (words.empty() || words[0] == "obj_info") return {};
  if (words[0] == "comment") {
    if (take_cloud_note(line.substr(line.find("comment") + 7), cloud)) return {};
    return wrong("a scanfuse comment that cannot be understood");
  }
  if (words[0] == "format" && words.size() >= 2) {
    header.ascii = words[1] == "ascii";
    if (header.ascii || words[1] == "binary_little_endian") return {};
    return wrong("only ascii and binary_little_endian can be read; convert the file");
  }
  if (words[0] == "element" && words.size() == 3) {
    const auto count = parse_whole(words[2]);
    if (!count || *count < 0) return wrong("an element's count is no whole number");
    header.elements.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}, false});
    return {};
  }
  if (words[0] != "property" || words.size() < 3 || header.elements.empty()) {
    return wrong("not understood");
  }
  PlyElement& element = header.elements.back();
  if (words[1] == "list") {
    element.has_list = true;
    return {};
  }
  const auto* type = std::ranges::find(kPlyTypes, words[1], &PlyType::name);
  if (type == kPlyTypes.end()) return wrong("a property's type is unknown");
  element.properties.push_back({type, element.name == "vertex" ? ply_target(words[2]) : nullptr});
  return {};
}

Result<PlyHeader> parse_ply_header(std::string_view file, const std::string& name, Cloud& cloud) {
  PlyHeader header;
  while (header.data_offset < file.size()) {
    const std::size_t end = std::min(file.find('\n', header.data_offset), file.size());
    const std::string_view line =
        trimmed(file.substr(header.data_offset, end - header.data_offset));
    header.data_offset = std::min(end + 1, file.size());
    ++header.lines;
    if (line == "end_header") return header;
    if (header.lines == 1) continue;
    if (auto taken = take_ply_line(line, header, cloud); !taken) {
      return fail(Error::Code::kMalformed, "{}:{}: {}", name, header.lines, taken.error().message);
    }
  }
  return fail(Error::Code::kMalformed, "{}: the header has no end_header; is the file cut off?",
              name);
}

double load_ply_value(const PlyType& type, const char* from) {
  const auto load = [&](auto value) {
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
  };
  if (type.kind == 'f') return type.size == 4 ? load(float{}) : load(double{});
  if (type.kind == 'i') {
    return type.size == 1   ? load(std::int8_t{})
           : type.size == 2 ? load(std::int16_t{})
                            : load(std::int32_t{});
  }
  return type.size == 1   ? load(std::uint8_t{})
         : type.size == 2 ? load(std::uint16_t{})
                          : load(std::uint32_t{});
}

/// Vertices as they are read, and what became of them.
struct PlyVertices {
  Cloud& cloud;
  std::int64_t not_finite = 0;
  std::size_t read = 0;

  void take(const RawCloudPoint& raw) {
    ++read;
    if (!take_cloud_point(raw, cloud)) ++not_finite;
  }
};

void read_binary(const PlyElement& vertex, std::string_view bytes, PlyVertices& vertices) {
  const std::size_t size = vertex.bytes();
  const std::size_t whole = size > 0 ? std::min(vertex.count, bytes.size() / size) : 0;
  vertices.cloud.points.reserve(whole);
  for (std::size_t i = 0; i < whole; ++i) {
    const char* from = bytes.data() + i * size;
    RawCloudPoint raw;
    for (const PlyProperty& property : vertex.properties) {
      if (property.target != nullptr) raw.*property.target = load_ply_value(*property.type, from);
      from += property.type->size;
    }
    vertices.take(raw);
  }
}

/// Lines of `skip` elements before, then the vertices. The number of a line that is none, or 0.
int read_ascii(const PlyElement& vertex, std::size_t skip, std::string_view text, int line_number,
               PlyVertices& vertices) {
  while (!text.empty() && vertices.read < vertex.count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    if (words.empty()) continue;
    if (skip > 0) {
      --skip;
      continue;
    }
    if (words.size() < vertex.properties.size()) return line_number;
    RawCloudPoint raw;
    for (std::size_t k = 0; k < vertex.properties.size(); ++k) {
      if (vertex.properties[k].target == nullptr) continue;
      raw.*vertex.properties[k].target = parse_number(words[k]).value_or(std::nan(""));
    }
    vertices.take(raw);
  }
  return 0;
}

/// Places of the vertices, and how much stands before them.
struct PlyLayout {
  const PlyElement* vertex = nullptr;
  std::size_t bytes_before = 0;
  std::size_t lines_before = 0;
};

Result<PlyLayout> find_vertices(const PlyHeader& header, const std::string& name) {
  PlyLayout layout;
  for (const PlyElement& element : header.elements) {
    const bool vertex = element.name == "vertex";
    if (element.has_list && (vertex || !header.ascii)) {
      return fail(Error::Code::kUnsupported, "{}: lists before or in the vertices cannot be read",
                  name);
    }
    if (vertex) {
      layout.vertex = &element;
      break;
    }
    if (element.count > (std::size_t{1} << 40) / std::max<std::size_t>(element.bytes(), 1)) {
      return fail(Error::Code::kMalformed, "{}: an element's count is out of bounds", name);
    }
    layout.bytes_before += element.count * element.bytes();
    layout.lines_before += element.count;
  }
  const auto has = [&](double RawCloudPoint::* target) {
    return layout.vertex != nullptr &&
           std::ranges::find(layout.vertex->properties, target, &PlyProperty::target) !=
               layout.vertex->properties.end();
  };
  if (has(&RawCloudPoint::x) && has(&RawCloudPoint::y) && has(&RawCloudPoint::z)) return layout;
  return fail(Error::Code::kUnsupported, "{}: no element vertex with x, y and z", name);
}

}  // namespace

bool is_ply(std::string_view first_bytes) {
  return first_bytes.starts_with("ply\n") || first_bytes.starts_with("ply\r");
}

Result<Cloud> parse_ply(std::string_view file, const std::string& name, Diagnostics& diagnostics) {
  Cloud cloud;
  const auto header = parse_ply_header(file, name, cloud);
  if (!header) return tl::unexpected(header.error());
  const auto layout = find_vertices(*header, name);
  if (!layout) return tl::unexpected(layout.error());
  PlyVertices vertices{cloud};
  const std::string_view data = file.substr(header->data_offset);
  if (header->ascii) {
    const int bad =
        read_ascii(*layout->vertex, layout->lines_before, data, header->lines, vertices);
    if (bad > 0) {
      diagnostics.damage("bad row ends the points", fmt::format("{}:{}", name, bad));
    }
  } else {
    read_binary(*layout->vertex, data.substr(std::min(layout->bytes_before, data.size())),
                vertices);
  }
  if (vertices.read < layout->vertex->count) {
    diagnostics.damage("cut off points", fmt::format("{}: {} of {} points", name, vertices.read,
                                                     layout->vertex->count));
  }
  if (vertices.not_finite > 0) {
    diagnostics.note("points that are not finite dropped", name, vertices.not_finite);
  }
  settle_profiles(cloud);
  return cloud;
}

}  // namespace scanfuse::io
