#include "solve/paper_run.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"
#include "solve/metrics.h"
#include "solve/promise.h"

namespace seamwise {
namespace {

constexpr double kMostAlpha = 65536;
constexpr double kLost = 3;              ///< times the greatest change
constexpr double kLeastDraw = 1.0 / 32;  ///< share of the way to their targets that seams still go

bool crossesItself(const Pattern& pattern, const Shapes& shapes) {
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    std::vector<Polyline> loops;
    for (const std::vector<int>& loop : loopsOf(pattern.pieces[p])) {
      loops.emplace_back();
      for (const int v : loop) loops.back().push_back(shapes[p][v]);
    }
    if (findCrossing(loops)) return true;
  }
  return false;
}

}  // namespace

PaperRun::PaperRun(const Problem& problem, const Pattern& pattern, const MatchRules& rules,
                   std::vector<Note>* notes)
    : problem_(problem),
      pattern_(pattern),
      match_(makeMatchProblem(pattern, restShapes(pattern), pattern.mirrors, rules,
                              problem.print.group)),
      sweeps_(match_, problem.options.seed),
      deformation_(pattern, problem.options.method == Method::kPaper),
      alignment_(match_.expanded(sweeps_.at())),
      shapes_(restShapes(pattern)),
      alpha_(problem.options.alpha.value_or(1)),
      notes_(notes) {}

bool PaperRun::advance() {
  if (phase_ == Phase::kAlignment) {
    const bool more = sweeps_.step();
    alignment_ = match_.expanded(sweeps_.at());
    progress_ = 0.1 * sweeps_.fraction();
    if (!more) startDeformation();
    return phase_ != Phase::kDone;
  }
  if (phase_ == Phase::kDone) return false;
  const int before = deformation_.gammas();
  bool more = deformation_.step();
  // A growing gamma hardly takes movement back: an attempt far beyond the bound has failed.
  if (more && deformation_.gammas() > before && !problem_.options.alpha &&
      greatestMovement(pattern_, deformation_.shapes()) > kLost * problem_.options.max_change_cm)
    more = false;
  // gamma ends at about 2^20; later attempts tell nothing new
  const double within = std::min(1.0, std::log2(deformation_.gamma()) / 22);
  progress_ = std::max(progress_, 0.1 + 0.85 * within);
  if (!more && endAttempt()) phase_ = Phase::kDone;
  return phase_ != Phase::kDone;
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
        targets_.push_back({deformation_.first(side->piece) + side->vertices[i], (*line)[i],
                            seam.weight * length});
      }
    }
  }
  deformation_.start(targets_, alpha_);
}

bool PaperRun::endAttempt() {
  shapes_ = deformation_.shapes();
  if (problem_.options.alpha || isKept()) return true;
  ++attempt_;
  if (alpha_ < kMostAlpha) {
    alpha_ *= 2;
    deformation_.start(targets_, alpha_);
    return false;
  }
  if (draw_ == 1)
    notes_->push_back(
        {"partOfTheWay",
         "No weight of the conformal term keeps the outlines simple and within the "
         "greatest change, so the seams go only part of the way to their ideal lines."});
  draw_ /= 2;
  if (draw_ < kLeastDraw) {
    shapes_ = evenedShapes(pattern_);
    return true;
  }
  deformation_.start(targets_, alpha_, draw_);
  return false;
}

/// Whether the shapes can be cut and sewn, and none moved further than allowed.
bool PaperRun::isKept() const {
  if (greatestMovement(pattern_, shapes_) > problem_.options.max_change_cm) return false;
  for (const Seam& seam : pattern_.seams)
    if (seamError(seam, shapes_) > kSeamTolerance) return false;
  return !crossesItself(pattern_, shapes_);
}

Phase PaperRun::phase() const { return phase_; }
double PaperRun::fraction() const { return phase_ == Phase::kDone ? 1 : progress_; }

}  // namespace seamwise
