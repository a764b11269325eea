#pragma once
#include <optional>
#include <vector>

#include "alignment/model/alignment.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Rules for a piece's alignment in addition to symmetry.
struct PieceRule {
  std::optional<Alignment> pin;
  std::vector<double> angles;  ///< admissible angles, rad; empty: any
  double tolerance = 0;        ///< rad
};

/// The mirror image of `first` closest to one of the wanted angles. All elements give the same
/// print, but turned pieces differ in their grain.
/// @param map   first piece -> second
Alignment mirroredOnGrain(const WallpaperGroup& group, const RigidMotion& map,
                          const std::vector<double>& angles, const Alignment& first);

/// The angles at which both a piece and its mirror image are on their grain; the widest of several
/// ranges. Returns the rule of `first` if there are none.
/// @param map   first piece -> second
PieceRule withImage(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                    const PieceRule& second);

/// Returns whether two pieces, or one piece with itself, can keep their angles and mirror each
/// other on this print. The group must carry the symmetry. Pinned pieces are ignored.
/// @param map   first piece -> second
bool keepsGrain(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                const PieceRule& second, bool single);

}  // namespace seamwise
