#pragma once
#include <optional>

#include "base/outcome.h"
#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_reading.h"
#include "recognition/base/picture.h"
#include "recognition/symmetry/group_reading.h"

namespace seamwise {

/// A picture that repeats edge to edge, read as one cell or several of a print.
struct TileReading {
  LatticeReading lattice;  ///< of the smallest cell inside, its origin in the lower left corner
  CellPicture cell;        ///< of that cell
  Mat2 gram = Mat2::Identity();  ///< of its w1, w2, in units of `sides`
  GroupReading groups;
};

/// Pixels are taken to be square, unless it is said what sides the picture has, or it is a square
/// whose thirds of a turn show that its sides are those of a hexagonal cell.
/// @param sides   Gram matrix of the sides to the right and up, where they are known [any unit]
/// Errors: kPicture, one sentence that says which edges do not meet, and where, or that the
/// picture is too small.
Outcome<TileReading> readTile(const PixelView& tile, const std::optional<Mat2>& sides = {});

}  // namespace seamwise
