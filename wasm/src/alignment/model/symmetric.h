#pragma once
#include "alignment/model/alignment.h"
#include "geometry/rigid_motion.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Print alignments that obey a symmetry of the body (Wolff et al. 2019, 3.1 and 3.2, corrected).

/// The alignment of a pair's second piece that mirrors `first`, for the pair map p' = R F p + t and
/// any orientation-reversing element (A, a): R' = R F R_c A, t' = R F t_c + t - R' a. The choice of
/// element never changes the print on the piece. `map` and `element` must be mirrored.
Alignment mirrorImage(const Alignment& first, const RigidMotion& map, const Element& element);

/// The inverse of mirrorImage: the first alignment whose mirror image is `second`.
Alignment mirrorSource(const Alignment& second, const RigidMotion& map, const Element& element);

/// The alignment nearest to `wanted` (least turn about the piece's axis point nearest `pivot`, then
/// least shift along the axis normal) under which the piece's own reflection `map` is a symmetry of
/// the print: its axis is on a mirror line, never on a glide. The group must carry single pieces.
Alignment snapToMirror(const Alignment& wanted, const RigidMotion& map, const Vec2& pivot,
                       const WallpaperGroup& group);

}  // namespace seamwise
