#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// How far every outline vertex is from the rest of the outline across a gap outside the piece,
/// such as the mouth of a dart: two sides that close it by less than half each cannot cross. [cm]
/// Vertices with no gap before them within `horizon` get `horizon`.
std::vector<double> outsideClearance(const Piece& piece, double horizon);

}  // namespace seamwise
