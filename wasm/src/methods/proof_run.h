#pragma once
#include <memory>
#include <vector>

#include "alignment/bound/lower_bound.h"
#include "alignment/model/component.h"
#include "methods/search_stage.h"

namespace seamwise {

/// Proves how good the alignments are that a solve has found for the pattern as drafted, for as
/// long as it is advanced. The search runs first; after a solve with the same memo its outcome is
/// remembered as a rule.
class ProofRun {
 public:
  /// As for SearchStage.
  ProofRun(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
           const std::vector<Mirror>& known, const MatchRules& rules, SearchMemo& memo);

  /// Some milliseconds of work. False when all is proven or no more can be.
  bool advance();
  /// No alignment costs less than this share of search(): 1 when it is proven the best, 0 when
  /// nothing is known. Never falls.
  double bound() const;
  const Alignments& search() const { return searching_.best(); }  ///< of the leaders
  /// Result::search_cost at search() once the search has ended, 0 before. [cm2]
  double searchCost() const { return cost_; }

 private:
  void begin();

  const MatchProblem& match_;
  SearchStage searching_;
  bool searched_ = false;
  std::vector<std::unique_ptr<LowerBound>> proofs_;  ///< per component
  std::vector<char> open_;                           ///< per proof: there are steps left
  double cost_ = 0;                                  ///< of search(). [cm2]
};

}  // namespace seamwise
