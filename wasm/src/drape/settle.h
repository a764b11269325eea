#pragma once
#include <vector>

#include "drape/wrap.h"

namespace seamwise {

/// Closes seams at the mean of their vertices, pulls all edges towards their rest lengths, and
/// pushes all vertices out of the form.
/// @param on_top   per piece: covers another one, so it keeps one layer more of distance
void settle(const Pattern& pattern, const Form& form, const Hanging& hanging,
            const std::vector<char>& on_top, const WrapSettings& settings,
            PiecePositions* positions);

}  // namespace seamwise
