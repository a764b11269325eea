#pragma once
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "recognition/lattice/cell_tests.h"
#include "recognition/lattice/copies.h"

namespace seamwise {

/// Why a picture has no lattice to give: plain cloth, moire, blur, folds, or simply no repeat.
/// @param local   greatest mean correlation that a lattice had on the picture's middle
Error whyNoRepeat(const std::vector<ChannelImage>& levels, double local);

/// Why a lattice that explains something is refused all the same: too few repeats, two prints side
/// by side, a print that changes along the cloth. Nothing where it is not.
/// @param seen   repeats seen in a row, along w1 or w2, whichever are fewer; of stripes across
std::optional<Error> whyRefused(const Agreement& agreement, const CopyDifferences& differences,
                                double seen);

}  // namespace seamwise
