#pragma once
#include <array>
#include <cstdint>

#include "photo/base/cell_picture.h"
#include "photo/base/lattice_reading.h"
#include "photo/symmetry/symmetry_tests.h"
#include "wallpaper/group.h"

namespace seamwise {

enum class SymmetryVerdict : std::uint8_t { kHas, kAlmost, kHasNot, kCannot };

/// Result for one of the 17 groups on a cell.
struct GroupVerdict {
  const GroupData* group = nullptr;
  /// The group's w1, w2 as columns in the basis of the reading, determinant +1, row by row; along
  /// the axes if the group's convention requires it.
  std::array<int, 4> basis{1, 0, 0, 1};
  /// Origin in lattice coordinates of the reading, in [0, 1).
  Vec2 origin = Vec2::Zero();
  /// Share of the pattern's energy that breaks the group, without noise, and the greatest such
  /// share at one of 24 x 24 places. Both are those of the group's worst element.
  double rho = 0, worst = 0;
  double raw = 0;  ///< rho with noise and displacements
  SymmetryVerdict verdict = SymmetryVerdict::kCannot;
};

struct GroupReading {
  std::array<GroupVerdict, 17> groups;  ///< order of `wallpaperGroups()`
  int best = 0;  ///< largest group present; the best fit of equally large ones
  Confidence confidence = Confidence::kUncertain;
  bool one_way = false;  ///< no half turn maps the print to itself
  /// The print is constant along one direction. Its best group has w2 along the stripes, of any
  /// length, and only the part of w1 across them counts.
  bool stripes = false;
};

/// Finds the wallpaper groups of a cell, one group after the other, for any origin and any axes
/// along the lattice's vectors. A group is present if each of its elements maps the cell to itself:
/// the differing share of the pattern's energy is small overall and at every place, beyond noise
/// and displacements by creases.
class GroupReader {
 public:
  /// @param gram        Gram matrix of the cell's w1, w2, in any unit of area
  /// @param tolerance   tolerance of the lattice: lengths as a share, angles in radians
  GroupReader(const CellPicture& cell, const Mat2& gram, double tolerance);

  GroupReader(const GroupReader&) = delete;  // members refer to each other
  GroupReader& operator=(const GroupReader&) = delete;

  /// Tests one group; returns false after the last one.
  bool advance();
  double fraction() const;
  /// Valid once all groups are tested.
  const GroupReading& result() const { return reading_; }

 private:
  void choose();

  CellSpectrum spectrum_;
  SymmetryTests tests_;
  Mat2 gram_;
  double tolerance_;
  std::size_t tested_ = 0;
  GroupReading reading_;
};

}  // namespace seamwise
