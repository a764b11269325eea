#pragma once
#include <optional>

#include "base/outcome.h"
#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_reading.h"
#include "recognition/base/picture.h"
#include "recognition/symmetry/group_reading.h"
#include "recognition/tile/tile_edges.h"

namespace seamwise {

/// How a picture meets its copies, repeated straight, in half-drop and as bricks.
struct TileSeams {
  TileEdge across, up;          ///< its left and right edges, and its upper and lower ones
  TileEdge half_drop, brick;    ///< left and right where the next copy lies half a side down, ...
  bool missing_column = false;  ///< only its symmetries show that a line of pixels is missing
  bool missing_row = false;
};

/// A picture that repeats edge to edge, read as one cell or several of a print.
struct TileReading {
  LatticeReading lattice;  ///< of the smallest cell inside, its origin in the lower left corner
  CellPicture cell;        ///< of that cell
  Mat2 gram = Mat2::Identity();  ///< of its w1, w2, in units of `sides`
  GroupReading groups;
  TileSeams seams;  ///< where these were asked for
};

/// What is known of a picture, and asked for.
struct TileQuestion {
  /// Gram matrix of the sides to the right and up, where they are known [any unit].
  std::optional<Mat2> sides;
  /// It repeats edge to edge whether these meet or not, and the reading says whether they do.
  bool any_edges = false;
};

/// Pixels are taken to be square, unless it is said what sides the picture has, or it is a square
/// whose thirds of a turn show that its sides are those of a hexagonal cell.
/// Errors: kPicture, one sentence that says which edges do not meet, and where, or that the
/// picture is too small.
Outcome<TileReading> readTile(const PixelView& tile, const TileQuestion& question = {});

}  // namespace seamwise
