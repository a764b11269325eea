#include "methods/best_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deform/shape_limits.h"
#include "methods/drafted.h"
#include "methods/metrics.h"
#include "methods/predicted_mismatch.h"
#include "methods/seam_rules.h"
#include "tuning/progress.h"
#include "tuning/search.h"
#include "tuning/shaping.h"

namespace seamwise {
double BestRun::reachOf(const SolveOptions& options) {
  return std::min(options.max_change_cm, ShapingTuning::kMostReach);
}

double BestRun::slackOf(const SolveOptions& options) {
  return SearchTuning::kSlack * reachOf(options);
}

BestRun::BestRun(const Problem& problem, const Pattern& pattern, const std::vector<Mirror>& known,
                 const MatchRules& rules, std::vector<Alignments> offered,
                 std::vector<Alignments> starts, SearchMemo& searches,
                 std::shared_ptr<FittingPlans>& plans)
    : problem_(problem),
      pattern_(pattern),
      rules_(rules),
      reach_(reachOf(problem.options)),
      match_(makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules,
                              problem.print.group)),
      offered_starts_(std::move(starts)),
      searching_(problem, pattern, match_, known, rules, slackOf(problem.options),
                 std::move(offered), searches),
      length_error_(ShapingTuning::kLengthError),
      progress_(ProgressTuning::kPrepared) {
  alignment_ = search_result_ = match_.expanded(searching_.best());
  DeformationWeights weights;
  if (problem.options.open_edges == OpenEdges::kFree) weights.line = 0;
  if (problem.options.alpha) weights.conformal *= *problem.options.alpha;
  const double most = ShapingTuning::kReachShare * reach_;
  if (!plans || !plans->areFor(weights, most))
    plans = std::make_shared<FittingPlans>(weights, most);
  plans_ = plans;
  for (const Seam& seam : pattern.seams)
    length_error_ = std::min(length_error_, ShapingTuning::kSeamShare * kSeamTolerance /
                                                static_cast<double>(seam.a.vertices.size()));
}

void BestRun::searchStep() {
  const bool more = searching_.advance();
  alignment_ = match_.expanded(searching_.best());
  progress_ = std::max(
      progress_, searching_.isPerfect()
                     ? ProgressTuning::kPerfectlySearched
                     : ProgressTuning::kPrepared + searching_.share() * searching_.fraction());
  if (more) return;
  search_result_ = alignment_;
  searched_ = ProgressTuning::kPrepared + searching_.share();
  stage_ = Stage::kStartFitting;
}

