#pragma once
#include <vector>

#include "alignment/model/matching.h"
#include "base/random.h"

namespace seamwise {

/// Alignments of leader `l` that match one of its seams to a placed neighbour as well as a rigid
/// motion can: for each such seam the print runs on, or is mirrored (all other elements give the
/// same print on the piece). A piece bound to a mirror line or to given angles gets the admissible
/// ones near them, and one bound to a mirror line also some slides along it.
/// @param stretches   of each seam, drawn at random, that are matched besides the whole seam; where
///                    its sides differ in length, for each of them also two edges of it
/// @param placed   per leader; `l` itself counts as unplaced
std::vector<Alignment> candidates(const MatchProblem& problem, int l, const Alignments& at,
                                  const std::vector<char>& placed, int stretches, Random& random);

/// Some admissible alignment, for a piece that nothing holds yet. A piece sewn to itself is laid so
/// that the print mirrors across that seam, half of the time.
Alignment randomAlignment(const MatchProblem& problem, int l, Random& random);

}  // namespace seamwise
