#pragma once
#include <forward_list>
#include <utility>
#include <vector>

#include "recognition/symmetry/cell_spectrum.h"
#include "recognition/symmetry/group_embedding.h"

namespace seamwise {

/// How far a cell is from its image under one symmetry, or the furthest of several: shares of the
/// pattern's energy, noise and small displacements taken away.
struct SymmetryResidual {
  double rho = 0;    ///< of the whole cell
  double worst = 0;  ///< of the worst of the places
  double raw = 0;    ///< of the whole cell, nothing taken away
};

/// Compares a cell with its images under symmetries of its lattice.
class SymmetryTests {
 public:
  explicit SymmetryTests(const CellSpectrum& cell);

  /// The origin at which the images agree best with the cell, all elements together, in [0, 1);
  /// of equal ones the first.
  Vec2 bestOrigin(const GroupEmbedding& embedding);
  /// Mean share of energy by which elements about an origin on the grid of 2 n x 2 n miss; what
  /// `bestOrigin` makes least. Nothing is taken away from it.
  double missedBy(const GroupEmbedding& embedding, const Vec2& origin);
  /// The furthest of all elements about an origin.
  SymmetryResidual residual(const GroupEmbedding& embedding, const Vec2& origin) const;
  /// Of one symmetry u -> m u + a.
  SymmetryResidual residual(const IntegerMatrix& m, const Vec2& a) const;

 private:
  const std::vector<float>& correlation(const IntegerMatrix& m);
  double patternEnergy() const;

  const CellSpectrum& cell_;
  CellSpectrum::Planes along1_, along2_;  ///< change of the cell per sample, along w1 and w2
  std::forward_list<std::pair<IntegerMatrix, std::vector<float>>> correlations_;
};

/// The shift of an element when the origin of its group is moved there: (I - M) origin + a.
Vec2 shiftAbout(const LatticeElement& element, const Vec2& origin);

}  // namespace seamwise
