#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"
#include "pattern/pattern.h"
#include "problem/problem.h"

namespace seamwise {

/// Symmetries that can hold together.
struct Reconciled {
  GarmentSymmetries symmetries;
  std::vector<Note> notes;  ///< dropped symmetries, with reasons
  /// The garment sampled with the symmetries by discretise(), if it is known already.
  std::optional<Pattern> sampled;
};

/// Drops detected symmetries that contradict each other. Errors: kSymmetryConflict for
/// contradictory requested ones.
/// @param symmetries   those of the problem, or fewer
Outcome<Reconciled> reconcile(const Problem& problem, const GarmentSymmetries& symmetries);

/// True if the list has a symmetry of the same pieces.
bool contains(const std::vector<BodySymmetry>& list, const BodySymmetry& s);

/// "piece 'front'" or "the pair 'a' and 'b'".
std::string called(const Garment& garment, const BodySymmetry& symmetry);

}  // namespace seamwise
