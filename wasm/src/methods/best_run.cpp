#include "methods/best_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deform/shape_limits.h"
#include "methods/drafted.h"
#include "methods/metrics.h"
#include "methods/predicted_mismatch.h"
#include "methods/seam_rules.h"

namespace seamwise {
namespace {

constexpr int kSettleSteps = 15;    ///< under fixed targets, before a remedy
constexpr int kHoldAfter = 1;       ///< of them, towards the targets; then the shape is held
constexpr int kMostRemedies = 4;    ///< then a part gives up its targets
constexpr int kMostSettling = 200;  ///< steps in all
constexpr double kRemedyReach = 0.6;
constexpr double kSlack = 1.6;
constexpr double kMostReach =
    2.0;  ///< cm: beyond it, outlines lose their lines and nothing is gained

/// Answers under slack to fit from.
constexpr std::size_t kStarts = 3;

/// Progress at the end of stages, by the share of time that they take as a rule. What is perfect as
/// it lies has only its set-up left.
constexpr double kFitted = 0.95;
constexpr double kPerfectlySearched = 0.72, kPerfectlySetUp = 0.86;

/// Limits that a finished shape keeps, a little inside those of the result.
constexpr double kLengthError = 5e-5;  ///< cm an edge, of seams with up to forty
constexpr double kSeamShare = 0.2;     ///< of the tolerance of a seam, for all its edges
constexpr double kAlmostKept = 2e-3;   ///< cm an edge
constexpr double kStiffenFrom = 0.9;   ///< share of its limits; while a shape is held:
constexpr double kStiffenHeld = 0.99;
constexpr double kReachExcess = 0.012;  ///< share of the greatest change
constexpr double kReachMargin = 0.985;

/// How far an outline vertex may move. [cm]
double reachOf(const SolveOptions& options) { return std::min(options.max_change_cm, kMostReach); }

}  // namespace

double BestRun::slackOf(const SolveOptions& options) { return kSlack * reachOf(options); }

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
      length_error_(kLengthError),
      progress_(kPrepared) {
  alignment_ = search_result_ = match_.expanded(searching_.best());
  DeformationWeights weights;
  if (problem.options.open_edges == OpenEdges::kFree) weights.line = 0;
  if (problem.options.alpha) weights.conformal *= *problem.options.alpha;
  const double most = kReachMargin * reach_;
  if (!plans || !plans->areFor(weights, most))
    plans = std::make_shared<FittingPlans>(weights, most);
  plans_ = plans;
  for (const Seam& seam : pattern.seams)
    length_error_ = std::min(
        length_error_, kSeamShare * kSeamTolerance / static_cast<double>(seam.a.vertices.size()));
}

void BestRun::searchStep() {
  const bool more = searching_.advance();
  alignment_ = match_.expanded(searching_.best());
  progress_ = std::max(progress_, searching_.isPerfect()
                                      ? kPerfectlySearched
                                      : kPrepared + searching_.share() * searching_.fraction());
  if (more) return;
  search_result_ = alignment_;
  searched_ = kPrepared + searching_.share();
  stage_ = Stage::kStartFit;
}

bool BestRun::advance() {
  switch (stage_) {
    case Stage::kSearch:
      searchStep();
      break;
    case Stage::kStartFit:
      startFit();
      break;
    case Stage::kFit:
      fitStep();
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

/// Those answers under slack of which shaping is likely to make the most.
std::vector<FitStart> BestRun::mostPromising(std::size_t count) const {
  const WallpaperGroup group = match_.joining();
  const Shapes rest = restShapes(pattern_);
  const std::vector<double> lengths = seamLengths(pattern_, rest);
  const std::vector<double> placed = localMismatches(group, pattern_, rest, search_result_);
  std::vector<std::pair<double, std::size_t>> by_fit;
  const std::vector<Alignments>& answers = searching_.underSlack();
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Alignments at = match_.expanded(answers[k]);
    by_fit.emplace_back(
        fitUnderRules(predictedMismatches(group, pattern_, at, reach_), lengths, placed), k);
  }
  std::sort(by_fit.begin(), by_fit.end());
  std::vector<FitStart> starts;
  for (const auto& [fit, k] : by_fit)
    if (starts.size() < count) starts.push_back({answers[k]});
  return starts;
}

/// Fits from the best few answers under slack and, where it differs, from the search's own.
void BestRun::startFit() {
  std::vector<FitStart> from = mostPromising(kStarts);
  for (const Alignments& at : offered_starts_) from.push_back({match_.ofLeaders(at)});
  from.push_back({searching_.best(), true});
  const FittingRules rules{problem_.options.continuous_only,
                           problem_.options.average_seam_shapes.value_or(false),
                           problem_.options.locked};
  fit_ = std::make_unique<FittingStage>(pattern_, match_, rules_, rules, *plans_, std::move(from),
                                        reach_);
  alignment_ = fit_->alignment();
  stage_ = Stage::kFit;
  if (fit_->isPerfect()) {
    stage_ = Stage::kSettle;
    progress_ = std::max(progress_, kPerfectlySetUp);
  }
  if (problem_.options.max_change_cm < kLeastChange) finish();
}

void BestRun::fitStep() {
  if (!fit_->advance()) {
    stage_ = Stage::kSettle;
    settled_ = 0;
    for (PartDeformation& deformation : fit_->fitting().deformations()) deformation.settling = 0;
  }
  if (fit_->isStuck()) {
    if (!std::exchange(sought_again_, true)) {
      searching_.seekAgain(fit_->urgency());
      stage_ = Stage::kSeekAgain;
    } else {
      fit_->goOn({});
    }
  }
  alignment_ = fit_->alignment();
  progress_ = std::max(progress_, searched_ + (kFitted - searched_) * fit_->fraction());
}

/// Another answer under slack to fit from, with more weight on what those before it left worse off.
void BestRun::seekAgain() {
  if (searching_.advance()) return;
  fit_->goOn(mostPromising(1)[0].leaders);
  stage_ = Stage::kFit;
}

/// Whether the part keeps every limit of a finished shape, its sewn edges their length to `length`
/// cm.
bool BestRun::keepsLimits(const PartDeformation& deformation, double length) const {
  const PartDeformation::Violations v = deformation.violations();
  return v.length < length && v.reach < kReachExcess * problem_.options.max_change_cm &&
         v.kink < kSettledLimits.kink && v.stretch < kSettledLimits.stretch &&
         !fit_->fitting().crosses(deformation.part().piece);
}

/// Parts that keep their limits rest; the others go on, stiffer where they bend too much, at last
/// holding their shape. A part that will not settle starts again from rest and may move less where
/// it went wrong; the last time without targets.
void BestRun::settleStep() {
  bool all_kept = true;
  for (PartDeformation& deformation : fit_->fitting().deformations()) {
    if (keepsLimits(deformation, length_error_)) continue;
    all_kept = false;
    const int remedies = deformation.settling / kSettleSteps,
              step = deformation.settling % kSettleSteps;
    // lengths that are almost kept only need more steps
    if (step == 0 && remedies > 0 &&
        !(keepsLimits(deformation, kAlmostKept) && remedies < kMostRemedies)) {
      if (remedies > kMostRemedies)
        deformation.clearTargets();
      else
        fit_->fitting().aimAtPartners(deformation, alignment_);
      deformation.restart(kRemedyReach);
    }
    const double share = step < kHoldAfter ? kStiffenFrom : kStiffenHeld;
    deformation.stiffenKinks(share * kSettledLimits.kink);
    deformation.stiffenStretched(share * kSettledLimits.stretch);
    if (step == kHoldAfter) deformation.holdShape();
    deformation.step();
    ++deformation.settling;
  }
  fit_->fitting().collectShapes();
  ++settled_;
  progress_ = std::max(progress_, 1 - (1 - kFitted) / (1 + settled_));
  if (!all_kept) ++settling_;
  if (!all_kept && settled_ <= kMostSettling) return;
  restUnsound();
  if (fit_->review()) {
    restIfBetter();
    return finish();
  }
  stage_ = Stage::kFit;
}

/// What breaks a limit after all stays as it was drafted, which breaks none.
void BestRun::restUnsound() {
  ShapeLimits limits;
  limits.moved = problem_.options.max_change_cm;
  std::vector<char> unsound(fit_->fitting().deformations().size());
  for (bool again = true; again;) {
    again = false;
    std::fill(unsound.begin(), unsound.end(), 0);
    const Shapes& now = fit_->fitting().shapes();
    for (std::size_t p = 0; p < now.size(); ++p)
      if (brokenLimit(pattern_.pieces[p], now[p], limits) != BrokenLimit::kNone)
        unsound[fit_->fitting().partIndexOf(static_cast<int>(p))] = 1;
    for (const Seam& seam : pattern_.seams)
      if (seamError(seam, now) > kSeamTolerance)
        unsound[fit_->fitting().partIndexOf(seam.a.piece)] =
            unsound[fit_->fitting().partIndexOf(seam.b.piece)] = 1;
    for (std::size_t c = 0; c < unsound.size(); ++c) {
      PartDeformation& deformation = fit_->fitting().deformations()[c];
      if (!unsound[c] || deformation.state().shape == deformation.part().rest) continue;
      deformation.setState(deformation.restState());
      again = true;
    }
    fit_->fitting().collectShapes();
  }
}

/// Where nothing could be gained, gathers above all, outlines stay as they were drafted. So do they
/// where some seams weigh so little that the print misses by more than as a cutter lays it.
void BestRun::restIfBetter() {
  const WallpaperGroup group = match_.joining();
  const Shapes rest = evenedShapes(pattern_);
  if (!isSewable(pattern_, rest)) return;
  if (fitAny(group, pattern_, rest, search_result_) <
      fitAny(group, pattern_, fit_->fitting().shapes(), alignment_))
    restAt(search_result_);
  const Alignments drafted = draftedLayout(problem_, match_);
  const std::vector<double> lengths = seamLengths(pattern_, fit_->fitting().shapes());
  if (meanMismatch(localMismatches(group, pattern_, rest, drafted), lengths) <
      meanMismatch(localMismatches(group, pattern_, fit_->fitting().shapes(), alignment_),
                   lengths)) {
    const double cost = costAtRest(drafted);
    if (cost > SearchStage::kPerfect) of_bound_ = costAtRest(search_result_) / cost;
    restAt(search_result_ = drafted);
  }
}

void BestRun::restAt(const Alignments& at) {
  fit_->fitting().setStates(fit_->fitting().restStates());
  alignment_ = at;
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

const Shapes& BestRun::shapes() const { return fit_->fitting().shapes(); }

}  // namespace seamwise
