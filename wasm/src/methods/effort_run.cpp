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
EffortRun::EffortRun(const Problem& problem, Mesh requested, std::optional<Mesh> symmetric,
                     std::vector<Mirror> known, const MatchRules& rules, SearchMemo& searches,
                     RunMemo& runs)
    : problem_(problem),
      requested_(requested),
      symmetric_(symmetric),
      known_(std::move(known)),
      rules_(rules),
      searches_(searches),
      runs_(runs),
      requested_change_(BestRun::reachOf(problem.options)) {
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

/// Begins the next round that has to be run; known ones end at once.
void EffortRun::begin() {
  while (!isDone()) {
    const Round& round = rounds_[ended_];
    problem_.options.max_change_cm = round.change;
    problem_.options.seed = round.seed;
    std::vector<Alignments> offered, starts;
    if (const auto& before = bestOf(round)) offered.push_back(before->search);
    // SearchStage starts from the answer for the symmetric pattern anyway; fitting may start from
    // it.
    if (!round.symmetric && best_symmetric_) starts.push_back(best_symmetric_->alignment);
    const Mesh& mesh = round.symmetric ? *symmetric_ : requested_;
    const bool guided = known_.size() > mesh.pattern.mirrors.size();
    const Pattern& pattern = mesh.pattern;
    inputs_.emplace(problem_, pattern,
                    makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules_,
                                     problem_.print.group),
                    guided ? known_.size() : 0, offered, starts);
    if (const RunOutcome* known = runs_.find(*inputs_)) {
      end(*known);
      continue;
    }
    run_ = std::make_unique<BestRun>(problem_, mesh.pattern, known_, rules_, std::move(offered),
                                     std::move(starts), searches_, mesh.plans);
    return;
  }
}

void EffortRun::end(RunOutcome outcome) {
  std::optional<RunOutcome>& best = bestOf(rounds_[ended_]);
  if (!best || mismatchOf(outcome) < mismatchOf(*best)) best = std::move(outcome);
  if (++ended_ == rounds_.size()) tryLessChange();
  symmetric_stands_ = isDone() && best_symmetric_ &&
                      mismatchOf(*best_symmetric_) < mismatchOf(*best_requested_) &&
                      isSewable(requested_.pattern, best_symmetric_->shapes);
}

double EffortRun::mismatchOf(const RunOutcome& run) const {
  return answerCost(problem_.print.group.joining(rules_.continuous_only), requested_.pattern,
                    run.shapes, run.alignment);
}

/// Cost of the drafted pieces at these alignments, by the seams' weights. [cm2]
double EffortRun::costAtRest(const Alignments& at) const {
  const Pattern& pattern = requested_.pattern;
  const MatchProblem match =
      makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules_, problem_.print.group);
  return match.cost(match.ofLeaders(at));
}

/// No alignment costs less than this share of search(), which may be that of the symmetric pattern.
double EffortRun::searchBound() const {
  if (!symmetric_stands_) return best().search_bound;
  const double bound = best_requested_->search_bound * costAtRest(best_requested_->search);
  const double cost = searchCost();
  const bool is_proven =
      bound >= (1 - ProofTuning::kProven) * cost || cost <= SearchTuning::kPerfectCost;
  return is_proven ? 1 : bound / cost;
}

/// Returns whether the print misses somewhere, and yet every piece has its drafted lines.
bool EffortRun::keptLines(const RunOutcome& run) const {
  return mismatchOf(run) > SearchTuning::kPerfectCost &&
         hasDraftedLines(requested_.pattern, run.shapes);
}

/// Plans rounds of half the greatest change if no shape was found in the rounds so far. Shapes that
/// may move further can fail where others hold.
void EffortRun::tryLessChange() {
  const Round last = rounds_.back();
  const double change = last.change / 2;
  if (change < kLeastChange || change < ShapingTuning::kLeastHalved * requested_change_) return;
  if (!keptLines(*best_requested_) || (best_symmetric_ && !keptLines(*best_symmetric_))) return;
  if (symmetric_) rounds_.push_back({true, change, last.seed});
  rounds_.push_back({false, change, last.seed});
}

bool EffortRun::advance() {
  if (isDone()) return false;
  const bool more = run_->advance();
  const double now = static_cast<double>(ended_) + run_->fraction();
  fraction_ = std::max(fraction_, now / static_cast<double>(rounds_.size()));
  if (more) return true;
  RunOutcome outcome = run_->outcome();
  runs_.add(*std::move(inputs_), outcome);
  end(std::move(outcome));
  begin();
  if (isDone()) run_.reset();
  return !isDone();
}

}  // namespace seamwise
