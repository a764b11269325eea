#pragma once
#include <cstdint>
#include <vector>

#include "photo/base/picture.h"

namespace seamwise {

/// Returns the sums of blocks of factor x factor pixels for one row of blocks, four numbers per
/// block. Pixels at the right that do not fill a block are omitted.
std::vector<std::uint32_t> blockSums(const PixelView& pixels, int factor, int row);

}  // namespace seamwise
