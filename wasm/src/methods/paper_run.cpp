#include "methods/paper_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "deform/shape_limits.h"
#include "methods/metrics.h"
#include "tuning/paper.h"

namespace seamwise {
namespace {

bool anyCrossesItself(const Pattern& pattern, const Shapes& shapes) {
  for (std::size_t p = 0; p < shapes.size(); ++p)
    if (crossesItself(pattern.pieces[p], shapes[p])) return true;
  return false;
}

/// The target, or the point `most` cm from rest in its direction if that is nearer.
Vec2 clipped(const Vec2& target, const Vec2& rest, double most) {
  const double way = (target - rest).norm();
  return way > most ? Vec2(rest + most / way * (target - rest)) : target;
}

}  // namespace

PaperRun::PaperRun(const Problem& problem, const Pattern& pattern, const MatchRules& rules,
                   const Alignments& drafted, std::vector<Note>* notes)
    : problem_(problem),
      pattern_(pattern),
      match_(makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules,
                              problem.print.group)),
      drafted_(match_.ofLeaders(drafted)),
      deformation_(pattern, problem.options.method == Method::kPaper),
      shapes_(restShapes(pattern)),
      alpha_(problem.options.alpha.value_or(1)),
      notes_(notes) {
  sweeps_.emplace(match_, problem.options.seed);
  alignment_ = match_.expanded(sweeps_->at());
}

bool PaperRun::advance() {
  if (phase_ == Phase::kAlignment) {
    sweep();
    if (!sweeps_) startDeformation();
    return phase_ != Phase::kDone;
  }
  if (phase_ == Phase::kDone) return false;
  const int before = deformation_.gammas();
  bool more = deformation_.step();
  // A growing gamma hardly reduces movement, so an attempt far beyond the bound has failed.
  if (more && deformation_.gammas() > before && !problem_.options.alpha &&
      greatestMovement(pattern_, deformation_.shapes()) >
          PaperTuning::kLost * problem_.options.max_change_cm)
    more = false;
  // gamma ends at about 2^20. Later attempts start at 1 again and add no progress.
  const double within = std::min(1.0, std::ilogb(deformation_.gamma()) / 22.0);
  progress_ = std::max(progress_, 0.1 + 0.85 * within);
  if (!more && endAttempt()) {
    restIfBetter();
    phase_ = Phase::kDone;
  }
  return phase_ != Phase::kDone;
}

/// Takes one sweep, and begins the next start when this one has converged.
void PaperRun::sweep() {
  const int starts = problem_.options.starts;
  const int all = starts > 1 ? starts + 1 : 1;  // including the drafted layout, which comes last
  const bool more = sweeps_->step();
  progress_ = 0.1 * (start_ + sweeps_->fraction()) / all;
  if (start_ == 0) alignment_ = match_.expanded(sweeps_->at());  // nothing better exists yet
  if (more) return;
  const double cost = match_.cost(sweeps_->at());
  if (cost < cost_) {
    alignment_ = match_.expanded(sweeps_->at());
    cost_ = cost;
  }
  ++start_;
  if (start_ == all)
    sweeps_.reset();
  else if (start_ == starts)
    sweeps_.emplace(match_, drafted_);
  else
    sweeps_.emplace(match_, problem_.options.seed + static_cast<std::uint64_t>(start_));
}

void PaperRun::startDeformation() {
  if (problem_.options.max_change_cm < kLeastChange) {
    shapes_ = evenedShapes(pattern_);
    phase_ = Phase::kDone;
    return;
  }
  phase_ = Phase::kDeformation;
  const bool average =
      problem_.options.average_seam_shapes.value_or(problem_.options.method == Method::kPaper);
  const IdealShape shape = average ? IdealShape::kAveraged : IdealShape::kTransported;
  const double most = problem_.options.clip_targets
                          ? PaperTuning::kClip * problem_.options.max_change_cm
                          : std::numeric_limits<double>::infinity();
  const Shapes rest = restShapes(pattern_);
  for (const Seam& seam : pattern_.seams) {
    if (!seam.matched) continue;
    const Join join =
        bestJoin(problem_.print.group, seam, rest, alignment_, problem_.options.continuous_only);
    const IdealLines ideal = idealLines(seam, join, rest, alignment_, shape);
    for (const auto& [side, line] : {std::pair{&seam.a, &ideal.a}, std::pair{&seam.b, &ideal.b}}) {
      const auto& p = rest[side->piece];
      const std::size_t n = line->size();
      for (std::size_t i = 0; i < n; ++i) {
        double length = 0;
        if (i > 0) length += (p[side->vertices[i]] - p[side->vertices[i - 1]]).norm() / 2;
        if (i + 1 < n) length += (p[side->vertices[i + 1]] - p[side->vertices[i]]).norm() / 2;
        targets_.push_back({deformation_.first(side->piece) + side->vertices[i],
                            clipped((*line)[i], p[side->vertices[i]], most), seam.weight * length});
      }
    }
  }
  deformation_.start(targets_, alpha_);
}

bool PaperRun::endAttempt() {
  shapes_ = deformation_.shapes();
  if (problem_.options.alpha || isKept()) {
    if (!probing_) return true;
    probing_ = false;
    startAttempt();
    return false;
  }
  if (alpha_ < PaperTuning::kMostAlpha) {
    alpha_ *= 2;
    // an attempt from rest that fails at the alpha of a probe is followed by others from rest
    if (probing_ || attempt_ == 0) {
      probing_ = true;
      deformation_.stiffen(alpha_);
    } else {
      startAttempt();
    }
    return false;
  }
  probing_ = false;
  if (draw_ == 1)
    notes_->push_back(
        {"partOfTheWay",
         "No weight of the conformal term keeps the outlines simple and within the "
         "greatest change, so the seams go only part of the way to their ideal lines."});
  draw_ /= 2;
  if (draw_ < PaperTuning::kLeastDraw) {
    shapes_ = evenedShapes(pattern_);
    return true;
  }
  startAttempt();
  return false;
}

void PaperRun::startAttempt() {
  ++attempt_;
  deformation_.start(targets_, alpha_, draw_);
}

/// Returns whether the shapes can be cut and sewn, and none has moved further than allowed.
bool PaperRun::isKept() const {
  if (greatestMovement(pattern_, shapes_) > problem_.options.max_change_cm) return false;
  return isSewable(pattern_, shapes_) && !anyCrossesItself(pattern_, shapes_);
}

void PaperRun::restIfBetter() {
  const WallpaperGroup group = match_.joining();
  const Shapes rest = evenedShapes(pattern_);
  if (isSewable(pattern_, rest) && totalMismatch(group, pattern_, rest, alignment_) <
                                       totalMismatch(group, pattern_, shapes_, alignment_))
    shapes_ = rest;
}

Phase PaperRun::phase() const { return phase_; }
double PaperRun::fraction() const { return phase_ == Phase::kDone ? 1 : progress_; }

}  // namespace seamwise
