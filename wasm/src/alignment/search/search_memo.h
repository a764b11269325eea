#pragma once
#include <utility>
#include <vector>

#include "alignment/search/search.h"

namespace seamwise {

/// The outcomes of the last few searches, for solves of almost the same problem. The key is
/// everything a search depends on, so results are the same with or without a memo.
class SearchMemo {
 public:
  struct Inputs {
    MatchProblem problem;
    SearchBudget budget;
    std::uint64_t seed;
    double slack, watched;            ///< cm
    std::vector<Alignments> offered;  ///< alignments of the leaders
    bool operator==(const Inputs&) const = default;
  };
  /// The outcome of a search, as alignments of the leaders.
  struct Outcome {
    std::vector<Alignments> few;  ///< the best and some more
    Alignments watched;
    double bound;  ///< all fields as in AlignmentSearch
  };

  /// Returns null if there was no such search lately.
  const Outcome* find(const Inputs& inputs) const;
  void add(Inputs inputs, Outcome outcome);

 private:
  std::vector<std::pair<Inputs, Outcome>> kept_;  ///< the oldest first
};

}  // namespace seamwise
