#include "numeric/sparse.h"

#include <Eigen/OrderingMethods>
#include <algorithm>

#include "base/sort_by.h"

namespace seamwise {
namespace {

int placed(int i, const std::vector<int>& position) { return position.empty() ? i : position[i]; }

/// A symmetric matrix of zeros, or its upper triangle: the diagonal and the entries of `pairs`, in
/// the order of `position`. Eigen's triplets and views would enlarge a module by 2 kB.
Eigen::SparseMatrix<double> zeroMatrix(int size, const std::vector<std::pair<int, int>>& pairs,
                                       const std::vector<int>& position, bool upper_only) {
  std::vector<std::pair<int, int>> entries;  // column, row
  entries.reserve(pairs.size() + size);
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i);
  for (const auto& [i, j] : pairs) {
    if (i < 0 || j < 0) continue;
    const int a = placed(i, position), b = placed(j, position);
    entries.emplace_back(std::max(a, b), std::min(a, b));
    if (!upper_only) entries.emplace_back(std::min(a, b), std::max(a, b));
  }
  sortOnce(entries);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(entries.size()));
  std::fill_n(matrix.valuePtr(), entries.size(), 0.0);
  int* const end = matrix.outerIndexPtr() + 1;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    matrix.innerIndexPtr()[k] = entries[k].second;
    end[entries[k].first] = static_cast<int>(k) + 1;
  }
  return matrix;
}

}  // namespace

std::vector<int> eliminationOrder(int size, const std::vector<std::pair<int, int>>& pairs) {
  Eigen::SparseMatrix<double> graph = zeroMatrix(size, pairs, {}, false);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> eliminated;
  Eigen::internal::minimum_degree_ordering(graph, eliminated);
  std::vector<int> position(size);
  for (int k = 0; k < size; ++k) position[eliminated.indices()[k]] = k;
  return position;
}

SparseHessian::SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs, Order order) {
  if (order == Order::kSought) position_ = eliminationOrder(size, pairs);
  zeroMatrix(size, pairs, position_, true).swap(matrix_);
}

SparseHessian::SparseHessian(const SparseHessian& other)
    : matrix_(other.matrix_), position_(other.position_) {}

SparseHessian& SparseHessian::operator=(SparseHessian other) noexcept {
  matrix_.swap(other.matrix_);
  position_.swap(other.position_);
  ldlt_.swap(other.ldlt_);
  return *this;
}

int SparseHessian::slot(int i, int j) const {
  if (i < 0 || j < 0) return -1;
  const int a = positionOf(i), b = positionOf(j);
  const int row = std::min(a, b), column = std::max(a, b);
  const int* const inner = matrix_.innerIndexPtr();
  const int* const from = inner + matrix_.outerIndexPtr()[column];
  const int* const to = inner + matrix_.outerIndexPtr()[column + 1];
  if (row == column) return static_cast<int>(to - inner) - 1;  // the diagonal ends its column
  return static_cast<int>(std::lower_bound(from, to, row) - inner);
}

VectorX SparseHessian::times(const std::vector<double>& values, const VectorX& x) const {
  const Eigen::Map<const Matrix> given(matrix_.rows(), matrix_.cols(), matrix_.nonZeros(),
                                       matrix_.outerIndexPtr(), matrix_.innerIndexPtr(),
                                       values.data());
  return unpermuted(given.selfadjointView<Eigen::Upper>() * permuted(x));
}

void SparseHessian::analyse() {
  ldlt_ = std::make_unique<Factor>();
  ldlt_->analyse(matrix_);
}

bool SparseHessian::factorise() {
  if (!ldlt_) analyse();
  ldlt_->factorise(matrix_);
  return ldlt_->info() == Eigen::Success && ldlt_->vectorD().minCoeff() > 0;
}

VectorX SparseHessian::solve(const VectorX& b) const {
  return unpermuted(ldlt_->solve(permuted(b)));
}

void SparseHessian::solveThree(std::vector<Vec3>& b) const {
  const auto& lower = ldlt_->matrixL().nestedExpression();
  const int* const start = lower.outerIndexPtr();
  const int* const row = lower.innerIndexPtr();
  const double* const value = lower.valuePtr();
  const VectorX pivots = ldlt_->vectorD();  // a copy
  std::vector<Vec3> x(b.size());
  for (int i = 0; i < size(); ++i) x[positionOf(i)] = b[i];
  for (int j = 0; j < size(); ++j) {
    const double x0 = x[j][0], x1 = x[j][1], x2 = x[j][2];
    for (int k = start[j]; k < start[j + 1]; ++k) {
      double* const y = x[row[k]].data();
      y[0] -= value[k] * x0, y[1] -= value[k] * x1, y[2] -= value[k] * x2;
    }
  }
  for (int j = size() - 1; j >= 0; --j) {
    double s0 = 0, s1 = 0, s2 = 0;
    for (int k = start[j]; k < start[j + 1]; ++k) {
      const double* const y = x[row[k]].data();
      s0 += value[k] * y[0], s1 += value[k] * y[1], s2 += value[k] * y[2];
    }
    const Vec3 own = x[j] / pivots[j];
    x[j] = Vec3(own[0] - s0, own[1] - s1, own[2] - s2);
  }
  for (int i = 0; i < size(); ++i) b[i] = x[positionOf(i)];
}

Eigen::Index SparseHessian::factorNonZeros() const {
  return ldlt_->matrixL().nestedExpression().nonZeros();
}

VectorX SparseHessian::permuted(const VectorX& x) const {
  if (position_.empty()) return x;
  VectorX result(x.size());
  for (int i = 0; i < size(); ++i) result[position_[i]] = x[i];
  return result;
}

VectorX SparseHessian::unpermuted(const VectorX& x) const {
  if (position_.empty()) return x;
  VectorX result(x.size());
  for (int i = 0; i < size(); ++i) result[i] = x[position_[i]];
  return result;
}

}  // namespace seamwise