bool BestRun::advance() {
  switch (stage_) {
    case Stage::kSearch:
      searchStep();
      break;
    case Stage::kStartFitting:
      startFitting();
      break;
    case Stage::kFitting:
      fittingStep();
      break;
    case Stage::kSeekAgain:
      seekAgain();
      break;
    case Stage::kSettle:
      settleStep();
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

/// Returns the answers under slack with the least predicted mismatch after shaping.
std::vector<FittingStart> BestRun::bestPredicted(std::size_t count) const {
  const WallpaperGroup group = match_.joining();
  const Shapes rest = restShapes(pattern_);
  const std::vector<double> lengths = seamLengths(pattern_, rest);
  const std::vector<double> placed = localMismatches(group, pattern_, rest, search_result_);
  std::vector<std::pair<double, std::size_t>> by_mismatch;
  const std::vector<Alignments>& answers = searching_.underSlack();
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Alignments at = match_.expanded(answers[k]);
    by_mismatch.emplace_back(
        mismatchUnderRules(pattern_, predictedMismatches(group, pattern_, at, reach_), lengths,
                           placed),
        k);
  }
  std::sort(by_mismatch.begin(), by_mismatch.end());
  std::vector<FittingStart> starts;
  for (const auto& [mismatch, k] : by_mismatch)
    if (starts.size() < count) starts.push_back({answers[k]});
  return starts;
}

std::vector<Alignments> BestRun::compared() const {
  std::vector<Alignments> all;
  for (const auto* few : {&searching_.atRest(), &searching_.underSlack()})
    for (const Alignments& leaders : *few) all.push_back(match_.expanded(leaders));
  return all;
}

/// Starts fitting from the best few answers under slack, from the offered starts and from the
/// search's own answer.
void BestRun::startFitting() {
  std::vector<FittingStart> from = bestPredicted(ShapingTuning::kStarts);
  for (const Alignments& at : offered_starts_) from.push_back({match_.ofLeaders(at)});
  from.push_back({searching_.best(), true});
  const FittingRules rules{problem_.options.continuous_only,
                           problem_.options.average_seam_shapes.value_or(false),
                           problem_.options.locked};
  fitting_ = std::make_unique<FittingStage>(pattern_, match_, rules_, rules, *plans_,
                                            std::move(from), reach_);
  alignment_ = fitting_->alignment();
  stage_ = Stage::kFitting;
  if (fitting_->isPerfect()) {
    stage_ = Stage::kSettle;
    progress_ = std::max(progress_, ProgressTuning::kPerfectlySetUp);
  }
  if (problem_.options.max_change_cm < kLeastChange) finish();
}

void BestRun::fittingStep() {
  if (!fitting_->advance()) {
    stage_ = Stage::kSettle;
    settled_ = 0;
    for (PartDeformation& deformation : fitting_->fitting().deformations())
      deformation.settling = 0;
  }
  if (fitting_->needsStart()) {
    if (!std::exchange(sought_again_, true)) {
      searching_.seekAgain(fitting_->searchFactors());
      stage_ = Stage::kSeekAgain;
    } else {
      fitting_->goOn({});
    }
  }
  alignment_ = fitting_->alignment();
  progress_ =
      std::max(progress_, searched_ + (ProgressTuning::kFitted - searched_) * fitting_->fraction());
}

/// Seeks another answer under slack to fit from, with more weight on the seams that previous starts
/// left worse off.
void BestRun::seekAgain() {
  if (searching_.advance()) return;
  fitting_->goOn(bestPredicted(1)[0].leaders);
  stage_ = Stage::kFitting;
}

/// Returns whether the part keeps every limit of a finished shape, with sewn edges within `length`
/// cm of their length.
bool BestRun::keepsLimits(const PartDeformation& deformation, double length) const {
  const PartDeformation::Violations v = deformation.violations();
  return v.length < length &&
         v.reach < ShapingTuning::kReachExcess * problem_.options.max_change_cm &&
         v.kink < kSettledLimits.kink && v.stretch < kSettledLimits.stretch &&
         !fitting_->fitting().crosses(deformation.part().piece);
}

/// Settles the parts that break limits; the others rest. A part gets stiffer where it bends too
/// much and finally holds its shape. A part that does not settle restarts from rest, with less
/// reach around its faults; the last restart has no targets.
void BestRun::settleStep() {
  bool all_kept = true;
  for (PartDeformation& deformation : fitting_->fitting().deformations()) {
    if (keepsLimits(deformation, length_error_)) continue;
    all_kept = false;
    const int remedies = deformation.settling / ShapingTuning::kSettleSteps,
              step = deformation.settling % ShapingTuning::kSettleSteps;
    // Lengths that are almost kept only need more steps.
    if (step == 0 && remedies > 0 &&
        !(keepsLimits(deformation, ShapingTuning::kAlmostKept) &&
          remedies < ShapingTuning::kMostRemedies)) {
      if (remedies > ShapingTuning::kMostRemedies)
        deformation.clearTargets();
      else
        fitting_->fitting().aimAtPartners(deformation, alignment_);
      deformation.restart(ShapingTuning::kRemedyReach);
    }
    const double share = step < ShapingTuning::kHoldAfter ? ShapingTuning::kStiffenFrom
                                                          : ShapingTuning::kStiffenHeld;
    deformation.stiffenKinks(share * kSettledLimits.kink);
    deformation.stiffenStretched(share * kSettledLimits.stretch);
    if (step == ShapingTuning::kHoldAfter) deformation.holdShape();
    deformation.step();
    ++deformation.settling;
  }
  fitting_->fitting().collectShapes();
  ++settled_;
  progress_ = std::max(progress_, 1 - (1 - ProgressTuning::kFitted) / (1 + settled_));
  if (!all_kept) ++settling_;
  if (!all_kept && settled_ <= ShapingTuning::kMostSettling) return;
  restUnsound();
  if (fitting_->review()) {
    restIfBetter();
    return finish();
  }
  stage_ = Stage::kFitting;
}

/// Returns parts that still break a limit to their drafted shape, which breaks none.
void BestRun::restUnsound() {
  ShapeLimits limits;
  limits.moved = problem_.options.max_change_cm;
  std::vector<char> unsound(fitting_->fitting().deformations().size());
  for (bool again = true; again;) {
    again = false;
    std::fill(unsound.begin(), unsound.end(), 0);
    const Shapes& now = fitting_->fitting().shapes();
    for (std::size_t p = 0; p < now.size(); ++p)
      if (brokenLimit(pattern_.pieces[p], now[p], limits) != BrokenLimit::kNone)
        unsound[fitting_->fitting().partIndexOf(static_cast<int>(p))] = 1;
    for (const Seam& seam : pattern_.seams)
      if (seamError(seam, now) > kSeamTolerance)
        unsound[fitting_->fitting().partIndexOf(seam.a.piece)] =
            unsound[fitting_->fitting().partIndexOf(seam.b.piece)] = 1;
    for (std::size_t c = 0; c < unsound.size(); ++c) {
      PartDeformation& deformation = fitting_->fitting().deformations()[c];
      if (!unsound[c] || deformation.state().shape == deformation.part().rest) continue;
      deformation.setState(deformation.restState());
      again = true;
    }
    fitting_->fitting().collectShapes();
  }
}

/// Restores the drafted outlines if shaping gained nothing, as for most gathers. Also restores
/// them, in the drafted layout, if low weights of some seams make the print miss by more than
/// there.
void BestRun::restIfBetter() {
  const WallpaperGroup group = match_.joining();
  const Shapes rest = evenedShapes(pattern_);
  if (!isSewable(pattern_, rest)) return;
  if (answerCost(group, pattern_, rest, search_result_) <
      answerCost(group, pattern_, fitting_->fitting().shapes(), alignment_))
    restAt(search_result_);
  const Alignments drafted = draftedLayout(problem_, match_);
  const std::vector<double> lengths = seamLengths(pattern_, fitting_->fitting().shapes());
  const auto missed = [&](const Shapes& shapes, const Alignments& at) {
    if (problem_.options.visibility == Visibility::kByPlace)
      return answerCost(group, pattern_, shapes, at);
    return meanMismatch(localMismatches(group, pattern_, shapes, at), lengths);
  };
  if (missed(rest, drafted) < missed(fitting_->fitting().shapes(), alignment_)) {
    const double cost = costAtRest(drafted);
    if (cost > SearchTuning::kPerfectCost) of_bound_ = costAtRest(search_result_) / cost;
    restAt(search_result_ = drafted);
  }
}

void BestRun::restAt(const Alignments& at) {
  fitting_->fitting().setStates(fitting_->fitting().restStates());
  alignment_ = at;
}

void BestRun::finish() {
  stage_ = Stage::kDone;
  progress_ = 1;
}

RunOutcome BestRun::outcome() const {
  return {alignment(), search(),     compared(),      searchBound(),
          shapes(),    iterations(), factorisations()};
}

Phase BestRun::phase() const {
  if (stage_ == Stage::kDone) return Phase::kDone;
  return stage_ < Stage::kStartFitting ? Phase::kAlignment : Phase::kDeformation;
}

double BestRun::fraction() const { return progress_; }

const Shapes& BestRun::shapes() const { return fitting_->fitting().shapes(); }

}  // namespace seamwise
