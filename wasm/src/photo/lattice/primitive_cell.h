#pragma once
#include <vector>

#include "photo/lattice/copies.h"

namespace seamwise {

/// Lattice of a print, and whether the print is constant along w2.
struct CellChoice {
  TiltedLattice view;
  bool is_stripes = false;
};

/// Returns the same print's lattice with the smallest cell that explains it. Each round divides the
/// cell by two, three or five.
CellChoice withSmallestCell(const std::vector<ChannelImage>& levels, CellChoice choice);

/// Returns the lattice with a cell up to six times larger if adjacent copies differ by more than
/// noise and folds, but copies that coincide in the larger cell do not.
CellChoice withLargerCell(const std::vector<ChannelImage>& levels, CellChoice choice);

}  // namespace seamwise
