#pragma once
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "photo/lattice/cell_tests.h"
#include "photo/lattice/copies.h"

namespace seamwise {

/// Least visible repeats: one, and the starts of its neighbours on both sides.
constexpr double kLeastRepeats = 2.2;

/// Returns the reason why an image has no lattice: plain fabric, moire, blur, folds, or simply no
/// repeat.
/// @param local   greatest mean correlation of a lattice in the image's middle
Error whyNoRepeat(const std::vector<ChannelImage>& levels, double local);

/// Returns the error of an image of which a large part shows another print or none.
Error twoPrints();

/// Returns the reason to reject a lattice that explains something: too few repeats, two prints side
/// by side, or a print that changes along the fabric. The result is empty for an acceptable
/// lattice.
/// @param seen   visible repeats in a row, the fewer of those along w1 and w2; for stripes across
std::optional<Error> whyRefused(const Agreement& agreement, const CopyDifferences& differences,
                                double seen);

}  // namespace seamwise
