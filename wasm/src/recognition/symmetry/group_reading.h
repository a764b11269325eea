#pragma once
#include <array>
#include <cstdint>

#include "recognition/base/cell_picture.h"
#include "recognition/base/lattice_reading.h"
#include "recognition/symmetry/symmetry_tests.h"
#include "wallpaper/group.h"

namespace seamwise {

enum class SymmetryVerdict : std::uint8_t { kHas, kAlmost, kHasNot, kCannot };

/// What one of the 17 groups would be on a cell that was read.
struct GroupVerdict {
  const GroupData* group = nullptr;
  /// The group's w1, w2 as columns in the basis of the reading, determinant +1, row by row: along
  /// the axes where the group's convention has them.
  std::array<int, 4> basis{1, 0, 0, 1};
  /// Its origin in lattice coordinates of the reading, in [0, 1).
  Vec2 origin = Vec2::Zero();
  /// Share of the pattern's energy that breaks it, noise taken away; and the greatest such share at
  /// one of 24 x 24 places. Of the worst of its elements.
  double rho = 0, worst = 0;
  double raw = 0;  ///< as rho, noise and displacements not taken away
  SymmetryVerdict verdict = SymmetryVerdict::kCannot;
};

struct GroupReading {
  std::array<GroupVerdict, 17> groups;  ///< in the order of `wallpaperGroups()`
  int best = 0;  ///< the largest of those that it has; the smaller one on ties
  Confidence confidence = Confidence::kUncertain;
  bool one_way = false;  ///< no half turn lays the cloth on itself
  /// The same all along one direction: its best group has w2 along the stripes, of any length, and
  /// only the part of w1 across them counts.
  bool stripes = false;
};

/// Which wallpaper groups a cell has, wherever their origins are and whichever of the lattice's
/// vectors are their axes, one group after the other. A group is there if each of its elements lays
/// the cell on itself: the share of the pattern's energy that differs is small in all and at every
/// place, beyond noise and what creases displace.
class GroupReader {
 public:
  /// @param gram        of the cell's w1, w2, in any unit of area
  /// @param tolerance   of the lattice: lengths as a share, angles in radians
  GroupReader(const CellPicture& cell, const Mat2& gram, double tolerance);

  GroupReader(const GroupReader&) = delete;  // its parts refer to each other
  GroupReader& operator=(const GroupReader&) = delete;

  /// Tests one group; false when that was the last.
  bool advance();
  double fraction() const;
  /// Once all are tested.
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
