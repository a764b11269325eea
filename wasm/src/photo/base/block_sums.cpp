#include "photo/base/block_sums.h"

namespace seamwise {

std::vector<std::uint32_t> blockSums(const PixelView& pixels, int factor, int row) {
  const int width = pixels.width / factor;
  const std::size_t stride = static_cast<std::size_t>(pixels.width) * 4;
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(width) * 4);
  for (int y = row * factor; y < (row + 1) * factor; ++y) {
    const std::uint8_t* pixel = pixels.rgba.data() + stride * y;
    std::uint32_t* sum = sums.data();
    for (int i = 0; i < width; ++i, sum += 4)
      for (int k = 0; k < factor; ++k, pixel += 4)
        for (int c = 0; c < 4; ++c) sum[c] += pixel[c];
  }
  return sums;
}

}  // namespace seamwise
