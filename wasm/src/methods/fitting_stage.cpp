#include "methods/fitting_stage.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "alignment/icp/refine.h"
#include "deform/prolong.h"
#include "methods/metrics.h"
#include "methods/seam_rules.h"
#include "methods/search_stage.h"
#include "tuning/search.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

std::size_t verticesOf(const Pattern& pattern) {
  std::size_t count = 0;
  for (const Piece& piece : pattern.pieces) count += piece.rest.size();
  return count;
}

}  // namespace

FittingStage::FittingStage(const Pattern& pattern, const MatchProblem& match,
                           const MatchRules& rules, const FittingRules& fitting,
                           FittingPlans& plans, std::vector<FittingStart> starts, double reach)
    : pattern_(pattern),
      match_(match),
      rules_(rules),
      fitting_rules_(fitting),
      plans_(plans),
      reach_(reach),
      fine_(std::make_unique<SeamFitting>(plans.fine(pattern), pattern, match.group, fitting)),
      fitting_(fine_.get()),
      search_factors_(pattern.seams.size(), 1) {
  for (FittingStart& start : starts) add(std::move(start));
  placed_ = match.expanded(starts_.back().leaders);
  place(starts_[0].leaders);
  double mismatch = 0;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s)
    if (counts(pattern.seams[s])) mismatch += fitting_->joins()[s].cost;
  perfect_ = mismatch < SearchTuning::kPerfectCost;
}

void FittingStage::add(FittingStart from) {
  Start start;
  static_cast<FittingStart&>(start) = std::move(from);
  start.pull_factors.assign(pattern_.seams.size(), 1);
  start.margins.assign(pattern_.seams.size(), 0);
  starts_.push_back(std::move(start));
}

/// Plans the steps, on the coarser mesh if there is one.
void FittingStage::begin() {
  begun_ = true;
  if ((plan_ = plans_.coarse(pattern_))) {
    coarse_pattern_ = plan_->coarser.pattern;
    for (std::size_t s = 0; s < pattern_.seams.size(); ++s) {
      coarse_pattern_.seams[s].weight = pattern_.seams[s].weight;
      coarse_pattern_.seams[s].matched = pattern_.seams[s].matched;
      coarse_pattern_.seams[s].visibility = pattern_.seams[s].visibility;
    }
    coarse_fitting_ =
        std::make_unique<SeamFitting>(plan_->plan, coarse_pattern_, match_.group, fitting_rules_);
    fine_step_ = static_cast<double>(verticesOf(pattern_)) /
                 static_cast<double>(verticesOf(coarse_pattern_));
  }
  steps_ = plan_ ? ShapingTuning::kCoarseSteps : ShapingTuning::kSteps;
  trial_steps_ = plan_ ? ShapingTuning::kCoarseTrialSteps : ShapingTuning::kTrialSteps;
  planned_ = 3 * steps_ + trial_steps_ * (static_cast<double>(starts_.size()) - 1) +
             (plan_ ? ShapingTuning::kFineSteps * fine_step_ : 0);
  goCoarse();
  resume(0);
}

void FittingStage::goCoarse() {
  if (!plan_) return;
  coarse_ = true;
  fitting_ = coarse_fitting_.get();
}

void FittingStage::goFine() {
  fine_->setStates(prolonged(plan_->coarser, *fitting_, *fine_));
  fitting_ = fine_.get();
  coarse_ = false;
  pull();
  fitting_->chooseJoins(alignment_);
  // The mismatch by placing alone differs a little between the meshes.
  fine_steps_ = ShapingTuning::kFineSteps;
  if (starts_[current_].stays || !isWorseThanPlaced()) return;
  realign();
  fine_steps_ += ShapingTuning::kMoreFineSteps;
}

