#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// The length that every outline edge keeps while the pattern deforms: its own rest length, evened
/// out so that sewn edges have exactly their seam's ratio and mirror images are equal. [cm]
/// @return   per piece, per outline position k: length of outline[k] -> outline[k + 1]
std::vector<std::vector<double>> keptLengths(const Pattern& pattern);

}  // namespace seamwise
