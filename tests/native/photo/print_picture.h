#pragma once
#include <algorithm>

#include "photo/base/cell_picture.h"
#include "photo/base/picture.h"
#include "photo/base/repeating_place.h"

namespace seamwise::testing {

/// Draws the print on a parallelogram as pixels, the first row at its upper end. The corner and the
/// sides, as columns, are in lattice coordinates of the cell.
inline Picture printPicture(const CellPicture& cell, const Mat2& sides, const Vec2& corner,
                            int width, int height) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  for (auto& plane : picture.planes) plane.resize(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 share((x + 0.5) / width, 1 - (y + 0.5) / height);
      const Vec2 p = (corner + sides * share) * cell.n;
      const RepeatingPlace place{RepeatingReach(p.x(), cell.n), RepeatingReach(p.y(), cell.n)};
      const std::size_t at = static_cast<std::size_t>(y) * width + x;
      for (int c = 0; c < 3; ++c) {
        picture.planes[c][at] = std::clamp(place.of(cell.planes[c], cell.n), 0.0f, 1.0f);
      }
    }
  }
  return picture;
}

}  // namespace seamwise::testing
