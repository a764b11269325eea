#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// Distance of every outline vertex from the rest of the outline across a gap outside the piece,
/// such as the mouth of a dart. Two sides that each close it by less than half cannot cross. [cm]
/// Vertices without a gap within `horizon` get `horizon`.
std::vector<double> outsideClearance(const Piece& piece, double horizon);

}  // namespace seamwise
