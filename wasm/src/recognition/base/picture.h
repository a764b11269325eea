#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace seamwise {

/// Pixels as cameras and files give them: four bytes each (red, green, blue, opacity), gamma-coded
/// sRGB, row by row from the top. Pixel (x, y) covers the square from (x, y) to (x + 1, y + 1) of
/// the picture's plane, in which x runs to the right and y down. Somebody else's memory.
struct PixelView {
  int width = 0, height = 0;
  std::span<const std::uint8_t> rgba;
};

/// A picture as three planes of numbers, row by row from the top, in the plane of `PixelView`
/// scaled by `scale`: a point p of the whole picture lies at scale * p here.
struct Picture {
  int width = 0, height = 0;
  double scale = 1;
  /// Red, green, blue, gamma-coded, in [0, 1], until `opponentChannels` replaces them.
  std::array<std::vector<float>, 3> planes;
};

}  // namespace seamwise
