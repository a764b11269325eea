#pragma once
#include "photo/base/cell_picture.h"
#include "photo/base/lattice_map.h"
#include "photo/base/picture.h"
#include "photo/fabric/cell_mean.h"

namespace seamwise {

/// Image that repeats edge to edge, optionally with a line of pixels added at its right or lower
/// edge: the mean of the last line and the first.
struct SeamlessTile {
  PixelView pixels;
  int more_columns = 0, more_rows = 0;
  int width() const { return pixels.width + more_columns; }
  int height() const { return pixels.height + more_rows; }
};

/// Samples the cell of a flat lattice on a tile, row by row, each sample from the surrounding
/// pixels.
class TileCell {
 public:
  /// The pixels of `tile` have to outlive the object. Basis and origin of `grid` are those of the
  /// map.
  TileCell(const SeamlessTile& tile, const LatticeMap& map, const CellGrid& grid);
  /// Continues for about `places` places of the tile; returns false when done.
  bool advance(int places);
  double fraction() const { return static_cast<double>(row_) / grid_.rows; }

  /// Once done: red, green, blue, sample (i, j) at index j * columns + i.
  const std::array<std::vector<float>, 3>& planes() const { return planes_; }
  /// Valid once done, for a grid with as many rows as columns.
  CellPicture picture() const;

 private:
  void sample(int column, int row);

  SeamlessTile tile_;
  CellGrid grid_;
  Vec2 origin_, w1_, w2_;  ///< positions on the tile. [px]
  int times_;              ///< places per sample, along both sides
  int row_ = 0;
  std::array<std::vector<float>, 3> planes_;
};

}  // namespace seamwise
