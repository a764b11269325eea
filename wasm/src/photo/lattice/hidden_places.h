#pragma once
#include <cstdint>
#include <vector>

#include "photo/lattice/tilted_lattice.h"

namespace seamwise {

struct ChannelImage;

/// Square blocks of an image in which the print is hidden by an object, or displaced by a seam or
/// fold.
struct HiddenPlaces {
  int columns = 0, rows = 0;
  float side = 1;                       ///< of a block. [px]
  std::vector<std::uint8_t> is_hidden;  ///< one per block, row by row
  double share = 0;                     ///< share of the image that is hidden
  double share_of_compared = 0;         ///< share of the blocks in which copies were compared
  /// Middle of the largest disc that is free. [px]
  Vec2 free_middle = Vec2::Zero();

  bool at(float x, float y) const {
    const int column = static_cast<int>(x / side), row = static_cast<int>(y / side);
    return column < columns && row < rows && is_hidden[row * columns + column] != 0;
  }
};

/// Compares each copy of a cell with the median of all copies, which an object on a third of the
/// image does not change. Blocks that differ by more than noise are hidden, with those beside them.
/// @param image   without hidden places
/// @param reach   cells from the view's focus that are compared; others are not hidden
HiddenPlaces hiddenPlaces(const ChannelImage& image, const TiltedLattice& view, double reach);

}  // namespace seamwise
