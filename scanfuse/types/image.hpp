#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace scanfuse {

/// Eight bits a channel, rows from the top, channels interleaved (1 grey, 3 red green blue).
struct Image {
  int width_px = 0;
  int height_px = 0;
  int channels = 1;
  std::vector<std::uint8_t> pixels;  ///< width * height * channels

  [[nodiscard]] std::uint8_t at(int column, int row, int channel = 0) const {
    const auto place = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
                       static_cast<std::size_t>(column);
    return pixels[place * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel)];
  }
};

}  // namespace scanfuse
