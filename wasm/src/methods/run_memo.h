#pragma once
#include <vector>

#include "alignment/model/matching.h"
#include "base/memo.h"
#include "pattern/pattern.h"
#include "problem/problem.h"

namespace seamwise {

/// The outcome of a run of the default method. Alignments are those of all pieces.
struct RunOutcome {
  Alignments alignment, search;
  std::vector<Alignments> compared;  ///< the best few answers of the searches
  double search_bound = 0;           ///< as in Run
  Shapes shapes;
  int iterations = 0, factorisations = 0;
};

/// Everything that the outcome of such a run depends on.
struct RunInputs {
  /// @param guided   number of symmetries that guide the search
  RunInputs(const Problem& problem, const Pattern& pattern, MatchProblem match_problem,
            std::size_t guided, const std::vector<Alignments>& offered,
            const std::vector<Alignments>& starts);
  bool operator==(const RunInputs&) const = default;

  Garment garment;
  std::vector<double> settings;  ///< options that the other members do not contain
  Shapes rest;
  MatchProblem match;
  std::vector<Alignments> alignments;  ///< those offered to the search, then starts
};

/// For solves that repeat a run, since the requested pattern and the symmetric one are solved in
/// turns: two greatest changes, with and without symmetry.
using RunMemo = Memo<RunInputs, RunOutcome, 4>;

}  // namespace seamwise
