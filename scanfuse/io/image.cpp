#include "scanfuse/io/image.hpp"

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/image/codec.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

}  // namespace

Result<Image> parse_image(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return parse_png(bytes, name);
  if (bytes.starts_with("\xff\xd8\xff")) return parse_jpeg(bytes, name);
  if (bytes.empty()) return fail(Error::Code::kMalformed, "{}: the file is empty", name);
  return fail(Error::Code::kUnsupported,
              "{}: neither a PNG nor a JPEG image; convert it to one of them", name);
}

Result<Image> read_image(const std::filesystem::path& path) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  const auto bytes = read_start(**source, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return parse_image(*bytes, path.string());
}

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
  const auto bytes = print_png(image);
  if (!bytes) {
    return fail(bytes.error().code, "{}: {}", path.string(), bytes.error().message);
  }
  return write_whole(path, *bytes);
}

}  // namespace scanfuse::io
