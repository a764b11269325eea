#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"
#include "pattern/pattern.h"
#include "problem/problem.h"

namespace seamwise {

/// Drops detected symmetries that contradict each other, with a note: shortens problem.imposed and
/// problem.known. Errors: kSymmetryConflict when those asked for do.
/// @return the garment as discretise() samples it by what is left, where that is known by then
Outcome<std::optional<Pattern>> reconcile(Problem& problem);

/// Whether one of the list is of the same pieces.
bool contains(const std::vector<BodySymmetry>& list, const BodySymmetry& s);

/// "piece 'front'" or "the pair 'a' and 'b'".
std::string called(const Garment& garment, const BodySymmetry& symmetry);

}  // namespace seamwise
