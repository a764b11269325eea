#pragma once
#include <array>
#include <memory>
#include <vector>

#include "deform/part.h"
#include "numeric/sparse.h"
#include "tuning/shaping.h"

namespace seamwise {

/// Weights of the terms that keep a part a part. Lengths in cm, energies per cm of outline.
struct DeformationWeights {
  /// Of the LSCM energy of the map from rest to shape, per cm2 of cloth.
  double conformal = ShapingTuning::kConformal;
  /// Of the change of the outline's direction, per rad2 at a vertex; the same at a corner.
  double bend = ShapingTuning::kBend, corner = ShapingTuning::kCornerBend;
  /// Of the pull of the outline to its rest position, per cm2.
  double rest = ShapingTuning::kRestPull;
  /// Of the change of an unsewn edge's length, and of its vertices' distance from its line, per
  /// cm2.
  double unsewn = ShapingTuning::kUnsewn, line = ShapingTuning::kLine;
  bool operator==(const DeformationWeights&) const = default;
};

/// The quadratic terms of a part's energy, which no deformation changes, and where everything is in
/// its Hessian. Unknowns are the vertices' moves, numbered in the order of elimination.
struct DeformationTerms {
  DeformationTerms(const Part& part, const DeformationWeights& weights);

  /// Adds w |(u_j - u_i) / after - (u_i - u_h) / before|^2: the outline's direction keeps turning
  /// as at rest.
  void addBend(SparseHessian& to, const Part::Bend& bend, double weight) const;

  std::vector<int> unknown;  ///< 2 per vertex; -1 where the axis holds the coordinate
  int unknowns = 0;
  SparseHessian quadratic;  ///< conformal, bends, lines of unsewn edges, the pull to rest
  /// Per edge of the outline: its entries, of the lower triangles of the blocks (i, i) and (j, j),
  /// then of the block (i, j).
  std::vector<std::array<int, 10>> edge_slots;

 private:
  void number(const Part& part);
  void addConformal(const Part& part, double weight);
  void addLines(const Part& part, double weight);
};

/// What all deformations of a part have in common. Parts that rest never ask for the terms.
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
