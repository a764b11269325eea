#include "solve/fit_run.h"

#include <algorithm>

#include "alignment/refine.h"
#include "deform/prolong.h"
#include "solve/metrics.h"
#include "solve/search_run.h"

namespace seamwise {
namespace {

/// Newton steps before lengths and reach must settle, and those of them from each start.
struct Steps {
  int all, trial;
};
constexpr Steps kSteps = {7, 2};
constexpr Steps kCoarseSteps = {10, 3};  ///< they take little time
constexpr int kFineSteps = 2;            ///< after coarse ones
constexpr int kRealignEvery = 3;         ///< steps between new joins and alignments

std::size_t verticesOf(const Pattern& pattern) {
  std::size_t count = 0;
  for (const Piece& piece : pattern.pieces) count += piece.rest.size();
  return count;
}

}  // namespace

FitRun::FitRun(const Pattern& pattern, const MatchProblem& match, const MatchRules& rules,
               const FittingRules& fitting, FittingPlans& plans, std::vector<Alignments> starts)
    : pattern_(pattern),
      match_(match),
      rules_(rules),
      fitting_rules_(fitting),
      plans_(plans),
      fitting_(std::make_unique<SeamFitting>(plans.fine(pattern), pattern, match.group, fitting)) {
  for (Alignments& leaders : starts) starts_.push_back({std::move(leaders), {}});
  place(starts_[0].leaders);
  double mismatch = 0;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s)
    if (pattern.seams[s].matched && !pattern.seams[s].twin) mismatch += fitting_->joins()[s].cost;
  perfect_ = mismatch < SearchRun::kPerfect;
}

/// Steps are taken on the coarser mesh from now on, where there is one.
void FitRun::goCoarse() {
  begun_ = true;
  if (const CoarserPlan* coarse = plans_.coarse(pattern_)) {
    coarser_ = &coarse->coarser;
    coarse_pattern_ = coarser_->pattern;
    for (std::size_t s = 0; s < pattern_.seams.size(); ++s) {
      coarse_pattern_.seams[s].weight = pattern_.seams[s].weight;
      coarse_pattern_.seams[s].matched = pattern_.seams[s].matched;
    }
    fine_ = std::move(fitting_);
    fitting_ =
        std::make_unique<SeamFitting>(coarse->plan, coarse_pattern_, match_.group, fitting_rules_);
    fine_step_ = static_cast<double>(verticesOf(pattern_)) /
                 static_cast<double>(verticesOf(coarse_pattern_));
  }
  const Steps steps = coarser_ ? kCoarseSteps : kSteps;
  steps_ = steps.all, trial_steps_ = steps.trial;
  planned_ = steps.all + steps.trial * (static_cast<double>(starts_.size()) - 1) +
             (coarser_ ? kFineSteps * fine_step_ : 0);
  for (Start& start : starts_) start.states = fitting_->restStates();
  resume(0);
}

void FitRun::goFine() {
  fine_->setStates(prolonged(*coarser_, *fitting_, *fine_));
  coarse_factorisations_ = fitting_->factorisations();
  fitting_ = std::move(fine_);
  fitting_->chooseJoins(alignment_);
}

void FitRun::place(const Alignments& leaders) {
  leaders_ = leaders;
  alignment_ = match_.expanded(leaders);
  fitting_->chooseJoins(alignment_);
}

void FitRun::resume(std::size_t start) {
  current_ = start;
  fitting_->setStates(starts_[start].states);
  place(starts_[start].leaders);
}

void FitRun::realign() {
  const MatchProblem now =
      makeMatchProblem(fitted(), fitting_->shapes(), fitted().mirrors, rules_, match_.group);
  std::vector<int> all(now.leaders.size());
  for (std::size_t l = 0; l < all.size(); ++l) all[l] = static_cast<int>(l);
  refine(now, SampledSeams<double>(now, 0), leaders_, all, 2);
  alignment_ = now.expanded(leaders_);
  fitting_->chooseJoins(alignment_);
}

bool FitRun::advance() {
  if (perfect_) return false;
  if (!begun_) {
    goCoarse();
    return true;
  }
  fitting_->step(alignment_);
  ++iterations_;
  if (coarser_ && !fine_) {
    done_ += fine_step_;
    return ++fine_steps_ < kFineSteps;
  }
  done_ += 1;
  Start& start = starts_[current_];
  ++start.steps;
  if (start.steps % kRealignEvery == 0 && start.steps < steps_) realign();
  if (start.steps == trial_steps_ && starts_.size() > 1) compareStarts();
  if (starts_[current_].steps < steps_) return true;
  if (fine_) goFine();
  return coarser_ != nullptr;
}

/// After a start's few steps: the next one, or back to the best.
void FitRun::compareStarts() {
  Start& start = starts_[current_];
  start.leaders = leaders_;
  start.states = fitting_->states();
  start.fit = fitAny(match_.group, fitted(), fitting_->shapes(), alignment_);
  if (current_ + 1 < starts_.size()) return resume(current_ + 1);
  const auto best = std::min_element(
      starts_.begin(), starts_.end(), [](const Start& a, const Start& b) { return a.fit < b.fit; });
  resume(static_cast<std::size_t>(best - starts_.begin()));
}

double FitRun::fraction() const { return std::min(1.0, done_ / planned_); }

}  // namespace seamwise
