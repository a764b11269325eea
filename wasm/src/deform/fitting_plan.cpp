#include "deform/fitting_plan.h"

#include "tuning/shaping.h"

namespace seamwise {
FittingPlan::FittingPlan(const Pattern& pattern, const DeformationWeights& weights,
                         double max_change)
    : parts(splitIntoParts(pattern, max_change)) {
  for (const Part& part : parts.parts) deformations.emplace_back(part, weights);
  for (const Follower& f : parts.pieces) {
    to_part_direct.push_back(f.direct.inverse());
    to_part_mirror.push_back(f.mirror.inverse());
  }
  for (const Seam& seam : pattern.seams) {
    const auto& rest = pattern.pieces[seam.a.piece].rest;
    std::vector<double> lengths(seam.a.vertices.size(), 0);
    for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
      const double l = (rest[seam.a.vertices[i + 1]] - rest[seam.a.vertices[i]]).norm();
      lengths[i] += l / 2, lengths[i + 1] += l / 2;
    }
    vertex_length.push_back(std::move(lengths));
  }
}

const FittingPlan& FittingPlans::fine(const Pattern& pattern) {
  if (!fine_) fine_ = std::make_unique<const FittingPlan>(pattern, weights_, max_change_);
  return *fine_;
}

const CoarserPlan* FittingPlans::coarse(const Pattern& pattern) {
  if (!coarse_) {
    coarse_.emplace();
    if (auto coarser = coarsened(pattern, ShapingTuning::kCoarseEdge)) {
      FittingPlan plan(coarser->pattern, weights_, max_change_);
      *coarse_ =
          std::make_unique<const CoarserPlan>(CoarserPlan{std::move(*coarser), std::move(plan)});
    }
  }
  return coarse_->get();
}

}  // namespace seamwise
