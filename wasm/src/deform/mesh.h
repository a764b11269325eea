#pragma once
#include "geometry/outcome.h"
#include "pattern/pattern.h"

namespace seamwise {

inline constexpr double kCoarsest = 6.0;  ///< cm: greatest triangles inside; the interior is smooth

/// Fills every piece with triangles: the outline is kept as sampled, interior vertices on a graded
/// hexagonal pattern (about the outline's spacing at the outline, up to `coarsest` cm inside).
/// A piece with an imposed single mirror is meshed by halves: one half is triangulated, the other
/// is its image, so no triangle crosses the axis; the second piece of a pair carries the image of
/// the first one's mesh. Extends Mirror::image to every vertex. Errors: kMesh, naming the piece.
Outcome<Pattern> meshed(Pattern pattern, double coarsest = kCoarsest);

}  // namespace seamwise
