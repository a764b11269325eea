#pragma once
#include <vector>

#include "marker/pieces_on_board.h"

namespace seamwise {

/// The position of an item: one of its ways at a dot.
struct LayPlace {
  int way = -1;  ///< -1: not placed
  Dot dot;
};

/// Positions of all items. [cm]
struct LaidPieces {
  std::vector<LayPlace> places;
  double bottom = 0, top = 0;
  double length() const { return top - bottom; }
};

/// The fabric for a board's pieces, and the position of the print on it.
struct LayFabric {
  double left = 0, right = 0;    ///< bounds of the usable part. [cm]
  Vec2 origin = Vec2::Zero();    ///< origin of the print, and so of the board. [cm]
  bool is_fixed = false;         ///< the cut is at 0; false: it is at the start of the layout
  std::vector<int> turned_down;  ///< per garment, 1 if its pieces must point down, 0 if up; empty:
                                 ///< both are allowed
  bool is_by_garment = false;    ///< all pieces of a garment must point the same way
};

/// Computes the ends of a layout, which starts at 0 if the cut is fixed.
void measure(const PiecesOnBoard& pieces, const LayFabric& fabric, LaidPieces* layout);

/// Indices of the allowed ways of every item.
std::vector<std::vector<int>> allowedWays(const PiecesOnBoard& pieces, const LayFabric& fabric);

/// Possible start heights of a layout within one repeat: those of a lowest piece, or one height if
/// the cut is fixed. At most `most` of them, evenly chosen. [cm]
std::vector<double> beginnings(const PiecesOnBoard& pieces, const LayFabric& fabric,
                               std::size_t most);

}  // namespace seamwise
