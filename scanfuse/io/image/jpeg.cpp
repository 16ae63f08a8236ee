#include <csetjmp>
#include <cstdio>
#include <cstring>
// clang-format off: jpeglib.h needs <cstdio> before it, jerror.h needs jpeglib.h
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include "scanfuse/io/image/codec.hpp"

namespace scanfuse::io {
namespace {

/// More passes over the image than any encoder makes; a small file may ask for thousands.
constexpr int kMostScans = 100;

/// What libjpeg's callbacks share with their caller. libjpeg leaves through longjmp, so functions
/// that may be left so hold nothing with a destructor.
struct Session {
  jpeg_error_mgr errors{};  ///< first: libjpeg hands back its address
  jpeg_progress_mgr progress{};
  std::jmp_buf away{};
  char message[JMSG_LENGTH_MAX] = {};
};

void leave(j_common_ptr cinfo) {
  auto& session = *reinterpret_cast<Session*>(cinfo->err);
  session.errors.format_message(cinfo, session.message);
  std::longjmp(session.away, 1);
}

/// Warnings tell of damage that libjpeg would paint over, save for stray bytes between segments.
void on_message(j_common_ptr cinfo, int level) {
  if (level < 0 && cinfo->err->msg_code != JWRN_EXTRANEOUS_DATA) leave(cinfo);
}
void on_output(j_common_ptr /*cinfo*/) {}
void on_progress(j_common_ptr cinfo) {
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(cinfo);
  if (decoder->input_scan_number <= kMostScans) return;
  auto& session = *reinterpret_cast<Session*>(cinfo->err);
  std::strncpy(session.message, "too many scans", sizeof session.message - 1);
  std::longjmp(session.away, 1);
}

class Reader {
 public:
  Reader() {
    jpeg_.err = jpeg_std_error(&session_.errors);
    session_.errors.error_exit = leave;
    session_.errors.emit_message = on_message;
    session_.errors.output_message = on_output;
    session_.progress.progress_monitor = on_progress;
  }
  ~Reader() { jpeg_destroy_decompress(&jpeg_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  [[nodiscard]] const char* message() const { return session_.message; }
  [[nodiscard]] const jpeg_decompress_struct& header() const { return jpeg_; }

  [[nodiscard]] bool read_header(std::string_view bytes) {
    if (setjmp(session_.away) != 0) return false;  // NOLINT(cert-err52-cpp)
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &session_.progress;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }

  /// After read_header; `pixels` has room for all of them.
  [[nodiscard]] bool read_rows(std::uint8_t* pixels, std::size_t row_bytes) {
    if (setjmp(session_.away) != 0) return false;  // NOLINT(cert-err52-cpp)
    jpeg_.out_color_space = jpeg_.jpeg_color_space == JCS_GRAYSCALE ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = pixels + static_cast<std::size_t>(jpeg_.output_scanline) * row_bytes;
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

 private:
  Session session_;
  jpeg_decompress_struct jpeg_{};
};

/// A block of 8 x 8 pixels takes at least a bit: a file too small for its image is found out before
/// the memory is asked for.
bool may_hold(std::size_t bytes, std::uint64_t pixels) {
  return pixels / 2048 <= std::uint64_t{bytes};
}

Result<void> check(const jpeg_decompress_struct& header, std::size_t bytes,
                   const std::string& name) {
  if (header.jpeg_color_space == JCS_CMYK || header.jpeg_color_space == JCS_YCCK) {
    return fail(Error::Code::kUnsupported, "{}: a CMYK image; convert it to RGB or grey", name);
  }
  if (header.jpeg_color_space == JCS_UNKNOWN) {
    return fail(Error::Code::kUnsupported, "{}: {} channels of unknown colour; convert it to RGB",
                name, header.num_components);
  }
  const std::uint64_t pixels = std::uint64_t{header.image_width} * header.image_height;
  if (pixels > kMostPixels) {
    return fail(Error::Code::kUnsupported, "{}: {} x {} pixels are more than the {} that are read",
                name, header.image_width, header.image_height, kMostPixels);
  }
  if (!may_hold(bytes, pixels)) {
    return fail(Error::Code::kMalformed, "{}: {} bytes cannot hold {} x {} pixels; the file is cut",
                name, bytes, header.image_width, header.image_height);
  }
  return {};
}

}  // namespace

Result<Image> parse_jpeg(std::string_view bytes, const std::string& name) {
  const auto damaged = [&](const char* message) {
    return fail(Error::Code::kMalformed, "{}: damaged JPEG: {}; copy or record it anew", name,
                message);
  };
  Reader reader;
  if (!reader.read_header(bytes)) return damaged(reader.message());
  if (auto fine = check(reader.header(), bytes.size(), name); !fine) {
    return tl::unexpected(fine.error());
  }
  Image image;
  image.width_px = static_cast<int>(reader.header().image_width);
  image.height_px = static_cast<int>(reader.header().image_height);
  image.channels = reader.header().jpeg_color_space == JCS_GRAYSCALE ? 1 : 3;
  const std::size_t row_bytes =
      static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.channels);
  image.pixels.resize(row_bytes * static_cast<std::size_t>(image.height_px));
  if (!reader.read_rows(image.pixels.data(), row_bytes)) return damaged(reader.message());
  return image;
}

}  // namespace scanfuse::io
