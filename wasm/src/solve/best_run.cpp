#include "solve/best_run.h"

#include <algorithm>
#include <cmath>

#include "alignment/refine.h"
#include "solve/metrics.h"
#include "solve/promise.h"

namespace seamwise {
namespace {

constexpr int kFitSteps = 7;        ///< Newton steps before lengths and reach must settle
constexpr int kTrialSteps = 2;      ///< of them, from each start
constexpr int kRealignEvery = 3;    ///< steps between new joins and alignments
constexpr int kSettleSteps = 15;    ///< under fixed targets, before a remedy
constexpr int kHoldAfter = 1;       ///< of them, towards the targets; then the shape is held
constexpr int kMostRemedies = 4;    ///< then a part gives up its targets
constexpr int kMostSettling = 200;  ///< steps in all
constexpr double kRemedyReach = 0.6;
constexpr double kSlack = 1.3;
constexpr double kMostReach =
    2.0;  ///< cm: beyond it, outlines lose their lines and nothing is gained

/// Progress at the end of stages, by the share of time that they take as a rule. What is perfect as
/// it lies has only its set-up left.
constexpr double kPrepared = 0.13, kFitted = 0.95;
constexpr double kPerfectlySearched = 0.72, kPerfectlySetUp = 0.86;

/// Limits that a finished shape keeps, a little inside what is promised.
constexpr double kLengthError = 5e-5;       ///< cm an edge; a seam has up to a hundred
constexpr double kKink = 12.5 * kPi / 180;  ///< rad
constexpr double kStiffenFrom = 0.9;        ///< share of kKink; while a shape is held:
constexpr double kStiffenHeld = 0.99;
constexpr double kStretch = 0.12;
constexpr double kReachExcess = 0.012;  ///< share of the greatest change
constexpr double kReachMargin = 0.985;

}  // namespace

BestRun::BestRun(const Problem& problem, const Pattern& pattern, const std::vector<Mirror>& known,
                 const MatchRules& rules, SearchMemo* memo)
    : problem_(problem),
      pattern_(pattern),
      rules_(rules),
      reach_(std::min(problem.options.max_change_cm, kMostReach)),
      match_(makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules,
                              problem.print.group)),
      // two sides that may each move by the greatest change meet across somewhat less than twice it
      searching_(problem, pattern, match_, known, rules, kSlack * reach_, memo),
      progress_(kPrepared) {
  leaders_ = searching_.best();
  alignment_ = search_result_ = match_.expanded(leaders_);
}

void BestRun::search() {
  const bool more = searching_.advance();
  alignment_ = match_.expanded(searching_.best());
  progress_ = std::max(progress_, searching_.isPerfect()
                                      ? kPerfectlySearched
                                      : kPrepared + searching_.share() * searching_.fraction());
  if (more) return;
  leaders_ = searching_.best();
  search_result_ = alignment_;
  searched_ = kPrepared + searching_.share();
  stage_ = Stage::kStartFit;
}

