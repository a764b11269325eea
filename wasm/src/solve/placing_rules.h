#pragma once
#include <optional>
#include <vector>

#include "alignment/grain.h"
#include "solve/problem.h"

namespace seamwise {

/// Pins and grain of every piece.
std::vector<PieceRule> pieceRules(const Problem& problem);

/// The first imposed symmetry that pinned alignments contradict: a pinned piece whose own axis lies
/// on no mirror line of the print, or a pair of which both are pinned, but not as mirror images.
std::optional<std::size_t> symmetryAgainstPins(const Problem& problem);

/// The first imposed symmetry under which a piece cannot lie on its grain on this print.
std::optional<std::size_t> symmetryAgainstGrain(const Problem& problem);

}  // namespace seamwise
