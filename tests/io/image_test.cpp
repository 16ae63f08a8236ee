#include "scanfuse/io/image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cstring>

#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::io {
namespace {

using testing::HasSubstr;

Image pattern(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  RandomStream random(7);
  for (int i = 0; i < width * height * channels; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  return image;
}

/// A PNG of a kind that print_png does not make.
std::string other_png(int width, int height, int bits, int colour, const std::string& row) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &out,
      [](png_structp p, png_bytep from, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(from), count);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const png_color palette[2] = {{10, 20, 30}, {200, 100, 50}};
  if (colour == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
  png_write_info(png, info);
  for (int r = 0; r < height; ++r) {
    png_write_row(png, reinterpret_cast<const png_byte*>(row.data()));
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

TEST(Image, PngGivesBackWhatWasWritten) {
  for (const int channels : {1, 3}) {
    const Image image = pattern(37, 21, channels);
    const io_testing::TemporaryFolder folder;
    const auto path = folder.path() / "image.png";
    ASSERT_TRUE(write_png(path, image));
    const auto back = read_image(path);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->width_px, 37);
    EXPECT_EQ(back->height_px, 21);
    EXPECT_EQ(back->channels, channels);
    EXPECT_EQ(back->pixels, image.pixels);
  }
}

TEST(Image, EveryCutOfAPngIsAnErrorThatNamesTheFile) {
  const std::string whole = *print_png(pattern(20, 11, 3));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto image = parse_image(std::string_view(whole).substr(0, size), "cut.png");
    ASSERT_FALSE(image) << size;
    EXPECT_THAT(image.error().message, HasSubstr("cut.png"));
  }
}

TEST(Image, EveryFlippedByteOfPixelsIsNoticed) {
  const std::string whole = *print_png(pattern(20, 11, 1));
  for (std::size_t i = 60; i + 12 < whole.size(); i += 3) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
    EXPECT_FALSE(parse_image(bytes, "x.png")) << i;
  }
}

TEST(Image, PaletteAndFewBitsAreSpreadToEight) {
  const std::string bits(1, static_cast<char>(0b01000000));
  const auto palette = parse_image(other_png(2, 1, 1, PNG_COLOR_TYPE_PALETTE, bits), "palette.png");
  ASSERT_TRUE(palette) << palette.error().message;
  EXPECT_EQ(palette->channels, 3);
  EXPECT_THAT(palette->pixels, testing::ElementsAre(10, 20, 30, 200, 100, 50));
  const auto grey = parse_image(other_png(2, 1, 1, PNG_COLOR_TYPE_GRAY, bits), "grey.png");
  ASSERT_TRUE(grey) << grey.error().message;
  EXPECT_THAT(grey->pixels, testing::ElementsAre(0, 255));
}

TEST(Image, AlphaIsDropped) {
  const auto image = parse_image(
      other_png(1, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, std::string("\1\2\3\0", 4)), "a.png");
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->pixels, testing::ElementsAre(1, 2, 3));
}

TEST(Image, SixteenBitsAreRefusedWithARemedy) {
  const auto image =
      parse_image(other_png(2, 2, 16, PNG_COLOR_TYPE_GRAY, std::string("\1\2\3\4", 4)), "deep.png");
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("deep.png: 16 bits"));
}

TEST(Image, AHeaderThatPromisesTooMuchCostsNoMemory) {
  std::string bytes = *print_png(pattern(20, 11, 1));
  // Width and height of the header become 65535; its checksum is made anew.
  const unsigned char size[8] = {0, 0, 0xff, 0xff, 0, 0, 0xff, 0xff};
  std::memcpy(bytes.data() + 16, size, 8);
  std::uint32_t crc = 0xffffffff;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
  }
  crc = ~crc;
  for (std::size_t k = 0; k < 4; ++k) bytes[29 + k] = static_cast<char>(crc >> (24 - 8 * k));
  const auto image = parse_image(bytes, "huge.png");
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("65535 x 65535"));
}

TEST(Image, WhatIsNoImageIsSaidToBeNone) {
  EXPECT_THAT(parse_image("", "e").error().message, HasSubstr("empty"));
  EXPECT_THAT(parse_image("BM a bitmap", "b.bmp").error().message, HasSubstr("PNG nor a JPEG"));
  EXPECT_THAT(read_image("/no/such/file.png").error().message, HasSubstr("file.png"));
  EXPECT_FALSE(print_png(Image{3, 3, 1, {}}));
  EXPECT_FALSE(print_png(Image{1, 1, 2, {0, 0}}));
}

}  // namespace
}  // namespace scanfuse::io
