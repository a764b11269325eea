#pragma once
#include "pattern/pattern.h"

namespace seamwise {

/// Sets length_ratio and twin of every seam from the rest shape and the imposed mirrors. The ratio
/// is that of the sides' lengths, edges averaged over mirror images within a piece, because under
/// exact symmetry both images get one length.
void setLengthRatios(Pattern& pattern);

}  // namespace seamwise
