#pragma once
#include <optional>

#include "photo/lattice/copies.h"

namespace seamwise {

/// Returns the view of the same print as stripes: w1 across, one period long, w2 along, equally
/// long. The result is empty unless the mean cell varies in one direction only.
std::optional<TiltedLattice> asStripes(const Copies& copies, const TiltedLattice& view);

}  // namespace seamwise
