#pragma once
#include "pattern/pattern.h"

namespace seamwise {

/// Sets length_ratio and twin of every seam from the rest shape and the imposed mirrors. The ratio
/// of the sides' lengths uses edge lengths averaged over mirror images, because exact symmetry
/// gives both images the same length.
void setLengthRatios(Pattern& pattern);

}  // namespace seamwise
