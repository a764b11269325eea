#pragma once
#include "problem/problem.h"

namespace seamwise {

/// Prepares the pleated pieces of a problem so that the print runs on across every closed pleat.
///
/// A pleat hides the fabric between its two lines, so the print runs on if the vector from one line
/// to the other is a translation of the print. That depends on the angle of the piece and on the
/// widths of its pleats only, so both are fixed before the search: the angle is the one nearest the
/// grain at which a lattice vector runs across the pleats, and the widths become whole repeats
/// within the greatest change. All edges of such a piece are locked, so that shaping keeps both.
///
/// Changes the panels, the grain rules and the locked edges, stores the changes of the panels in
/// `pleat_fits`, and adds notes, also about pleats that cannot match.
void fitPleats(Problem* problem);

}  // namespace seamwise
