#include <png.h>

#include <csetjmp>
#include <cstring>
#include <utility>
#include <vector>

#include "scanfuse/io/image.hpp"
#include "scanfuse/io/image/codec.hpp"

namespace scanfuse::io {
namespace {

/// What libpng's callbacks share with their caller. libpng leaves through longjmp, so functions
/// below that may be left so hold nothing with a destructor.
struct Session {
  std::string_view bytes;      ///< reading: what is still to be read
  std::string* out = nullptr;  ///< writing
  std::jmp_buf away{};
  char message[160] = {};
};

void on_error(png_structp png, png_const_charp text) {
  auto& session = *static_cast<Session*>(png_get_error_ptr(png));
  std::strncpy(session.message, text, sizeof session.message - 1);
  std::longjmp(session.away, 1);
}
void on_warning(png_structp /*png*/, png_const_charp /*text*/) {}

void take_bytes(png_structp png, png_bytep into, std::size_t count) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  if (session.bytes.size() < count) png_error(png, "the file is cut short");
  std::memcpy(into, session.bytes.data(), count);
  session.bytes.remove_prefix(count);
}
void give_bytes(png_structp png, png_bytep from, std::size_t count) {
  auto& session = *static_cast<Session*>(png_get_io_ptr(png));
  session.out->append(reinterpret_cast<const char*>(from), count);
}
void flush(png_structp /*png*/) {}

struct Header {
  png_uint_32 width = 0, height = 0;
  int bits = 0, colour = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) {
    session_.bytes = bytes;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &session_, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  [[nodiscard]] const char* message() const { return session_.message; }

  [[nodiscard]] bool read_header(Header& header) {
    if (png_ == nullptr || info_ == nullptr) return false;
    if (setjmp(session_.away) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_read_fn(png_, &session_, take_bytes);
    png_set_user_limits(png_, 1U << 20, 1U << 20);
    png_set_chunk_cache_max(png_, 64);
    png_set_chunk_malloc_max(png_, 1U << 20);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
    png_read_info(png_, info_);
    png_get_IHDR(png_, info_, &header.width, &header.height, &header.bits, &header.colour, nullptr,
                 nullptr, nullptr);
    return true;
  }

  /// After read_header. `rows` points to as many rows as the image has, wide enough.
  [[nodiscard]] bool read_rows(const Header& header, std::uint8_t** rows, std::size_t row_bytes) {
    if (setjmp(session_.away) != 0) return false;  // NOLINT(cert-err52-cpp)
    if (header.colour == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (header.colour == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png_);
    png_set_strip_alpha(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    if (png_get_rowbytes(png_, info_) != row_bytes) png_error(png_, "unusual kind of pixels");
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

 private:
  Session session_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

std::vector<std::uint8_t*> rows_of(Image& image) {
  std::vector<std::uint8_t*> rows(static_cast<std::size_t>(image.height_px));
  const std::size_t length = image.pixels.size() / rows.size();
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = image.pixels.data() + r * length;
  return rows;
}

/// Deflate packs no more than 1032 to 1: a file too small for its image is found out before the
/// memory is asked for.
bool may_hold(std::size_t bytes, const Header& header) {
  const std::uint64_t bits =
      std::uint64_t{header.width} * header.height * static_cast<std::uint64_t>(header.bits);
  return bits / 8 <= std::uint64_t{1040} * bytes;
}

Result<void> check(const Header& header, std::size_t bytes, const std::string& name) {
  if (header.bits == 16) {
    return fail(Error::Code::kUnsupported,
                "{}: 16 bits a channel; scale it to 8 bits by what the camera's counts fill", name);
  }
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  if (pixels > kMostPixels) {
    return fail(Error::Code::kUnsupported, "{}: {} x {} pixels are more than the {} that are read",
                name, header.width, header.height, kMostPixels);
  }
  if (!may_hold(bytes, header)) {
    return fail(Error::Code::kMalformed, "{}: {} bytes cannot hold {} x {} pixels; the file is cut",
                name, bytes, header.width, header.height);
  }
  return {};
}

tl::unexpected<Error> damaged(const std::string& name, const char* message) {
  return fail(Error::Code::kMalformed, "{}: damaged PNG: {}; copy or record it anew", name,
              *message != '\0' ? message : "no memory");
}

/// One row as it leaves; false where libpng gave up.
bool write_rows(png_structp png, png_infop info, Session& session, const Image& image) {
  if (setjmp(session.away) != 0) return false;  // NOLINT(cert-err52-cpp)
  png_set_write_fn(png, &session, give_bytes, flush);
  // Noise does not pack: the fast end loses 5 % of size and saves most of the time.
  png_set_compression_level(png, 1);
  png_set_filter(png, 0, PNG_FILTER_SUB);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width_px),
               static_cast<png_uint_32>(image.height_px), 8,
               image.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const std::size_t length = image.pixels.size() / static_cast<std::size_t>(image.height_px);
  for (int r = 0; r < image.height_px; ++r) {
    png_write_row(png, image.pixels.data() + static_cast<std::size_t>(r) * length);
  }
  png_write_end(png, info);
  return true;
}

bool well_formed(const Image& image) {
  return image.width_px > 0 && image.height_px > 0 &&
         (image.channels == 1 || image.channels == 3) &&
         image.pixels.size() == static_cast<std::size_t>(image.width_px) *
                                    static_cast<std::size_t>(image.height_px) *
                                    static_cast<std::size_t>(image.channels);
}

}  // namespace

Result<Image> parse_png(std::string_view bytes, const std::string& name) {
  Reader reader(bytes);
  Header header;
  if (!reader.read_header(header)) return damaged(name, reader.message());
  if (auto fine = check(header, bytes.size(), name); !fine) return tl::unexpected(fine.error());
  Image image;
  image.width_px = static_cast<int>(header.width);
  image.height_px = static_cast<int>(header.height);
  const bool grey =
      header.colour == PNG_COLOR_TYPE_GRAY || header.colour == PNG_COLOR_TYPE_GRAY_ALPHA;
  image.channels = grey ? 1 : 3;
  const std::size_t row_bytes =
      static_cast<std::size_t>(header.width) * static_cast<std::size_t>(image.channels);
  image.pixels.resize(row_bytes * header.height);
  auto rows = rows_of(image);
  if (!reader.read_rows(header, rows.data(), row_bytes)) return damaged(name, reader.message());
  return image;
}

Result<std::string> print_png(const Image& image) {
  if (!well_formed(image)) {
    return fail(Error::Code::kOutOfRange,
                "an image of {} x {} pixels, {} channels, {} bytes is none", image.width_px,
                image.height_px, image.channels, image.pixels.size());
  }
  std::string out;
  Session session;
  session.out = &out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  const bool done = info != nullptr && write_rows(png, info, session, image);
  png_destroy_write_struct(&png, &info);
  if (!done) return fail(Error::Code::kOutOfRange, "no PNG could be made: {}", session.message);
  return out;
}

}  // namespace scanfuse::io
