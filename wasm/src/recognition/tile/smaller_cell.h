#pragma once
#include <algorithm>
#include <array>

#include "recognition/symmetry/symmetry_tests.h"
#include "tuning/tile_reading.h"

namespace seamwise {

/// A lattice that holds that of whole cells: its basis as columns, in whole shares of a cell.
struct FinerLattice {
  int shares = 1;  ///< of w1 and w2
  std::array<int, 4> basis{1, 0, 0, 1};

  Mat2 matrix() const {
    return (Mat2() << basis[0], basis[1], basis[2], basis[3]).finished() / shares;
  }
  bool isWhole() const { return std::abs(matrix().determinant()) > 1 - 1e-9; }
};

/// Looks for a smaller cell inside one: the shortest shift that lays the cell on itself, or of a
/// stripe the smallest share of its basis vector across; one shift after the other.
class SmallerCellSearch {
 public:
  SmallerCellSearch(const CellPicture& cell, const Mat2& gram);

  SmallerCellSearch(const SmallerCellSearch&) = delete;  // its parts refer to each other
  SmallerCellSearch& operator=(const SmallerCellSearch&) = delete;

  /// Tests one shift; false when nothing is left to do.
  bool advance();
  /// Once done: what that shift generates with whole cells; these if there is none.
  const FinerLattice& lattice() const { return lattice_; }
  /// The share of energy by which that shift misses.
  double missed() const { return missed_; }

 private:
  /// The vector (a, b) / order of the cell's basis.
  struct ShareOfCell {
    int order = 1, a = 0, b = 0;
  };
  void addStripes(const std::array<int, 2>& along, const Mat2& gram);
  void addLikely(const Mat2& gram);

  CellSpectrum spectrum_;
  SymmetryTests tests_;
  std::array<ShareOfCell, std::max(TileReadingTuning::kMostStripes, TileReadingTuning::kMostShifts)>
      shifts_;  ///< that are tested, in turn
  int count_ = 0, tested_ = 0;
  FinerLattice lattice_;
  double missed_ = 0;
};

}  // namespace seamwise
