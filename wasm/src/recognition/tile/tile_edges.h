#pragma once
#include "recognition/base/picture.h"

namespace seamwise {

/// Whether two opposite edges of a picture go on into each other when it is repeated.
struct TileEdge {
  bool meets = true;
  /// Where they differ most, as a share of the edge from its left or upper end.
  double differs_at = 0;
};

/// Lines of motifs run across a border as steeply as they do on either side of it: where a row of
/// pixels was cut away, they step aside by twice as much, and where more was, colours do not go on
/// at all. Bands that are straight along the border or across it go on wherever a picture begins
/// and ends, so that nothing can be said of them.
TileEdge leftMeetsRight(const PixelView& tile);
TileEdge topMeetsBottom(const PixelView& tile);

}  // namespace seamwise
