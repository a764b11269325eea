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

/// When each node of a graph is to be eliminated, so that little fills in (AMD).
/// @param pairs   neighbours; in either order, duplicates allowed, negative numbers skipped
/// @return   per node its place in the order
std::vector<int> eliminationOrder(int size, const std::vector<std::pair<int, int>>& pairs);

/// A symmetric matrix with a fixed pattern, filled again at each step of a Newton iteration, and
/// its LDLT factorisation, analysed once. Kept in the order of elimination, so that no step
/// permutes it. A copy has the same pattern and values and is analysed by itself.
class SparseHessian {
 public:
  enum class Order : std::uint8_t { kSought, kGiven };

  SparseHessian() = default;
  /// @param pairs   entries that may be non-zero; either triangle, diagonal added, duplicates
  ///                allowed
  /// @param order   kGiven: unknowns are numbered as they are to be eliminated
  SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs,
                Order order = Order::kSought);
  SparseHessian(const SparseHessian& other);
  SparseHessian& operator=(SparseHessian other) noexcept;

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

  /// Prepares for factorising, which otherwise does so the first time.
  void analyse();
  /// False when the matrix is not positive definite.
  bool factorise();
  VectorX solve(const VectorX& b) const;
  /// Solves for three right-hand sides at once, the columns of b, which becomes the solutions.
  void solveThree(std::vector<Vec3>& b) const;
  /// Entries of the factor below its diagonal; once it is analysed and factorised.
  Eigen::Index factorNonZeros() const;

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor>;
  /// Where Eigen lets us, without what would permute a matrix, 1 kB of a module: this one is in
  /// order.
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
  VectorX permuted(const VectorX& x) const;    ///< into the order of elimination
  VectorX unpermuted(const VectorX& x) const;  ///< and back

  Matrix matrix_;              ///< upper triangle, in the order of elimination
  std::vector<int> position_;  ///< of an unknown in the order; empty: its number
  std::unique_ptr<Factor> ldlt_;
};

}  // namespace seamwise