/// Returns whether some seam misses by more than placing alone allows.
bool FittingStage::isWorseThanPlaced() const {
  const auto now = localMismatches(match_.joining(), fitted(), fitting_->shapes(), alignment_);
  const auto placed = placedMismatches();
  for (std::size_t s = 0; s < now.size(); ++s)
    if (now[s] > greatestMean(placed[s], fitted().seams[s].visibility)) return true;
  return false;
}

void FittingStage::place(const Alignments& leaders) {
  leaders_ = leaders;
  alignment_ = match_.expanded(leaders);
  fitting_->chooseJoins(alignment_);
}

/// Continues a start. The first time it is at rest, and all seams within reach of shaping pull.
void FittingStage::resume(std::size_t index) {
  current_ = index;
  Start& start = starts_[index];
  const bool first = start.states.empty();
  if (first) start.states = fitting_->restStates();
  fitting_->setStates(start.states);
  place(start.leaders);
  const Pattern& pattern = fitted();
  if (first) start.shaped.assign(pattern.seams.size(), 0);
  for (std::size_t s = 0; s < pattern.seams.size() && first; ++s)
    start.shaped[s] = counts(pattern.seams[s]) &&
                      isWithinReach(joinMismatch(fitting_->joins()[s], pattern.seams[s],
                                                 fitting_->shapes(), alignment_),
                                    reach_);
  pull();
}

/// Repeats the current start from rest, with other seams pulling.
void FittingStage::again() {
  Start& start = starts_[current_];
  start.leaders = leaders_;
  start.steps = 0;
  start.ended = false;
  start.states = fitting_->restStates();
  start.favours.clear();
  resume(current_);
}

/// Multiple of a seam's weight in the current start.
double FittingStage::factorOf(std::size_t seam) const {
  const Start& start = starts_[current_];
  return start.pull_factors[seam] * (start.favours.empty() ? 1 : start.favours[seam]);
}

void FittingStage::pull() {
  const Start& start = starts_[current_];
  std::vector<double> pulls(start.shaped.size(), 1);
  for (std::size_t s = 0; s < pulls.size(); ++s)
    if (counts(fitted().seams[s])) pulls[s] = start.shaped[s] ? factorOf(s) : 0;
  fitting_->setPulls(pulls);
}

std::vector<double> FittingStage::placedMismatches() const {
  return localMismatches(match_.joining(), fitted(), restShapes(fitted()), placed_);
}

void FittingStage::realign() {
  const Start& start = starts_[current_];
  if (start.stays) return fitting_->chooseJoins(alignment_);
  Pattern reweighted = fitted();
  for (std::size_t s = 0; s < reweighted.seams.size(); ++s)
    reweighted.seams[s].weight *= factorOf(s);
  MatchProblem now =
      makeMatchProblem(reweighted, fitting_->shapes(), reweighted.mirrors, rules_, match_.group);
  const std::vector<double> placed = placedMismatches();
  for (MatchSeam& seam : now.seams) {
    if (seam.seam < 0) continue;
    const auto s = static_cast<std::size_t>(seam.seam);
    if (!start.shaped[s] || start.rounds > 0 || start.steps >= ShapingTuning::kLimitedFrom)
      seam.limit =
          ShapingTuning::kLimitShare * greatestMean(placed[s], reweighted.seams[s].visibility) -
          start.margins[s];
  }
  std::vector<int> all(now.leaders.size());
  std::iota(all.begin(), all.end(), 0);
  refine(now, SampledSeams<double>(now, 0), leaders_, all, ShapingTuning::kRealignIterations);
  alignment_ = now.expanded(leaders_);
  fitting_->chooseJoins(alignment_);
}

