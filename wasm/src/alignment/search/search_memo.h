#pragma once
#include <vector>

#include "alignment/search/search.h"
#include "base/memo.h"

namespace seamwise {

struct SearchInputs {
  MatchProblem problem;
  SearchBudget budget;
  std::uint64_t seed;
  double slack, watched;            ///< cm
  std::vector<Alignments> offered;  ///< alignments of the leaders
  bool operator==(const SearchInputs&) const = default;
};

/// The outcome of a search, as alignments of the leaders.
struct SearchOutcome {
  std::vector<Alignments> few;  ///< the best and some more
  Alignments watched;
  double bound;  ///< all fields as in AlignmentSearch
};

/// For solves of almost the same problem: a change and its undoing, with five searches each.
using SearchMemo = Memo<SearchInputs, SearchOutcome, 10>;

}  // namespace seamwise
