#pragma once
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/lanes.h"
#include "photo/base/picture.h"

namespace seamwise {

/// Red, green, blue and opacity as numbers.
using PixelLanes = Lanes<float>::Vector;

/// Image reduced by an integer factor: the mean of factor x factor pixels, some rows at a time. A
/// factor of 1 copies nothing. Rows and columns that do not fill a pixel are omitted.
class ReducedPixels {
 public:
  ReducedPixels(const PixelView& pixels, int factor);
  /// Continues for about `pixels` pixels of the larger image; returns false when done.
  bool advance(int pixels);
  double fraction() const { return static_cast<double>(row_) / height_; }
  /// Valid once done. Point p of the larger image is at p / factor.
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

/// Interpolates the image at a place between the four nearest pixels, 0 to 255; returns false
/// outside.
bool bilinear(const PixelView& pixels, float x, float y, PixelLanes* value);

/// Interpolates between 4 x 4 pixels by cubics through them [Catmull and Rom 1974], which keeps
/// fine detail, without opacity. It uses four pixels at the border, where 4 x 4 are not available.
bool bicubic(const PixelView& pixels, float x, float y, PixelLanes* value);

}  // namespace seamwise
