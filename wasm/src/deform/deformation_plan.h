#pragma once
#include <array>
#include <memory>
#include <vector>

#include "deform/part.h"
#include "numeric/sparse.h"
#include "tuning/shaping.h"

namespace seamwise {

/// Weights of the terms that preserve a part's shape. Lengths in cm, energies per cm of outline.
struct DeformationWeights {
  /// LSCM energy of the map from rest to shape, per cm2 of fabric.
  double conformal = ShapingTuning::kConformal;
  /// Change of the outline's direction, per rad2 at a vertex; the same at a corner.
  double bend = ShapingTuning::kBend, corner = ShapingTuning::kCornerBend;
  /// Pull of the outline to its rest position, per cm2.
  double rest = ShapingTuning::kRestPull;
  /// Change of an unsewn edge's length, and distance of its vertices from its line, per cm2.
  double unsewn = ShapingTuning::kUnsewn, line = ShapingTuning::kLine;
  bool operator==(const DeformationWeights&) const = default;
};

/// The quadratic terms of a part's energy, which no deformation changes, and the layout of its
/// Hessian. Unknowns are the vertices' moves, numbered in the order of elimination.
struct DeformationTerms {
  DeformationTerms(const Part& part, const DeformationWeights& weights);

  /// Adds w |(u_j - u_i) / after - (u_i - u_h) / before|^2, which preserves the outline's turns.
  void addBend(SparseHessian& to, const Part::Bend& bend, double weight) const;

  std::vector<int> unknown;  ///< 2 per vertex; -1 if the axis holds the coordinate
  int unknowns = 0;
  SparseHessian quadratic;  ///< conformal, bends, lines of unsewn edges, the pull to rest
  /// Hessian entries per edge of the outline: the lower triangles of the blocks (i, i) and (j, j),
  /// then the block (i, j).
  std::vector<std::array<int, 10>> edge_slots;

 private:
  void number(const Part& part);
  void addConformal(const Part& part, double weight);
  void addLines(const Part& part, double weight);
};

/// The common data of all deformations of a part. Parts at rest never need the terms, so these are
/// computed on first use.
class DeformationPlan {
 public:
  /// @param part   outlives the plan
  DeformationPlan(const Part& part, const DeformationWeights& weights);

  const Part& part() const { return *part_; }
  const DeformationWeights& weights() const { return weights_; }
  double restArea(std::size_t triangle) const { return rest_area_[triangle]; }  ///< cm2
  const DeformationTerms& terms() const {
    if (!terms_) terms_ = std::make_unique<const DeformationTerms>(*part_, weights_);
    return *terms_;
  }

 private:
  const Part* part_;
  DeformationWeights weights_;
  std::vector<double> rest_area_;
  mutable std::unique_ptr<const DeformationTerms> terms_;
};

}  // namespace seamwise
