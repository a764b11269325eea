#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// Improves answers and returns the different ones, the cheapest first. The first one in `all`
/// represents equally good ones.
/// @param all   alignments of a component's leaders, with any costs
/// @param improve   improves an answer by at most so many iterations; returns its cost
std::vector<std::pair<double, Alignments>> finalistsOf(
    std::vector<std::pair<double, Alignments>> all,
    const std::function<double(Alignments& own, int iterations)>& improve);

}  // namespace seamwise
