#pragma once
#include "recognition/base/cell_picture.h"
#include "recognition/base/picture.h"

namespace seamwise {

/// The print on a parallelogram as pixels, the first row at its upper end: a corner, and its sides
/// as columns, in lattice coordinates of the cell.
Picture printPicture(const CellPicture& cell, const Mat2& sides, const Vec2& corner, int width,
                     int height);

}  // namespace seamwise
