#pragma once
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

using VectorX = Eigen::VectorXd;

/// A symmetric matrix with a fixed pattern, filled again at each step of a Newton iteration, and its
/// LDLT factorisation (AMD order), analysed once.
class SparseHessian {
 public:
  SparseHessian() = default;
  /// @param pairs   entries that may be non-zero; either triangle, diagonal added, duplicates welcome
  SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs);

  int size() const { return static_cast<int>(matrix_.rows()); }
  void setZero() { std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0); }
  /// Adds v at (i, j) and, in effect, at (j, i): of an off-diagonal pair pass one of the two.
  /// Negative indices (fixed unknowns) are skipped.
  void add(int i, int j, double v);
  double* values() { return matrix_.valuePtr(); }
  const double* values() const { return matrix_.valuePtr(); }
  Eigen::Index nonZeros() const { return matrix_.nonZeros(); }

  /// The product of a symmetric matrix of this pattern, given by its lower values, with x.
  VectorX times(const std::vector<double>& values, const VectorX& x) const;

  /// False when the matrix is not positive definite.
  bool factorise();
  VectorX solve(const VectorX& b) const { return ldlt_->solve(b); }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor>;
  using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>>;
  Matrix matrix_;  ///< lower triangle
  std::shared_ptr<Factor> ldlt_;
};

}  // namespace seamwise
