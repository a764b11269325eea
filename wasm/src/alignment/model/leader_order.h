#pragma once
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// Rank of each leader in an order that keeps neighbours close (Cuthill & McKee 1969, reversed).
std::vector<int> rankedLeaders(const MatchProblem& problem);

}  // namespace seamwise
