#pragma once
#include "geometry/outcome.h"
#include "pattern/pattern.h"
#include "solve/problem.h"

namespace seamwise {

/// Samples and meshes the garment of a problem. Symmetries whose demands on edge lengths contradict
/// each other (mirrored edges sewn to edges that do not mirror) cannot all hold: of detected ones
/// the fewest are dropped, with a note; of asked-for ones this is an error. The sampling follows
/// the same symmetries whether they are imposed or not, so that figures compare. May shorten
/// problem.imposed and problem.known. Errors: kMesh, kSymmetryConflict.
Outcome<Pattern> preparedPattern(Problem& problem);

}  // namespace seamwise
