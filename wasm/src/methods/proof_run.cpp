#include "methods/proof_run.h"

#include <algorithm>

#include "methods/best_run.h"
#include "tuning/proof.h"

namespace seamwise {

ProofRun::ProofRun(const Problem& problem, const Pattern& pattern, const MatchProblem& match,
                   const std::vector<Mirror>& known, const MatchRules& rules, SearchMemo& memo)
    : match_(match),
      searching_(problem, pattern, match, known, rules, BestRun::slackOf(problem.options), {},
                 memo) {}

/// Starts one proof for each component, all of the same answer.
void ProofRun::begin() {
  searched_ = true;
  cost_ = match_.cost(search());
  if (searching_.isPerfect() || searching_.bound() >= 1) return;
  for (const Component& component : componentsOf(match_))
    proofs_.push_back(std::make_unique<LowerBound>(match_, component, search()));
  open_.assign(proofs_.size(), 1);
}

bool ProofRun::advance() {
  if (!searched_) {
    if (!searching_.advance()) begin();
    return true;
  }
  // The component with the largest gap between cost and bound may raise the bound most.
  std::size_t next = proofs_.size();
  double most = 0;
  for (std::size_t k = 0; k < proofs_.size(); ++k) {
    const double unknown = proofs_[k]->cost() - proofs_[k]->bound();
    if (open_[k] && unknown > most) most = unknown, next = k;
  }
  if (next == proofs_.size()) return false;
  open_[next] = proofs_[next]->step();
  return true;
}

double ProofRun::bound() const {
  if (!searched_) return 0;
  if (proofs_.empty()) return 1;
  double bound = 0;
  for (const auto& proof : proofs_) bound += proof->proven() ? proof->cost() : proof->bound();
  if (bound >= (1 - ProofTuning::kProven) * cost_) return 1;
  return std::max(bound / cost_, searching_.bound());
}

}  // namespace seamwise
