#pragma once
#include <array>
#include <vector>

#include "photo/lattice/copies.h"

namespace seamwise {

/// Returns every lattice of integer multiples of w1, w2 whose cell is `index` times as large, as
/// columns (a, 0), (b, d).
std::vector<Mat2> largerCells(int index);

/// Differences between copies that are (i, j) cells apart, at 12 x 12 places in the cell: mean
/// squares over pairs of copies, all channels together.
class CopyDifferences {
 public:
  static constexpr int kReach = 6;    ///< cells, in both directions
  static constexpr int kPlaces = 12;  ///< along a side of a cell
  explicit CopyDifferences(const Copies& copies);

  struct Difference {
    double mean = 0;   ///< mean over the cell
    double share = 0;  ///< share of the cell that at least one pair shows
    std::array<float, kPlaces * kPlaces> places{};  ///< negative where no pair is visible
  };
  /// Returns null if the shift is out of reach or its pairs show too little of the cell.
  const Difference* at(int i, int j) const;
  /// Variance of the pattern within the mean cell.
  double pattern() const { return pattern_; }

 private:
  std::vector<Difference> shifts_;  ///< shifts with j >= 0
  double pattern_ = 0;
};

/// Evidence that a larger cell is the true one. Copies that coincide only in the given lattice
/// (between) then differ by more than copies that coincide in the larger one (within), although the
/// latter are farther apart. Folds, light and the lens make copies differ more with distance.
struct SplitEvidence {
  double ratio = 0;   ///< difference between, over difference within
  double share = 0;   ///< excess of the difference between, as a share of the pattern's energy
  double worst = 0;   ///< the same at the worst place, relative to twice the pattern's mean
  double within = 0;  ///< difference within
};

/// Compares copies between and within the larger cells.
/// @param lattice   integer multiples of the copies' own lattice, as columns
/// @param larger    integer multiples of `lattice`, as columns
/// @param basis     w1, w2 of the copies in view, which determine the short shifts
SplitEvidence splitEvidence(const CopyDifferences& differences, const Mat2& lattice,
                            const Mat2& larger, const Mat2& basis);

/// Returns whether the print differs, and not only noise, folds or light.
bool isSplit(const SplitEvidence& evidence);

}  // namespace seamwise
