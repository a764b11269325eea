#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// What is left of answers once they are improved, the cheapest first; of those that are as good as
/// each other, what comes first in `all` stands for the others.
/// @param all   alignments of a component's leaders, with any costs
/// @param improve   improves an answer by so many iterations at most; returns its cost
std::vector<std::pair<double, Alignments>> finalistsOf(
    std::vector<std::pair<double, Alignments>> all,
    const std::function<double(Alignments& own, int iterations)>& improve);

}  // namespace seamwise
