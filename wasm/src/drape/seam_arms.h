#pragma once
#include <vector>

#include "drape/upright_joins.h"

namespace seamwise {

/// Identifies pieces of sleeves and cuffs by seams and names: closed tubes with a twin that they
/// are not sewn to, pieces named as sleeves, and pieces sewn only to these. Returns per piece a
/// representative piece of its arm, or -1.
std::vector<int> armsBySeams(const Pattern& pattern, const UprightPieces& upright);

}  // namespace seamwise
