#pragma once
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

using VectorX = Eigen::VectorXd;

/// A symmetric matrix with a fixed pattern, filled again at each step of a Newton iteration, and
/// its LDLT factorisation (AMD order), analysed once. Kept in the order of elimination, so that no
/// step permutes it.
class SparseHessian {
 public:
  SparseHessian() = default;
  /// @param pairs   entries that may be non-zero; either triangle, diagonal added, duplicates
  /// welcome
  SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs);

  int size() const { return static_cast<int>(matrix_.rows()); }
  void setZero() { std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0); }
  /// Where in values() the entries (i, j) and (j, i) are; -1 for negative indices (fixed unknowns).
  int slot(int i, int j) const;
  /// Adds v at (i, j) and, in effect, at (j, i): of an off-diagonal pair pass one of the two.
  /// Negative indices are skipped.
  void add(int i, int j, double v) {
    if (const int k = slot(i, j); k >= 0) matrix_.valuePtr()[k] += v;
  }
  double* values() { return matrix_.valuePtr(); }
  const double* values() const { return matrix_.valuePtr(); }
  Eigen::Index nonZeros() const { return matrix_.nonZeros(); }

  /// The product of a symmetric matrix of this pattern, given by its values, with x.
  VectorX times(const std::vector<double>& values, const VectorX& x) const;

  /// False when the matrix is not positive definite.
  bool factorise();
  VectorX solve(const VectorX& b) const;

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor>;
  using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>>;
  Matrix matrix_;  ///< upper triangle, in the order of elimination
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> position_;
  std::unique_ptr<Factor> ldlt_;
};

}  // namespace seamwise
