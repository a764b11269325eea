#pragma once
#include <array>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// One cell of a print in lattice coordinates: n x n samples, sample j * n + i at
/// (u, v) = (i / n, j / n), w1 and w2 counter-clockwise on the cloth's face. A whole-number matrix
/// with determinant +-1 permutes the samples, so that no symmetry of the lattice interpolates.
struct CellPicture {
  int n = 0;
  /// Red, green, blue, gamma-coded, in [0, 1]: the mean of the copies, light and folds taken away.
  std::array<std::vector<float>, 3> planes;
  /// Variance of that mean, summed over the opponent channels of `channels.h`, from how much the
  /// copies differ; of a tile's one copy, from differences of neighbouring pixels.
  std::vector<float> noise;
};

}  // namespace seamwise
