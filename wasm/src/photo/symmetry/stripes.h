#pragma once
#include <array>

#include "photo/symmetry/cell_spectrum.h"

namespace seamwise {

/// Returns the direction along which a cell is constant, as integer multiples of w1 and w2; (0, 0)
/// if the cell is no stripe.
std::array<int, 2> stripeOf(const CellSpectrum& cell);

inline bool isStripe(const std::array<int, 2>& along) { return along[0] != 0 || along[1] != 0; }

/// Returns a basis as columns, determinant +1: w1 as steep to the stripes as the lattice allows, w2
/// along them.
IntegerMatrix stripeBasis(const std::array<int, 2>& along, const Mat2& gram);

}  // namespace seamwise
