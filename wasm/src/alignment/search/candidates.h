#pragma once
#include <vector>

#include "alignment/model/matching.h"
#include "base/random.h"

namespace seamwise {

/// Alignments of leader `l` that match one of its seams to a placed neighbour as well as a rigid
/// motion can. The print continues or is mirrored across each such seam (all other elements give
/// the same print on the piece). A piece bound to a mirror line or to given angles gets the
/// admissible ones near them. A piece bound to a mirror line also gets some slides along it.
/// @param stretches   number of random stretches of each seam to match besides the whole seam; if
///                    its sides differ in length, two of its edges for each of them as well
/// @param placed   per leader; `l` itself counts as unplaced
std::vector<Alignment> candidates(const MatchProblem& problem, int l, const Alignments& at,
                                  const std::vector<char>& placed, int stretches, Random& random);

/// A random admissible alignment, for a piece that is not bound by others yet. Half of the time,
/// the print mirrors across a seam that joins the piece to itself.
Alignment randomAlignment(const MatchProblem& problem, int l, Random& random);

}  // namespace seamwise
