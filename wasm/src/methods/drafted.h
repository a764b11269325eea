#pragma once
#include "alignment/model/matching.h"
#include "problem/problem.h"

namespace seamwise {

/// How a cutter lays the pieces who does not look at the print's seams: each on its grain, as it
/// lies in its own coordinates; what is symmetric with its axis on the nearest mirror line of the
/// print, mirror images with mirrored prints, what is pinned where it is pinned.
/// @param match   the pieces as drafted, under all rules
Alignments draftedLayout(const Problem& problem, const MatchProblem& match);

}  // namespace seamwise
