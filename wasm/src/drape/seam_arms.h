#pragma once
#include <vector>

#include "drape/upright_joins.h"

namespace seamwise {

/// Which pieces are sleeves and cuffs, by seams and names: closed tubes that have a twin they are
/// not sewn to, what is called a sleeve, and what is sewn to nothing but these. Per piece, a piece
/// by which its arm is known, or -1.
std::vector<int> armsBySeams(const Pattern& pattern, const UprightPieces& upright);

}  // namespace seamwise
