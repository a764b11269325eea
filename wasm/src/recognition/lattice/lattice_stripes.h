#pragma once
#include <optional>

#include "recognition/lattice/copies.h"

namespace seamwise {

/// The view of the same print as stripes, where its mean cell varies in one direction only: w1
/// across, one period long, w2 along, as long. Nothing where it varies in both.
std::optional<TiltedLattice> asStripes(const Copies& copies, const TiltedLattice& view);

}  // namespace seamwise
