#pragma once
#include <vector>

#include "recognition/lattice/copies.h"

namespace seamwise {

/// A lattice and whether its print is the same all along w2.
struct CellChoice {
  TiltedLattice view;
  bool is_stripes = false;
};

/// The same print's lattice with a smaller cell as long as there is one beside which the larger is
/// not needed, two, three or five times smaller at a time.
CellChoice withSmallestCell(const std::vector<ChannelImage>& levels, CellChoice choice);

/// The same with a cell up to six times larger, where copies side by side differ by more than
/// noise and folds, but copies that the larger cell lays on each other do not.
CellChoice withLargerCell(const std::vector<ChannelImage>& levels, CellChoice choice);

}  // namespace seamwise
