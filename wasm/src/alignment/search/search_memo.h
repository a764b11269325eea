#pragma once
#include <utility>
#include <vector>

#include "alignment/search/search.h"

namespace seamwise {

/// The outcomes of the last few searches, for solves of almost the same problem. They are kept
/// under all that a search depends on: with a memo or without, results are the same.
class SearchMemo {
 public:
  struct Inputs {
    MatchProblem problem;
    SearchBudget budget;
    std::uint64_t seed;
    double slack, watched;            ///< cm
    std::vector<Alignments> offered;  ///< of the leaders
    bool operator==(const Inputs&) const = default;
  };
  /// How a search has ended, as alignments of the leaders.
  struct Outcome {
    std::vector<Alignments> few;  ///< the best and some more
    Alignments watched;
    double bound;  ///< all as in AlignmentSearch
  };

  /// Null when there was no such search lately.
  const Outcome* find(const Inputs& inputs) const;
  void add(Inputs inputs, Outcome outcome);

 private:
  std::vector<std::pair<Inputs, Outcome>> kept_;  ///< the oldest first
};

}  // namespace seamwise
