#pragma once
#include <optional>
#include <string>

#include "geometry/outcome.h"
#include "solve/problem.h"

namespace seamwise {

/// Drops detected symmetries that contradict each other, with a note: shortens problem.imposed and
/// problem.known. Errors: kSymmetryConflict when those asked for do.
std::optional<Error> reconcile(Problem& problem);

/// "piece 'front'" or "the pair 'a' and 'b'".
std::string called(const Garment& garment, const BodySymmetry& symmetry);

}  // namespace seamwise
