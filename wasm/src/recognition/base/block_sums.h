#pragma once
#include <cstdint>
#include <vector>

#include "recognition/base/picture.h"

namespace seamwise {

/// Sums of blocks of factor x factor pixels, for one row of blocks: four numbers to a block. What
/// does not fill a block at the right is left out.
std::vector<std::uint32_t> blockSums(const PixelView& pixels, int factor, int row);

}  // namespace seamwise
