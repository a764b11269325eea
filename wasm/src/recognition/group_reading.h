#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/lattice_reading.h"
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
  SymmetryVerdict verdict = SymmetryVerdict::kCannot;
};

struct GroupReading {
  std::vector<GroupVerdict> groups;  ///< all 17, in the order of `wallpaperGroups()`
  int best = 0;                      ///< the largest of those that it has; the smaller one on ties
  Confidence confidence = Confidence::kUncertain;
  bool one_way = false;  ///< no half turn lays the cloth on itself
  bool stripes = false;  ///< the same all along one direction
};

}  // namespace seamwise
