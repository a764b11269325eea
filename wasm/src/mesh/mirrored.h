#pragma once
#include "base/outcome.h"
#include "pattern/fold.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Fills the piece or the two pieces of one imposed symmetry with meshes that are images of each
/// other. Extends mirror.image to all vertices. If the drafted halves differ, the mesh is made for
/// their mean: interior vertices are exact images, outline vertices keep their rest positions. An
/// outline vertex moves to the mean only if its triangle would turn over or nearly vanish (by at
/// most half the difference of the halves). Edges of triangles run along the creases of the first
/// piece. Returns whether any vertex moved. Errors: kMesh, naming
/// the piece.
Outcome<bool> meshMirrored(Pattern& pattern, Mirror& mirror, double coarsest,
                           const std::vector<Crease>& creases);

}  // namespace seamwise
