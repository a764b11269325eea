#pragma once
#include <cstdint>

#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_map.h"

namespace seamwise {

enum class Confidence : std::uint8_t { kSure, kLikely, kUncertain };

/// The lattice of a print as it was found on a picture: the smallest cell, in a Lagrange-reduced
/// basis, counter-clockwise as the cloth is looked at, wherever its origin.
struct LatticeReading {
  LatticeMap map;
  /// Share of the picture's variance that its other copies foretell, each left out of their mean.
  double explained = 0;
  /// How many cells are seen whole.
  int copies = 0;
  /// Standard error of the lengths of w1, w2, as a share.
  double uncertainty = 0;
  Confidence confidence = Confidence::kUncertain;
  /// The print is the same all along w2, whose length then says nothing; across, w1 leads from one
  /// repeat to the next.
  bool is_stripes = false;
};

}  // namespace seamwise
