#pragma once
#include <vector>

#include "recognition/lattice/copies.h"

namespace seamwise {

/// Every lattice of whole multiples of w1, w2 whose cell is `index` times as large, as columns
/// (a, 0), (b, d).
std::vector<Mat2> largerCells(int index);

/// How much better copies agree when only those are compared that a larger cell lays on each
/// other.
struct SplitEvidence {
  /// Energy by which the classes' means differ, over what it would be were there no difference.
  double ratio = 0;
  /// The same energy as a share of the pattern's, what noise brings along taken away.
  double share = 0;
  /// The greatest share at one of 12 x 12 places in the cell, where it is beyond noise.
  double worst = 0;
  double within = 0;  ///< variance inside of the classes
  int pairs = 0;      ///< of copies that could be compared inside of a class, at most samples
};

SplitEvidence splitEvidence(const Copies& copies, const Mat2& larger);

/// Whether what differs is the print, not noise, folds or light.
bool isSplit(const SplitEvidence& evidence);

}  // namespace seamwise
