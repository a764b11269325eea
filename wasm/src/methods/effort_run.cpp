#include "methods/effort_run.h"

#include <algorithm>
#include <utility>

#include "alignment/bound/lower_bound.h"
#include "deform/shape_limits.h"
#include "methods/metrics.h"
#include "tuning/proof.h"
#include "tuning/search.h"
#include "tuning/shaping.h"

namespace seamwise {
EffortRun::EffortRun(const Problem& problem, Mesh asked, std::optional<Mesh> symmetric,
                     std::vector<Mirror> known, const MatchRules& rules, SearchMemo& searches)
    : problem_(problem),
      asked_(asked),
      symmetric_(symmetric),
      known_(std::move(known)),
      rules_(rules),
      searches_(searches) {
  const SolveOptions& options = problem.options;
  const auto plan = [&](bool is_symmetric) {
    if (options.max_change_cm > ShapingTuning::kUsualChange)
      rounds_.push_back({is_symmetric, ShapingTuning::kUsualChange, options.seed});
    for (std::uint32_t k = 0; k < options.effort; ++k)
      rounds_.push_back({is_symmetric, options.max_change_cm, options.seed + k});
  };
  if (symmetric_ && options.max_change_cm >= kLeastChange) plan(true);
  plan(false);
  begin();
}

void EffortRun::begin() {
  const Round& round = rounds_[ended_];
  problem_.options.max_change_cm = round.change;
  problem_.options.seed = round.seed;
  std::vector<Alignments> offered, starts;
  if (const BestRun* before = (round.symmetric ? best_symmetric_ : best_asked_).get())
    offered.push_back(before->search());
  // the search begins with what was found for the symmetric pattern, and so may the fit
  if (!round.symmetric && best_symmetric_) starts.push_back(best_symmetric_->alignment());
  const Mesh& mesh = round.symmetric ? *symmetric_ : asked_;
  run_ = std::make_unique<BestRun>(problem_, mesh.pattern, known_, rules_, std::move(offered),
                                   std::move(starts), searches_, mesh.plans);
}

double EffortRun::fit(const BestRun& run) const {
  return fitAny(problem_.print.group.joining(rules_.continuous_only), asked_.pattern, run.shapes(),
                run.alignment());
}

/// No alignment costs less than this share of search(), which may be that of the symmetric pattern.
double EffortRun::searchBound() const {
  if (!symmetric_stands_) return best().searchBound();
  const double bound = best_asked_->searchBound() * best_asked_->searchCost();
  const double cost = searchCost();
  const bool is_proven =
      bound >= (1 - ProofTuning::kProven) * cost || cost <= SearchTuning::kPerfectCost;
  return is_proven ? 1 : bound / cost;
}

const BestRun& EffortRun::best() const {
  if (!isDone()) return *run_;
  return symmetric_stands_ ? *best_symmetric_ : *best_asked_;
}

bool EffortRun::advance() {
  if (isDone()) return false;
  if (run_->advance()) return true;
  auto& best = rounds_[ended_].symmetric ? best_symmetric_ : best_asked_;
  if (!best || fit(*run_) < fit(*best)) best = std::move(run_);
  if (++ended_ < rounds_.size()) {
    begin();
    return true;
  }
  symmetric_stands_ = best_symmetric_ && fit(*best_symmetric_) < fit(*best_asked_) &&
                      isSewable(asked_.pattern, best_symmetric_->shapes());
  return false;
}

}  // namespace seamwise
