#pragma once
#include <vector>

#include "nesting/pieces_on_board.h"

namespace seamwise {

/// Where an item lies: by which of its ways, at which dot.
struct LayPlace {
  int way = -1;  ///< -1: nowhere
  Dot dot;
};

/// Places of all items. [cm]
struct LaidPieces {
  std::vector<LayPlace> places;
  double bottom = 0, top = 0;
  double length() const { return top - bottom; }
};

/// The cloth on which a board's pieces are laid, and how the print lies on it.
struct LayCloth {
  double left = 0, right = 0;    ///< of what is of use. [cm]
  Vec2 origin = Vec2::Zero();    ///< of the print, and so of the board. [cm]
  bool is_fixed = false;         ///< the cut is at 0; else it is wherever the layout begins
  std::vector<int> turned_down;  ///< per garment 1 or 0, where its pieces have to point one way
  bool is_by_garment = false;    ///< which of these is open, but all pieces of one have to agree
};

/// The layout's ends. @param is_fixed  it begins at 0 wherever its pieces do
void measure(const PiecesOnBoard& pieces, const LayCloth& cloth, LaidPieces* layout);

/// The ways of every item that a cloth leaves, as indices.
std::vector<std::vector<int>> allowedWays(const PiecesOnBoard& pieces, const LayCloth& cloth);

/// Heights at which a layout may begin, in steps of less than the repeat: those at which a piece
/// may lie lowest; one where the cut is fixed. At most `most` of them, evenly chosen. [cm]
std::vector<double> beginnings(const PiecesOnBoard& pieces, const LayCloth& cloth,
                               std::size_t most);

}  // namespace seamwise
