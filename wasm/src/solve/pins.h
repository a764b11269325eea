#pragma once
#include <optional>

#include "solve/problem.h"

namespace seamwise {

/// The first imposed symmetry that pinned alignments contradict: a pinned piece whose own axis lies
/// on no mirror line of the print, or a pair of which both are pinned, but not as mirror images.
std::optional<std::size_t> symmetryAgainstPins(const Problem& problem);

}  // namespace seamwise
