#include "methods/drafted.h"

#include "problem/placing_rules.h"

namespace seamwise {

Alignments draftedLayout(const Problem& problem, const MatchProblem& match) {
  Alignments straight(match.pieces.size());
  for (std::size_t p = 0; p < straight.size(); ++p)
    straight[p].angle = wrapAngle(grainLine(problem, static_cast<int>(p)) - kPi / 2);
  return match.expanded(match.ofLeaders(straight));
}

}  // namespace seamwise
