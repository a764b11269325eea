#pragma once
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/lanes.h"
#include "recognition/base/picture.h"

namespace seamwise {

/// Red, green, blue and opacity as numbers.
using PixelLanes = Lanes<float>::Vector;

/// Pixels made smaller by a whole factor, by the mean of factor x factor pixels, some rows at a
/// time; a factor of 1 copies nothing. Rows and columns that do not fill a pixel are left out.
class ReducedPixels {
 public:
  ReducedPixels(const PixelView& pixels, int factor);
  /// Goes on for about that many pixels of the larger picture; false when nothing is left to do.
  bool advance(int pixels);
  double fraction() const { return static_cast<double>(row_) / height_; }
  /// Once done. A place p of the larger picture lies at p / factor.
  PixelView view() const;
  int factor() const { return factor_; }

 private:
  PixelView pixels_;
  int factor_, width_, height_;
  int row_ = 0;
  std::vector<std::uint8_t> rgba_;
};

namespace internal {

/// One pixel as numbers from 0 to 255.
inline PixelLanes pixelAt(const std::uint8_t* rgba) {
  using Bytes __attribute__((vector_size(4))) = std::uint8_t;
  Bytes bytes;
  std::memcpy(&bytes, rgba, 4);
  return __builtin_convertvector(bytes, PixelLanes);
}

}  // namespace internal

/// The picture at a place, 0 to 255, between the four nearest pixels; false when that is outside.
bool bilinear(const PixelView& pixels, float x, float y, PixelLanes* value);

/// The same between 4 x 4 pixels by cubics that pass through them [Catmull and Rom 1974], which
/// keeps fine detail, without opacity; at the border, where there are no 4 x 4, between four.
bool bicubic(const PixelView& pixels, float x, float y, PixelLanes* value);

}  // namespace seamwise
