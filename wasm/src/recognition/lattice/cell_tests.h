#pragma once
#include <array>
#include <vector>

#include "recognition/lattice/copies.h"

namespace seamwise {

/// Every lattice of whole multiples of w1, w2 whose cell is `index` times as large, as columns
/// (a, 0), (b, d).
std::vector<Mat2> largerCells(int index);

/// How much copies differ that lie (i, j) cells apart, at 12 x 12 places in the cell: mean squares
/// over pairs of copies, all channels together.
class CopyDifferences {
 public:
  static constexpr int kReach = 6;    ///< cells, both ways
  static constexpr int kPlaces = 12;  ///< along a cell
  explicit CopyDifferences(const Copies& copies);

  struct Difference {
    double mean = 0;                                ///< over the cell
    double share = 0;                               ///< of the cell that at least one pair shows
    std::array<float, kPlaces * kPlaces> places{};  ///< below 0 where no pair is seen
  };
  /// Null where the shift is out of reach.
  const Difference* at(int i, int j) const;
  /// Variance of the pattern within the mean cell.
  double pattern() const { return pattern_; }

 private:
  std::vector<Difference> shifts_;  ///< j >= 0
  double pattern_ = 0;
};

/// Whether a larger cell is the true one: copies that only the given lattice lays on each other
/// differ by more than those which the larger one does, though these lie farther apart. Folds,
/// light and the lens let copies differ the more the farther apart they are.
struct SplitEvidence {
  double ratio = 0;   ///< difference of those over difference of these
  double share = 0;   ///< by how much it is greater, as a share of the pattern's energy
  double worst = 0;   ///< the same at the place where it is greatest, of twice the pattern's mean
  double within = 0;  ///< difference of copies that the larger cell lays on each other
};

/// @param lattice   a lattice of whole multiples of the copies' own, as columns
/// @param larger    whole multiples of that, as columns
/// @param basis     w1, w2 of the copies as they are seen, to tell which shifts are short
SplitEvidence splitEvidence(const CopyDifferences& differences, const Mat2& lattice,
                            const Mat2& larger, const Mat2& basis);

/// Whether what differs is the print, not noise, folds or light.
bool isSplit(const SplitEvidence& evidence);

}  // namespace seamwise