bool FittingStage::advance() {
  if (perfect_) return false;
  if (!begun_) {
    begin();
    return true;
  }
  if (needs_start_) return true;
  if (given_up_ || std::exchange(stalled_, false)) return false;
  fitting_->step(alignment_);
  ++iterations_;
  if (plan_ && !coarse_) {
    done_ += fine_step_;
    return --fine_steps_ > 0;
  }
  done_ += 1;
  Start& start = starts_[current_];
  ++start.steps;
  if (steps_ - start.steps == ShapingTuning::kFavouredSteps) favourNearMatches();
  if (start.steps % ShapingTuning::kRealignEvery == 0 && start.steps < steps_) realign();
  if (start.steps == trial_steps_ && !start.mismatch) return leave();
  return start.steps < steps_ || endSteps();
}

/// Judges the seams after a start's steps. Returns whether more steps remain.
bool FittingStage::endSteps() {
  Start& start = starts_[current_];
  const Judgement found = judge();
  const int most = start.retried ? ShapingTuning::kMostRetried : ShapingTuning::kMostRounds;
  if (found == Judgement::kOtherPulls && ++start.rounds < most) {
    again();
    return true;
  }
  if (found == Judgement::kGood || start.stays)
    start.ended = true;
  else
    fail();
  return leave();
}

/// Stores the results of the current start and continues with the best one. Returns whether more
/// steps remain.
bool FittingStage::leave() {
  Start& start = starts_[current_];
  start.leaders = leaders_;
  start.states = fitting_->states();
  start.mismatch = answerCost(match_.joining(), fitted(), fitting_->shapes(), alignment_);
  start.mismatch_under_rules =
      mismatchUnderRules(
          fitted(), localMismatches(match_.joining(), fitted(), fitting_->shapes(), alignment_),
          seamLengths(fitted(), fitting_->shapes()), placedMismatches()) +
      unmatchedCost(match_.joining(), fitted(), fitting_->shapes(), alignment_);
  return goOnFromBest();
}

/// Continues with an untried start, else with the best one under the rules as long as it may still
/// beat those that have ended.
bool FittingStage::goOnFromBest() {
  const std::size_t none = starts_.size();
  std::size_t open = none, ended = none;
  for (std::size_t k = starts_.size(); k-- > 0;) {
    const Start& start = starts_[k];
    if (start.failed) continue;
    if (start.ended) {
      if (ended == none || *start.mismatch < *starts_[ended].mismatch) ended = k;
    } else if (open == none || !start.mismatch ||
               (starts_[open].mismatch &&
                *start.mismatch_under_rules < *starts_[open].mismatch_under_rules)) {
      open = k;
    }
  }
  const bool ahead = open != none && (ended == none || !starts_[open].mismatch ||
                                      *starts_[open].mismatch < *starts_[ended].mismatch);
  const std::size_t best = ahead ? open : ended;
  if (starts_[best].stays && starts_[best].ended && may_seek_) {
    needs_start_ = true;
    return true;
  }
  if (starts_[best].stays && starts_[best].ended && retryNearest()) return true;
  if (best != current_) resume(best);
  if (!starts_[best].ended) return true;
  if (!plan_) return false;
  goFine();
  return true;
}

/// Allows more rounds to the start that failed by least. Returns whether one failed by little.
bool FittingStage::retryNearest() {
  Start* nearest = nullptr;
  for (Start& start : starts_)
    if (start.failed && !start.retried && start.reviews == 0 &&
        start.excess <= ShapingTuning::kFailedByLittle &&
        (!nearest || start.excess < nearest->excess))
      nearest = &start;
  if (!nearest) return false;
  nearest->failed = false, nearest->retried = true;
  resume(static_cast<std::size_t>(nearest - starts_.data()));
  again();
  return true;
}

void FittingStage::goOn(std::optional<Alignments> leaders) {
  needs_start_ = false;
  if (leaders)
    add({std::move(*leaders)});
  else
    may_seek_ = false;
  if (!goOnFromBest()) stalled_ = true;
}

int FittingStage::factorisations() const {
  return fine_->factorisations() + (coarse_fitting_ ? coarse_fitting_->factorisations() : 0);
}

double FittingStage::fraction() const { return std::min(1.0, done_ / planned_); }

}  // namespace seamwise
