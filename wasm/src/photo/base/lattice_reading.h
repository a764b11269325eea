#pragma once
#include <cstdint>

#include "photo/base/cell_picture.h"
#include "photo/base/lattice_map.h"

namespace seamwise {

enum class Confidence : std::uint8_t { kSure, kLikely, kUncertain };

/// Lattice of a print as found on an image: the smallest cell, in a Lagrange-reduced basis that is
/// counter-clockwise in view, with any origin.
struct LatticeReading {
  LatticeMap map;
  /// Share of the image's variance that the mean of the other copies explains.
  double explained = 0;
  /// Number of cells that are entirely visible.
  int copies = 0;
  /// Standard error of the lengths of w1 and w2, as a share.
  double uncertainty = 0;
  Confidence confidence = Confidence::kUncertain;
  /// The print is constant along w2, so the length of w2 is arbitrary; w1 leads across to the next
  /// repeat.
  bool is_stripes = false;
};

}  // namespace seamwise
