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
  std::vector<Note> notes;  ///< which ones were dropped, and why
  /// The garment as discretise() samples it by the symmetries, where that is known by then.
  std::optional<Pattern> sampled;
};

/// Drops detected symmetries that contradict each other. Errors: kSymmetryConflict when those asked
/// for do.
/// @param symmetries   of the problem, or fewer
Outcome<Reconciled> reconcile(const Problem& problem, const GarmentSymmetries& symmetries);

/// Whether one of the list is of the same pieces.
bool contains(const std::vector<BodySymmetry>& list, const BodySymmetry& s);

/// "piece 'front'" or "the pair 'a' and 'b'".
std::string called(const Garment& garment, const BodySymmetry& symmetry);

}  // namespace seamwise
