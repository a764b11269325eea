#pragma once
#include "base/outcome.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Fills the piece or the two pieces of one imposed symmetry with meshes that are images of each
/// other and extends mirror.image to all vertices. Where the drafted halves differ, the mesh is
/// made for their mean; interior vertices are exact images, outline vertices keep their rest
/// positions. Only an outline vertex whose triangle would turn over there moves to the mean (at
/// most half of what the halves differ by). Returns whether any vertex did. Errors: kMesh, naming
/// the piece.
Outcome<bool> meshMirrored(Pattern& pattern, Mirror& mirror, double coarsest);

}  // namespace seamwise
