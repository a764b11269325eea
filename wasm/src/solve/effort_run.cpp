#include "solve/effort_run.h"

#include <algorithm>
#include <utility>

#include "solve/metrics.h"

namespace seamwise {
namespace {

/// Outlines that may move further do not always end with less: what these find is a shape that
/// those may have as well. [cm]
constexpr double kUsualChange = 1.0;

}  // namespace

EffortRun::EffortRun(const Problem& problem, int effort, const Pattern& pattern,
                     std::vector<Mirror> known, const MatchRules& rules, SearchMemo* searches,
                     std::shared_ptr<FittingPlans>* plans)
    : problem_(problem),
      most_(problem.options.max_change_cm),
      rounds_(most_ > kUsualChange ? effort + 1 : effort),
      pattern_(pattern),
      known_(std::move(known)),
      rules_(rules),
      searches_(searches),
      plans_(plans) {
  problem_.options.max_change_cm = std::min(most_, kUsualChange);
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
  if (round_ == rounds_) return false;
  if (run_->advance()) return true;
  if (!best_ || fit(*run_) < fit(*best_)) best_ = std::move(run_);
  if (++round_ == rounds_) return false;
  if (problem_.options.max_change_cm < most_)
    problem_.options.max_change_cm = most_;
  else
    ++problem_.options.seed;
  begin({best_->search()});
  return true;
}

}  // namespace seamwise
