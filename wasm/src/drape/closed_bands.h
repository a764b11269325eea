#pragma once
#include "pattern/pattern.h"

namespace seamwise {

/// Sews bands that are buttoned edge to edge, such as cuffs, along their ends: pieces whose free
/// ends, as long as each other, begin at one point of what the band in between is sewn to. These
/// seams are no stitches of the file; they come after all that are.
void closeBands(Pattern* pattern);

}  // namespace seamwise
