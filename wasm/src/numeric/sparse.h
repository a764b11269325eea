#pragma once
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

using VectorX = Eigen::VectorXd;

/// Elimination order of a graph's nodes with little fill-in (AMD).
/// @param pairs   neighbours; in either order, duplicates allowed, negative numbers skipped
/// @return   per node its position in the order
std::vector<int> eliminationOrder(int size, const std::vector<std::pair<int, int>>& pairs);

/// A symmetric matrix with a fixed pattern, filled again at each step of a Newton iteration, and
/// its LDLT factorisation, analysed once. The matrix is stored in elimination order, so that no
/// step permutes it. A copy has the same pattern and values and needs its own analysis.
class SparseHessian {
 public:
  enum class Order : std::uint8_t { kSought, kGiven };

  SparseHessian() = default;
  /// @param pairs   entries that may be non-zero; either triangle, diagonal added, duplicates
  ///                allowed
  /// @param order   kGiven: the numbers of the unknowns are the elimination order
  SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs,
                Order order = Order::kSought);
  SparseHessian(const SparseHessian& other);
  SparseHessian& operator=(SparseHessian other) noexcept;

  int size() const { return static_cast<int>(matrix_.rows()); }
  void setZero() { std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0); }
  /// Index in values() of the entries (i, j) and (j, i); -1 for negative indices (fixed unknowns).
  int slot(int i, int j) const;
  /// Adds v at (i, j) and, in effect, at (j, i): pass only one of an off-diagonal pair. Negative
  /// indices are skipped.
  void add(int i, int j, double v) {
    if (const int k = slot(i, j); k >= 0) matrix_.valuePtr()[k] += v;
  }
  double* values() { return matrix_.valuePtr(); }
  const double* values() const { return matrix_.valuePtr(); }
  Eigen::Index nonZeros() const { return matrix_.nonZeros(); }

  /// The product of a symmetric matrix of this pattern, given by its values, with x.
  VectorX times(const std::vector<double>& values, const VectorX& x) const;

  /// Analyses the pattern; otherwise the first factorise() does so.
  void analyse();
  /// Returns false if the matrix is not positive definite.
  bool factorise();
  VectorX solve(const VectorX& b) const;
  /// Solves for three right-hand sides at once. The solutions replace the columns of b.
  void solveThree(std::vector<Vec3>& b) const;
  /// Number of entries below the factor's diagonal; requires a factorisation.
  Eigen::Index factorNonZeros() const;

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor>;
  /// Skips Eigen's permutation where its version allows it: the matrix is in elimination order
  /// already. This saves 1 kB of a module.
  struct Factor : Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> {
#if EIGEN_VERSION_AT_LEAST(3, 4, 90)
    void analyse(const Matrix& matrix) { analyzePattern(matrix); }
    void factorise(const Matrix& matrix) { factorize(matrix); }
#else
    void analyse(const Matrix& matrix) { analyzePattern_preordered(matrix, true); }
    void factorise(const Matrix& matrix) { factorize_preordered<true>(matrix); }
#endif
  };
  int positionOf(int i) const { return position_.empty() ? i : position_[i]; }
  VectorX permuted(const VectorX& x) const;    ///< maps to elimination order
  VectorX unpermuted(const VectorX& x) const;  ///< maps back

  Matrix matrix_;              ///< upper triangle, in elimination order
  std::vector<int> position_;  ///< per unknown its position in the order; empty: its number
  std::unique_ptr<Factor> ldlt_;
};

}  // namespace seamwise
