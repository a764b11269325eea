#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/base/picture.h"

namespace seamwise {

/// Whether two opposite edges of a picture go on into each other when it is repeated.
struct TileEdge {
  bool meets = true;
  /// Where they differ most, as a share of the right or lower edge from its upper or left end.
  double differs_at = 0;
  /// Stretches of that edge at which they differ, as such shares; none where they meet.
  std::vector<std::array<double, 2>> open;
};

/// How the copy beyond an edge lies: beside the picture, or half a side further along.
enum class NextCopy : std::uint8_t { kBeside, kHalfAside };

/// Lines of motifs run across a border as steeply as they do on either side of it: where a row of
/// pixels was cut away, they step aside by twice as much, and where more was, colours do not go on
/// at all. Bands that are straight along the border or across it go on wherever a picture begins
/// and ends, so that nothing can be said of them.
TileEdge leftMeetsRight(const PixelView& tile, NextCopy next = NextCopy::kBeside);
TileEdge topMeetsBottom(const PixelView& tile, NextCopy next = NextCopy::kBeside);

}  // namespace seamwise
