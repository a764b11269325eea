#pragma once
#include <utility>
#include <vector>

#include "alignment/model/matching.h"
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

/// The outcomes of the last few runs, for solves that repeat one of them: the requested pattern and
/// the symmetric one are solved in turns. The key is everything a run depends on, so results are
/// the same with or without a memo.
class RunMemo {
 public:
  struct Inputs {
    /// @param guided   number of symmetries that guide the search
    Inputs(const Problem& problem, const Pattern& pattern, MatchProblem match_problem,
           std::size_t guided, const std::vector<Alignments>& offered,
           const std::vector<Alignments>& starts);
    bool operator==(const Inputs&) const = default;

    Garment garment;
    std::vector<double> settings;  ///< options that the other members do not contain
    Shapes rest;
    MatchProblem match;
    std::vector<Alignments> alignments;  ///< those offered to the search, then starts
  };

  /// Returns null if there was no such run lately.
  const RunOutcome* find(const Inputs& inputs) const;
  void add(Inputs inputs, RunOutcome outcome);

 private:
  std::vector<std::pair<Inputs, RunOutcome>> kept_;  ///< the oldest first
};

}  // namespace seamwise
