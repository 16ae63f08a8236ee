#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
// jpeglib.h needs <cstdio> before it.
#include <jpeglib.h>

#include "scanfuse/io/image.hpp"

// JPEG files, as cameras write stripe images; made here by libjpeg's encoder.
namespace scanfuse::io {
namespace {

using testing::HasSubstr;

/// Brightness that changes slowly, so that the encoder keeps it nearly as it is.
Image smooth_image(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const double wave = std::sin(0.09 * x + c) * std::cos(0.07 * y);
        image.pixels.push_back(static_cast<std::uint8_t>(128 + 90 * wave));
      }
    }
  }
  return image;
}

std::string jpeg_of(const Image& image, J_COLOR_SPACE colours, bool progressive = false) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(image.width_px);
  jpeg.image_height = static_cast<JDIMENSION>(image.height_px);
  jpeg.input_components = image.channels;
  jpeg.in_color_space = colours;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 98, TRUE);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  auto pixels = image.pixels;
  const auto row_bytes = static_cast<std::size_t>(image.width_px * image.channels);
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = pixels.data() + jpeg.next_scanline * row_bytes;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string out(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);  // NOLINT(cppcoreguidelines-no-malloc): libjpeg's own
  return out;
}

TEST(Jpeg, GreyAndColourComeBackNearlyAsTheyWere) {
  for (const bool progressive : {false, true}) {
    for (const int channels : {1, 3}) {
      const Image image = smooth_image(53, 34, channels);
      const auto back = parse_image(
          jpeg_of(image, channels == 1 ? JCS_GRAYSCALE : JCS_RGB, progressive), "a.jpg");
      ASSERT_TRUE(back) << back.error().message;
      EXPECT_EQ(back->width_px, 53);
      EXPECT_EQ(back->height_px, 34);
      ASSERT_EQ(back->channels, channels);
      double squares = 0;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        squares += std::pow(back->pixels[i] - image.pixels[i], 2);
      }
      EXPECT_LT(std::sqrt(squares / static_cast<double>(image.pixels.size())), 3);
    }
  }
}

// A JPEG that was cut would else come back with a grey lower part.
TEST(Jpeg, EveryCutIsAnErrorThatNamesTheFile) {
  const std::string whole = jpeg_of(smooth_image(53, 34, 3), JCS_RGB);
  for (std::size_t size = 0; size + 2 < whole.size(); size += 7) {
    const auto image = parse_image(std::string_view(whole).substr(0, size), "cut.jpg");
    ASSERT_FALSE(image) << size;
    EXPECT_THAT(image.error().message, HasSubstr("cut.jpg"));
  }
}

TEST(Jpeg, FlippedBytesNeverCrash) {
  const std::string whole = jpeg_of(smooth_image(53, 34, 1), JCS_GRAYSCALE);
  for (std::size_t i = 2; i < whole.size(); ++i) {
    for (const int flip : {0x55, 0xff}) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ flip);
      const auto image = parse_image(bytes, "x.jpg");
      if (!image) {
        EXPECT_THAT(image.error().message, HasSubstr("x.jpg"));
      }
    }
  }
}

TEST(Jpeg, CmykIsRefusedWithARemedy) {
  const Image image = smooth_image(16, 16, 4);
  const auto parsed = parse_image(jpeg_of(image, JCS_CMYK), "print.jpg");
  ASSERT_FALSE(parsed);
  EXPECT_THAT(parsed.error().message, HasSubstr("print.jpg: a CMYK image; convert"));
}

}  // namespace
}  // namespace scanfuse::io
