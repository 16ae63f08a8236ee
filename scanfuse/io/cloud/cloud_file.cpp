#include "scanfuse/io/cloud/cloud_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/cloud/cloud_notes.hpp"
#include "scanfuse/io/cloud/point_taker.hpp"
#include "scanfuse/io/cloud/read_ply.hpp"
#include "scanfuse/io/document/document.hpp"
#include "scanfuse/io/pcd/pcd_header.hpp"
#include "scanfuse/io/pcd/read_pcd.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLargestCloud = std::size_t{1} << 31;

static_assert(std::endian::native == std::endian::little, "clouds are written little-endian");

template <class T>
void append(std::string& bytes, T value) {
  const auto* from = reinterpret_cast<const char*>(&value);
  bytes.append(from, sizeof value);
}

bool has_intensity(const Cloud& cloud) {
  return std::ranges::any_of(cloud.points,
                             [](const CloudPoint& p) { return std::isfinite(p.intensity); });
}

void append_points(std::string& bytes, const Cloud& cloud) {
  const bool intensity = has_intensity(cloud);
  for (const CloudPoint& point : cloud.points) {
    for (int k = 0; k < 3; ++k) append(bytes, point.position_m[k]);
    if (intensity) append(bytes, static_cast<float>(point.intensity));
    if (!cloud.has_profiles()) continue;
    append(bytes, std::int32_t{point.profile});
    append(bytes, std::int32_t{point.beam});
  }
}

/// Takes the comments that stand in front of a PCD's header; what is behind them.
Result<std::string_view> take_pcd_notes(std::string_view file, const std::string& name,
                                        Cloud& cloud) {
  for (int line = 1; file.starts_with('#'); ++line) {
    const std::size_t end = std::min(file.find('\n'), file.size());
    if (!take_cloud_note(file.substr(1, end - 1), cloud)) {
      return fail(Error::Code::kMalformed, "{}:{}: a scanfuse comment that cannot be understood",
                  name, line);
    }
    file.remove_prefix(std::min(end + 1, file.size()));
  }
  return file;
}

Result<Cloud> cloud_of_pcd(std::string_view file, const std::string& name,
                           Diagnostics& diagnostics) {
  Cloud cloud;
  const auto rest = take_pcd_notes(file, name, cloud);
  if (!rest) return tl::unexpected(rest.error());
  const auto scan = read_pcd(*rest, name, diagnostics);
  if (!scan) return tl::unexpected(scan.error());
  cloud.points.reserve(scan->returns.size());
  for (const Return& r : scan->returns) {
    cloud.points.push_back({{r.x_m, r.y_m, r.z_m}, r.intensity, r.layer, r.beam});
  }
  settle_profiles(cloud);
  return cloud;
}

}  // namespace

Result<Cloud> parse_cloud(std::string_view file, const std::string& name,
                          Diagnostics& diagnostics) {
  if (is_ply(file)) return parse_ply(file, name, diagnostics);
  if (is_pcd(file)) return cloud_of_pcd(file, name, diagnostics);
  return fail(Error::Code::kUnsupported,
              "{}: neither PLY nor PCD; give a cloud as `scanfuse "
              "assemble` writes it",
              name);
}

Result<Cloud> read_cloud(const std::filesystem::path& path, Diagnostics& diagnostics) {
  const auto bytes = read_document_text(path, kLargestCloud, "cloud");
  if (!bytes) return tl::unexpected(bytes.error());
  return parse_cloud(*bytes, path.string(), diagnostics);
}

std::string ply_bytes(const Cloud& cloud) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + cloud_notes(cloud, "comment ");
  bytes +=
      fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
                  cloud.points.size());
  if (has_intensity(cloud)) bytes += "property float intensity\n";
  if (cloud.has_profiles()) bytes += "property int profile\nproperty int beam\n";
  bytes += "end_header\n";
  append_points(bytes, cloud);
  return bytes;
}

std::string pcd_bytes(const Cloud& cloud) {
  std::string fields = "x y z", sizes = "8 8 8", types = "F F F", counts = "1 1 1";
  const auto add = [&](const char* names, const char* size, const char* type, const char* count) {
    fields += names;
    sizes += size;
    types += type;
    counts += count;
  };
  if (has_intensity(cloud)) add(" intensity", " 4", " F", " 1");
  if (cloud.has_profiles()) add(" profile beam", " 4 4", " I I", " 1 1");
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\n" + cloud_notes(cloud, "# ");
  bytes += fmt::format(
      "VERSION 0.7\nFIELDS {}\nSIZE {}\nTYPE {}\nCOUNT {}\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      fields, sizes, types, counts, cloud.points.size(), cloud.points.size());
  append_points(bytes, cloud);
  return bytes;
}

Result<void> write_cloud(const std::filesystem::path& path, const Cloud& cloud) {
  if (path.extension() == ".ply") return write_whole(path, ply_bytes(cloud));
  if (path.extension() == ".pcd") return write_whole(path, pcd_bytes(cloud));
  return fail(Error::Code::kUnsupported, "{}: write a cloud to a file ending in .ply or .pcd",
              path.string());
}

}  // namespace scanfuse::io
