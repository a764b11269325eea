#include "solve/effort_run.h"

#include <utility>

#include "solve/metrics.h"

namespace seamwise {

EffortRun::EffortRun(const Problem& problem, int effort, const Pattern& pattern,
                     std::vector<Mirror> known, const MatchRules& rules, SearchMemo* searches,
                     std::shared_ptr<FittingPlans>* plans)
    : problem_(problem),
      effort_(effort),
      pattern_(pattern),
      known_(std::move(known)),
      rules_(rules),
      searches_(searches),
      plans_(plans) {
  begin({});
}

void EffortRun::begin(std::vector<Alignments> offered) {
  run_ = std::make_unique<BestRun>(problem_, pattern_, known_, rules_, std::move(offered),
                                   searches_, plans_);
}

double EffortRun::fit(const BestRun& run) const {
  return fitAny(problem_.print.group.joining(rules_.continuous_only), pattern_, run.shapes(),
                run.alignment());
}

bool EffortRun::advance() {
  if (round_ == effort_) return false;
  if (run_->advance()) return true;
  if (!best_ || fit(*run_) < fit(*best_)) best_ = std::move(run_);
  if (++round_ == effort_) return false;
  ++problem_.options.seed;
  begin({best_->search()});
  return true;
}

}  // namespace seamwise
