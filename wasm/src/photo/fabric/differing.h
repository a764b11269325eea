#pragma once
#include "photo/fabric/copy_fields.h"
#include "photo/fabric/registration.h"

namespace seamwise {

/// Finds the parts to omit from a mean of copies, and the weights of the others. It sets `weight`,
/// `regions` and `differing`.
/// A place has more weight the steeper the print's edges are there relative to those of all copies,
/// and the larger it is in the image. Its weight is 0 if it differs from the other copies by more
/// than noise and blur explain, or if the shift folds.
/// @param registration   finished registration
/// @param cell_size      see `cellSize`. [px]
void findDiffering(const CopyRegistration& registration, double cell_size, CopyFields* fields);

}  // namespace seamwise
