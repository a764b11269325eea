#pragma once
#include <memory>
#include <vector>

#include "alignment/bound/lower_bound.h"
#include "alignment/model/component.h"
#include "methods/search_stage.h"

namespace seamwise {

/// Proves a bound for the alignments of a solve, for the pattern as drafted; every step may raise
/// it. The search runs first, but the memo of a previous solve usually has its outcome.
class ProofRun {
 public:
  /// See SearchStage for the parameters.
  ProofRun(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
           const std::vector<Mirror>& known, const MatchRules& rules, SearchMemo& memo);

  /// Works for some milliseconds. Returns false when all is proven or no better bound is possible.
  bool advance();
  /// No alignment costs less than this share of search(): 1 when it is proven the best, 0 when
  /// nothing is known. Never falls.
  double bound() const;
  const Alignments& search() const { return searching_.best(); }  ///< alignments of the leaders
  /// Result::search_cost at search() once the search has ended, 0 before. [cm2]
  double searchCost() const { return cost_; }

 private:
  void begin();

  const MatchProblem& match_;
  SearchStage searching_;
  bool searched_ = false;
  std::vector<std::unique_ptr<LowerBound>> proofs_;  ///< per component
  std::vector<char> open_;                           ///< per proof: 1 if steps remain
  double cost_ = 0;                                  ///< cost of search(). [cm2]
};

}  // namespace seamwise
