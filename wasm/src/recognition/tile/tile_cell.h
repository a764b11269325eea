#pragma once
#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_map.h"
#include "recognition/base/picture.h"

namespace seamwise {

/// A picture that repeats edge to edge, with a line of pixels put in at its right or lower edge if
/// so asked: the mean of the last line and the first.
struct SeamlessTile {
  PixelView pixels;
  int more_columns = 0, more_rows = 0;
  int width() const { return pixels.width + more_columns; }
  int height() const { return pixels.height + more_rows; }
};

/// The cell of a flat lattice on a tile with n x n samples, from the pixels that lie around each.
CellPicture tileCell(const SeamlessTile& tile, const LatticeMap& map, int n);

}  // namespace seamwise
