#pragma once
#include <vector>

#include "base/lanes.h"
#include "photo/base/picture.h"
#include "photo/lattice/hidden_places.h"

namespace seamwise {

/// Three channels of an image side by side, and a zero, so that one instruction handles a pixel.
/// Places are in the plane of the whole image, as in `Picture`.
struct ChannelImage {
  using Pixel = Lanes<float>::Vector;

  int width = 0, height = 0;
  float scale = 1;  ///< relative to the whole image
  std::vector<float> samples;
  /// Places that do not count, if any; outlives their use.
  const HiddenPlaces* hidden = nullptr;

  static ChannelImage of(const Picture& picture);

  /// Value and slopes at a place, bilinear between four pixels.
  struct Patch {
    Pixel value, slope_x, slope_y;  ///< slopes per pixel of the whole image
  };
  /// Returns false for a place outside the image, or a hidden one.
  bool look(float x, float y, Patch& patch) const {
    const float column = x * scale - 0.5F, row = y * scale - 0.5F;
    if (!(column >= 0 && row >= 0 && column < static_cast<float>(width - 1) &&
          row < static_cast<float>(height - 1)))
      return false;
    if (hidden != nullptr && hidden->at(x, y)) return false;
    const int i = static_cast<int>(column), j = static_cast<int>(row);
    const float u = column - static_cast<float>(i), v = row - static_cast<float>(j);
    const float* corner = &samples[4 * (static_cast<std::size_t>(j) * width + i)];
    const Pixel a = loaded(corner), b = loaded(corner + 4);
    const Pixel c = loaded(corner + 4 * width), d = loaded(corner + 4 * width + 4);
    const Pixel top = a + u * (b - a), bottom = c + u * (d - c);
    patch.value = top + v * (bottom - top);
    patch.slope_x = ((1 - v) * (b - a) + v * (d - c)) * scale;
    patch.slope_y = (bottom - top) * scale;
    return true;
  }
};

}  // namespace seamwise
