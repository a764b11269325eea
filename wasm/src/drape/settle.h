#pragma once
#include <vector>

#include "drape/wrap.h"

namespace seamwise {

/// Welds what is sewn together, at the mean of where it lies, draws all edges towards their lengths
/// and pushes everything out of the form.
/// @param on_top   per piece: lies on another one, so it keeps one layer more of distance
void settle(const Pattern& pattern, const Form& form, const Hanging& hanging,
            const std::vector<char>& on_top, const WrapSettings& settings,
            PiecePositions* positions);

}  // namespace seamwise
