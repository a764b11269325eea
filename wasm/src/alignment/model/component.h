#pragma once
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// Leaders connected by seams, and those seams.
struct Component {
  std::vector<int> leaders, seams;
};

/// The components of the leaders that have seams and are not pinned: pinned ones connect nothing.
std::vector<Component> componentsOf(const MatchProblem& problem);

}  // namespace seamwise
