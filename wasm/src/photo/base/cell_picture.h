#pragma once
#include <array>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// One cell of a print in lattice coordinates: n x n samples, sample j * n + i at (u, v) = (i / n,
/// j / n), with w1 and w2 counter-clockwise on the fabric's face. An integer matrix with
/// determinant +-1 permutes the samples, so symmetries of the lattice need no interpolation.
struct CellPicture {
  int n = 0;
  /// Red, green, blue, gamma-coded, in [0, 1]: mean of the copies, corrected for light and creases.
  std::array<std::vector<float>, 3> planes;
  /// Variance of that mean, summed over the opponent channels of `channels.h`. It comes from the
  /// differences between copies, or for a tile's single copy from differences of neighbouring
  /// pixels.
  std::vector<float> noise;
};

}  // namespace seamwise
