#pragma once
#include "base/outcome.h"
#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_reading.h"
#include "recognition/base/picture.h"
#include "recognition/symmetry/group_reading.h"

namespace seamwise {

/// A picture that repeats edge to edge, read as one cell or several of a print: pixels are square.
struct TileReading {
  LatticeReading lattice;  ///< of the smallest cell inside, its origin in the lower left corner
  CellPicture cell;        ///< of that cell
  Mat2 gram = Mat2::Identity();  ///< of its w1, w2. [px^2]
  GroupReading groups;
};

/// Errors: kPicture, one sentence that says which edges do not meet, and where, or that the
/// picture is too small.
Outcome<TileReading> readTile(const PixelView& tile);

}  // namespace seamwise
