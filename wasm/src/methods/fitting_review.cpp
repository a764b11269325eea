#include <algorithm>
#include <utility>

#include "methods/fitting_stage.h"
#include "methods/metrics.h"
#include "methods/seam_rules.h"
#include "tuning/shaping.h"

namespace seamwise {
/// Removes the pull of the seams that share an end with this one. Returns whether there were any.
bool FittingStage::dropNeighbours(std::size_t seam) {
  const Seam& own = fitted().seams[seam];
  std::vector<char>& shaped = starts_[current_].shaped;
  bool any = false;
  for (std::size_t t = 0; t < shaped.size(); ++t) {
    if (!shaped[t]) continue;
    const Seam& other = fitted().seams[t];
    for (const SeamSide* x : {&own.a, &own.b})
      for (const SeamSide* y : {&other.a, &other.b})
        for (const int v : {x->vertices.front(), x->vertices.back()})
          if (x->piece == y->piece && (v == y->vertices.front() || v == y->vertices.back()))
            shaped[t] = 0, any = true;
  }
  return any;
}

/// Increases the weight of seams that nearly match in the last steps, and reduces that of lost
/// ones, so that more of them match.
void FittingStage::favourNearMatches() {
  std::vector<double> favours(fitted().seams.size(), 1);
  for (std::size_t s = 0; s < favours.size(); ++s) {
    if (!canMatch(fitted().seams[s])) continue;
    const double off =
        offShare(match_.joining(), fitted().seams[s], fitting_->shapes(), alignment_);
    if (off > ShapingTuning::kLostShare)
      favours[s] = 1 / ShapingTuning::kFavour;
    else if (off > 0 && off < ShapingTuning::kNearShare)
      favours[s] = ShapingTuning::kFavour;
  }
  starts_[current_].favours = std::move(favours);
  pull();
}

/// Removes the pull of seams that are bent in vain, and increases that of seams that are worse off
/// than by placing alone.
FittingStage::Judgement FittingStage::judge() {
  const Pattern& pattern = fitted();
  const Shapes rest = restShapes(pattern);
  const WallpaperGroup joining = match_.joining();
  const auto shaped = localMismatches(joining, pattern, fitting_->shapes(), alignment_);
  const auto aligned = localMismatches(joining, pattern, rest, alignment_);
  const auto placed = placedMismatches();
  Start& start = starts_[current_];
  Judgement found = Judgement::kGood;
  const auto others = [&] {
    if (found == Judgement::kGood) found = Judgement::kOtherPulls;
  };
  worse_.assign(shaped.size(), 0);
  excess_ = 0;
  for (std::size_t s = 0; s < shaped.size(); ++s) {
    if (!counts(pattern.seams[s])) continue;
    const Seam& seam = pattern.seams[s];
    const double moved = seam.visibility > 0 ? seamBend(seam, pattern, fitting_->shapes())
                                             : seamMovement(seam, pattern, fitting_->shapes());
    const Verdict verdict = verdictOn({placed[s], aligned[s], shaped[s]}, moved, seam.visibility);
    if (verdict == Verdict::kKept) continue;
    worse_[s] = verdict == Verdict::kWorse;
    if (worse_[s]) {
      const double most = greatestMean(placed[s], seam.visibility);
      start.margins[s] += shaped[s] - most;
      excess_ = std::max(excess_, shaped[s] / most - 1);
    }
    if (worse_[s] && !start.stays) {
      if (start.pull_factors[s] >= ShapingTuning::kMostPull)
        found = Judgement::kFailed;
      else
        start.pull_factors[s] *= ShapingTuning::kPullGrowth, others();
    } else if (start.shaped[s] || dropNeighbours(s)) {
      start.shaped[s] = 0, others();
    } else {
      found = Judgement::kFailed;
    }
  }
  return found;
}

bool FittingStage::review() {
  if (perfect_ || given_up_) return true;
  const Judgement found = judge();
  if (found == Judgement::kGood) return true;
  Start& start = starts_[current_];
  const int most = start.stays ? ShapingTuning::kReviewsOfLast : ShapingTuning::kReviewsOfOne;
  const bool another = found == Judgement::kOtherPulls && start.reviews++ < most;
  if (++reviews_ == ShapingTuning::kMostReviews || (start.stays && !another)) {
    giveUp();
    return false;
  }
  goCoarse();
  if (another) {
    again();
  } else {
    fail();
    stalled_ = !goOnFromBest();
  }
  return false;
}

/// Restores all drafted lines, at the alignments of placing alone.
void FittingStage::giveUp() {
  given_up_ = true;
  fitting_->setStates(fitting_->restStates());
  current_ = starts_.size();
  while (!starts_[--current_].stays) continue;
  std::fill(starts_[current_].shaped.begin(), starts_[current_].shaped.end(), 0);
  place(starts_[current_].leaders);
  pull();
  for (PartDeformation& deformation : fitting_->deformations()) deformation.clearTargets();
}

void FittingStage::fail() {
  starts_[current_].failed = true;
  starts_[current_].excess = excess_;
  for (std::size_t s = 0; s < worse_.size(); ++s)
    if (worse_[s])
      search_factors_[s] =
          std::min(search_factors_[s] * ShapingTuning::kWeightGrowth, ShapingTuning::kMostPull);
}

}  // namespace seamwise
