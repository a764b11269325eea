#pragma once
#include <memory>
#include <optional>

#include "deform/deformation_plan.h"
#include "mesh/coarser.h"

namespace seamwise {

/// The data for deforming a pattern that depend on neither its seams' weights nor the print.
struct FittingPlan {
  /// @param max_change   greatest movement of an outline vertex, cm
  FittingPlan(const Pattern& pattern, const DeformationWeights& weights, double max_change);

  Parts parts;
  std::vector<DeformationPlan> deformations;             ///< per part
  std::vector<PointMap> to_part_direct, to_part_mirror;  ///< per piece
  std::vector<std::vector<double>>
      vertex_length;  ///< length of seam that each vertex represents, per seam, cm
};

/// The coarser pattern with its plan.
struct CoarserPlan {
  CoarserPattern coarser;
  FittingPlan plan;
};

/// Plans for one mesh, each computed on first use.
class FittingPlans {
 public:
  FittingPlans(const DeformationWeights& weights, double max_change)
      : weights_(weights), max_change_(max_change) {}

  bool areFor(const DeformationWeights& weights, double max_change) const {
    return weights_ == weights && max_change_ == max_change;
  }
  /// @param pattern   the mesh; its seams' weights may differ between calls
  const FittingPlan& fine(const Pattern& pattern);
  /// Returns null if coarsening would remove few vertices.
  const CoarserPlan* coarse(const Pattern& pattern);

 private:
  DeformationWeights weights_;
  double max_change_;
  std::unique_ptr<const FittingPlan> fine_;
  std::optional<std::unique_ptr<const CoarserPlan>> coarse_;
};

}  // namespace seamwise
