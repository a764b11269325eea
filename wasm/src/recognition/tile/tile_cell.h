#pragma once
#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_map.h"
#include "recognition/base/picture.h"
#include "recognition/cloth/cell_mean.h"

namespace seamwise {

/// A picture that repeats edge to edge, with a line of pixels put in at its right or lower edge if
/// so asked: the mean of the last line and the first.
struct SeamlessTile {
  PixelView pixels;
  int more_columns = 0, more_rows = 0;
  int width() const { return pixels.width + more_columns; }
  int height() const { return pixels.height + more_rows; }
};

/// The cell of a flat lattice on a tile, row by row, each sample from the pixels that lie around
/// it.
class TileCell {
 public:
  /// `tile`'s pixels have to outlive it. Of `grid`, basis and origin are those of the map.
  TileCell(const SeamlessTile& tile, const LatticeMap& map, const CellGrid& grid);
  /// Looks at about that many places of the tile; false when nothing is left to do.
  bool advance(int places);
  double fraction() const { return static_cast<double>(row_) / grid_.rows; }

  /// Once done: red, green, blue, sample (i, j) at index j * columns + i.
  const std::array<std::vector<float>, 3>& planes() const { return planes_; }
  /// Once done, of a grid of as many rows as columns.
  CellPicture picture() const;

 private:
  void sample(int column, int row);

  SeamlessTile tile_;
  CellGrid grid_;
  Vec2 origin_, w1_, w2_;  ///< on the tile. [px]
  int times_;              ///< places to a sample, along both sides
  int row_ = 0;
  std::array<std::vector<float>, 3> planes_;
};

}  // namespace seamwise
