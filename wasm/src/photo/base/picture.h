#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace seamwise {

/// Pixels of a camera or file: four bytes each (red, green, blue, opacity), gamma-coded sRGB, row
/// by row from the top. Pixel (x, y) covers the square from (x, y) to (x + 1, y + 1) of the image
/// plane, with x to the right and y down. The view does not own its memory.
struct PixelView {
  int width = 0, height = 0;
  std::span<const std::uint8_t> rgba;
};

/// Image as three planes of numbers, row by row from the top, in the plane of `PixelView` scaled by
/// `scale`: point p of the whole image is at scale * p here.
struct Picture {
  int width = 0, height = 0;
  double scale = 1;
  /// Red, green, blue, gamma-coded, in [0, 1], until `opponentChannels` replaces them.
  std::array<std::vector<float>, 3> planes;
};

}  // namespace seamwise
