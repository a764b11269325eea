#pragma once
#include <utility>
#include <vector>

#include "alignment/model/matching.h"
#include "pattern/pattern.h"
#include "problem/options.h"

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
    Garment garment;
    SolveOptions options;  ///< those of the run
    Pattern pattern;
    MatchProblem match;
    std::vector<Mirror> known;
    std::vector<Alignments> offered, starts;
    bool operator==(const Inputs&) const = default;
  };

  /// Returns null if there was no such run lately.
  const RunOutcome* find(const Inputs& inputs) const;
  void add(Inputs inputs, RunOutcome outcome);

 private:
  std::vector<std::pair<Inputs, RunOutcome>> kept_;  ///< the oldest first
};

}  // namespace seamwise