bool BestRun::advance() {
  switch (stage_) {
    case Stage::kSearch:
      search();
      break;
    case Stage::kStartFit:
      startFit();
      break;
    case Stage::kFit:
      fitStep();
      break;
    case Stage::kSettle:
      settleStep();
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

/// Fits from the answer under slack and, where it differs, from the search's own; after a few steps
/// only the better one goes on.
void BestRun::startFit() {
  const SolveOptions& options = problem_.options;
  FittingRules rules;
  if (options.alpha) rules.weights.conformal *= *options.alpha;
  rules.max_change = kReachMargin * reach_;
  rules.continuous_only = options.continuous_only;
  rules.average_shapes = options.average_seam_shapes.value_or(false);
  fitting_ = std::make_unique<SeamFitting>(pattern_, problem_.print.group, rules);
  std::vector<Alignments> from = {searching_.underSlack()};
  const Alignments& plain = searching_.best();
  if (std::abs(match_.cost(plain) - match_.cost(from[0])) > SearchRun::kPerfect)
    from.push_back(plain);
  for (Alignments& leaders : from) starts_.push_back({std::move(leaders), fitting_->restStates()});
  stage_ = Stage::kFit;
  resume(0);
  if (problem_.options.max_change_cm < kLeastChange) finish();
}

void BestRun::resume(std::size_t start) {
  current_ = start;
  leaders_ = starts_[start].leaders;
  alignment_ = match_.expanded(leaders_);
  fitting_->setStates(starts_[start].states);
  fitting_->chooseJoins(alignment_);
  double mismatch = 0;
  for (std::size_t s = 0; s < pattern_.seams.size(); ++s)
    if (pattern_.seams[s].matched && !pattern_.seams[s].twin) mismatch += fitting_->joins()[s].cost;
  if (mismatch >= SearchRun::kPerfect) return;
  stage_ = Stage::kSettle;
  progress_ = std::max(progress_, kPerfectlySetUp);
}

void BestRun::realign() {
  MatchProblem now = makeMatchProblem(pattern_, fitting_->shapes(), pattern_.mirrors, rules_,
                                      problem_.print.group);
  std::vector<int> all(now.leaders.size());
  for (std::size_t l = 0; l < all.size(); ++l) all[l] = static_cast<int>(l);
  refine(now, SampledSeams<double>(now, 0), leaders_, all, 2);
  alignment_ = now.expanded(leaders_);
  fitting_->chooseJoins(alignment_);
}

void BestRun::fitStep() {
  Start& start = starts_[current_];
  fitting_->step(alignment_);
  ++iterations_, ++fit_steps_, ++start.steps;
  if (start.steps % kRealignEvery == 0 && start.steps < kFitSteps) realign();
  const int planned = kFitSteps + kTrialSteps * (static_cast<int>(starts_.size()) - 1);
  progress_ = std::max(progress_, searched_ + (kFitted - searched_) * fit_steps_ / planned);
  if (start.steps >= kFitSteps) stage_ = Stage::kSettle;
  if (start.steps != kTrialSteps || starts_.size() == 1) return;
  start.leaders = leaders_;
  start.states = fitting_->states();
  start.fit = fitAny(problem_.print.group, pattern_, fitting_->shapes(), alignment_);
  if (current_ + 1 < starts_.size()) return resume(current_ + 1);
  const auto better = std::min_element(
      starts_.begin(), starts_.end(), [](const Start& a, const Start& b) { return a.fit < b.fit; });
  resume(static_cast<std::size_t>(better - starts_.begin()));
}

/// Whether the part keeps everything that is promised of a finished shape.
bool BestRun::kept(const Cloth& cloth) const {
  const Cloth::Violations v = cloth.violations();
  return v.length < kLengthError && v.reach < kReachExcess * problem_.options.max_change_cm &&
         v.kink < kKink && v.stretch < kStretch && !fitting_->crosses(cloth.part().piece);
}

/// Parts that keep their limits rest; the others go on, stiffer where they bend too much, at last
/// holding their shape. A part that will not settle starts again from rest and may move less where
/// it went wrong; the last time without targets.
void BestRun::settleStep() {
  bool all_kept = true;
  for (Cloth& cloth : fitting_->cloths()) {
    if (kept(cloth)) continue;
    all_kept = false;
    const int remedies = cloth.settling / kSettleSteps, step = cloth.settling % kSettleSteps;
    if (step == 0 && remedies > 0) {
      if (remedies > kMostRemedies)
        cloth.clearTargets();
      else
        fitting_->aimAtPartners(cloth, alignment_);
      cloth.restart(kRemedyReach);
    }
    cloth.stiffenKinks((step < kHoldAfter ? kStiffenFrom : kStiffenHeld) * kKink);
    if (step == kHoldAfter) cloth.holdShape();
    cloth.step();
    ++cloth.settling;
  }
  fitting_->collectShapes();
  ++settled_;
  progress_ = std::max(progress_, 1 - (1 - kFitted) / (1 + settled_));
  if (!all_kept) ++iterations_;
  if (!all_kept && settled_ <= kMostSettling) return;
  restUnsound();
  restIfBetter();
  finish();
}

/// What breaks a promise after all stays as it was drafted, which breaks none.
void BestRun::restUnsound() {
  Limits limits;
  limits.moved = problem_.options.max_change_cm;
  std::vector<char> unsound(fitting_->cloths().size());
  for (bool again = true; again;) {
    again = false;
    std::fill(unsound.begin(), unsound.end(), 0);
    const Shapes& now = fitting_->shapes();
    for (std::size_t p = 0; p < now.size(); ++p)
      if (breachOf(pattern_.pieces[p], now[p], limits) != Breach::kNone)
        unsound[fitting_->clothOf(static_cast<int>(p))] = 1;
    for (const Seam& seam : pattern_.seams)
      if (seamError(seam, now) > kSeamTolerance)
        unsound[fitting_->clothOf(seam.a.piece)] = unsound[fitting_->clothOf(seam.b.piece)] = 1;
    for (std::size_t c = 0; c < unsound.size(); ++c) {
      Cloth& cloth = fitting_->cloths()[c];
      if (!unsound[c] || cloth.state().shape == cloth.part().rest) continue;
      cloth.setState(cloth.restState());
      again = true;
    }
    fitting_->collectShapes();
  }
}

/// Where nothing could be gained, gathers above all, outlines stay as they were drafted.
void BestRun::restIfBetter() {
  const WallpaperGroup& group = problem_.print.group;
  const Shapes rest = evenedShapes(pattern_);
  const bool sewable =
      std::all_of(pattern_.seams.begin(), pattern_.seams.end(),
                  [&](const Seam& seam) { return seamError(seam, rest) < kSeamTolerance; });
  if (!sewable || fitAny(group, pattern_, rest, search_result_) >=
                      fitAny(group, pattern_, fitting_->shapes(), alignment_))
    return;
  fitting_->setStates(fitting_->restStates());
  alignment_ = search_result_;
}

void BestRun::finish() {
  stage_ = Stage::kDone;
  progress_ = 1;
}

Phase BestRun::phase() const {
  if (stage_ == Stage::kDone) return Phase::kDone;
  return stage_ < Stage::kStartFit ? Phase::kAlignment : Phase::kDeformation;
}

double BestRun::fraction() const { return progress_; }

const Shapes& BestRun::shapes() const { return fitting_->shapes(); }

}  // namespace seamwise
