#pragma once
#include <vector>

#include "drape/wrap.h"

namespace seamwise {

/// Closes seams at the mean of their vertices, pulls all edges towards their rest lengths, and
/// pushes all vertices out of the form.
/// @param on_top    per piece: covers another one
/// @param outward   per piece, per vertex: distance from the form beyond the usual one, cm
/// @param covered   per piece, per vertex: inside a closed pleat, without pull on its neighbours
void settle(const Pattern& pattern, const Form& form, const Hanging& hanging,
            const std::vector<char>& on_top, const std::vector<std::vector<double>>& outward,
            const std::vector<std::vector<char>>& covered, const WrapSettings& settings,
            PiecePositions* positions);

}  // namespace seamwise
