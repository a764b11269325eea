#pragma once
#include "recognition/cloth/copy_fields.h"
#include "recognition/cloth/registration.h"

namespace seamwise {

/// Finds what to leave out of a mean of copies, and how much the rest counts: sets `weight`,
/// `regions` and `differing`. A place counts by how steep the print's edges are there against all
/// copies', and by how large the picture shows it; not at all where it differs from the other
/// copies by more than noise and blur make it, or where the shift folds.
/// @param registration   done
/// @param cell_size      see `cellSize`. [px]
void findDiffering(const CopyRegistration& registration, double cell_size, CopyFields* fields);

}  // namespace seamwise
