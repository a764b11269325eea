#pragma once
#include <optional>
#include <vector>

#include "alignment/model/alignment.h"
#include "wallpaper/group.h"

namespace seamwise {

/// What a piece's alignment must keep besides symmetry.
struct PieceRule {
  std::optional<Alignment> pin;
  std::vector<double> angles;  ///< admissible angles, rad; empty: any
  double tolerance = 0;        ///< rad
};

/// The mirror image of `first` that comes nearest to one of the wanted angles: all elements give
/// the same print, but turned pieces lie differently on the cloth's grain.
/// @param map   first piece -> second
Alignment mirroredOnGrain(const WallpaperGroup& group, const RigidMotion& map,
                          const std::vector<double>& angles, const Alignment& first);

/// The angles at which both a piece and its mirror image are on their grain; of several ranges, the
/// widest. The rule of `first` where there is none.
/// @param map   first piece -> second
PieceRule withImage(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                    const PieceRule& second);

/// Whether two pieces, or one piece with itself, can keep their angles and mirror each other on
/// this print. The group must carry the symmetry. Pinned pieces are left out.
/// @param map   first piece -> second
bool keepsGrain(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                const PieceRule& second, bool single);

}  // namespace seamwise
