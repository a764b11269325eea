#pragma once
#include "alignment/model/matching.h"
#include "problem/problem.h"

namespace seamwise {

/// Returns the layout of a cutter who ignores the seams. Each piece is on its grain, at its
/// position in its own coordinates. A symmetric piece has its axis on the nearest mirror line of
/// the print, mirror images have mirrored prints, and pinned pieces stay pinned.
/// @param match   the drafted pieces, under all rules
Alignments draftedLayout(const Problem& problem, const MatchProblem& match);

}  // namespace seamwise
