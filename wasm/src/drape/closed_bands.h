#pragma once
#include "pattern/pattern.h"

namespace seamwise {

/// Adds seams that close bands buttoned edge to edge, such as cuffs.
/// The seams join two free ends of a piece that have equal length and start at the same point of
/// the pieces that the band is sewn to. They follow the file's stitches in `pattern->seams`.
void closeBands(Pattern* pattern);

}  // namespace seamwise
