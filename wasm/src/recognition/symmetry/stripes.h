#pragma once
#include <array>

#include "recognition/symmetry/cell_spectrum.h"

namespace seamwise {

/// The direction along which a cell looks the same, as whole numbers of w1 and w2; (0, 0) if it is
/// no stripe.
std::array<int, 2> stripeOf(const CellSpectrum& cell);

inline bool isStripe(const std::array<int, 2>& along) { return along[0] != 0 || along[1] != 0; }

/// A basis, as columns, determinant +1: w1 as steeply across the stripes as the lattice has it, w2
/// along them.
IntegerMatrix stripeBasis(const std::array<int, 2>& along, const Mat2& gram);

}  // namespace seamwise
