#pragma once
#include <forward_list>
#include <utility>
#include <vector>

#include "photo/symmetry/cell_spectrum.h"
#include "photo/symmetry/group_embedding.h"

namespace seamwise {

/// Difference of a cell from its image under one symmetry, or the greatest over several symmetries:
/// shares of the pattern's energy, without noise and small displacements.
struct SymmetryResidual {
  double rho = 0;    ///< whole cell
  double worst = 0;  ///< worst place
  double raw = 0;    ///< whole cell, with noise and displacements
};

/// Compares a cell with its images under symmetries of its lattice.
class SymmetryTests {
 public:
  explicit SymmetryTests(const CellSpectrum& cell);

  /// Returns the origin in [0, 1) at which the images of all elements together agree best with the
  /// cell; the first one of equal origins.
  Vec2 bestOrigin(const GroupEmbedding& embedding);
  /// Returns the mean share of energy by which elements miss about an origin on the grid of 2 n x 2
  /// n. `bestOrigin` minimises it. It includes noise and displacements.
  double missedBy(const GroupEmbedding& embedding, const Vec2& origin);
  /// Returns the greatest residual over all elements about an origin.
  SymmetryResidual residual(const GroupEmbedding& embedding, const Vec2& origin) const;
  /// Returns the residual of one symmetry u -> m u + a.
  SymmetryResidual residual(const IntegerMatrix& m, const Vec2& a) const;

 private:
  const std::vector<float>& correlation(const IntegerMatrix& m);
  double patternEnergy() const;

  const CellSpectrum& cell_;
  CellSpectrum::Planes along1_, along2_;  ///< change of the cell per sample, along w1 and w2
  std::forward_list<std::pair<IntegerMatrix, std::vector<float>>> correlations_;
};

/// Returns the shift of an element about the origin of its group: (I - M) origin + a.
Vec2 shiftAbout(const LatticeElement& element, const Vec2& origin);

}  // namespace seamwise
