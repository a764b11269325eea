#include "deform/sparse.h"

#include <Eigen/OrderingMethods>
#include <algorithm>

namespace seamwise {

SparseHessian::SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs)
    : ldlt_(std::make_unique<Factor>()) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(pairs.size() + size);
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  for (const auto& [i, j] : pairs)
    if (i >= 0 && j >= 0 && i != j) entries.emplace_back(std::min(i, j), std::max(i, j), 0.0);
  matrix_.resize(size, size);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> eliminated;
  Eigen::AMDOrdering<int>()(matrix_.selfadjointView<Eigen::Upper>(), eliminated);
  position_ = eliminated.inverse();
  for (auto& entry : entries) {
    const int i = position_.indices()[entry.row()], j = position_.indices()[entry.col()];
    entry = {std::min(i, j), std::max(i, j), entry.value()};
  }
  matrix_.setFromTriplets(entries.begin(), entries.end());
  ldlt_->analyzePattern(matrix_);
}

int SparseHessian::slot(int i, int j) const {
  if (i < 0 || j < 0) return -1;
  const int a = position_.indices()[i], b = position_.indices()[j];
  const int row = std::min(a, b), column = std::max(a, b);
  const int* const inner = matrix_.innerIndexPtr();
  const int* const from = inner + matrix_.outerIndexPtr()[column];
  const int* const to = inner + matrix_.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(from, to, row) - inner);
}

VectorX SparseHessian::times(const std::vector<double>& values, const VectorX& x) const {
  const Eigen::Map<const Matrix> given(matrix_.rows(), matrix_.cols(), matrix_.nonZeros(),
                                       matrix_.outerIndexPtr(), matrix_.innerIndexPtr(),
                                       values.data());
  const VectorX permuted = position_ * x;
  const VectorX product = given.selfadjointView<Eigen::Upper>() * permuted;
  return position_.transpose() * product;
}

bool SparseHessian::factorise() {
  ldlt_->factorize(matrix_);
  return ldlt_->info() == Eigen::Success && ldlt_->vectorD().minCoeff() > 0;
}

VectorX SparseHessian::solve(const VectorX& b) const {
  const VectorX permuted = position_ * b;
  const VectorX solved = ldlt_->solve(permuted);
  return position_.transpose() * solved;
}

}  // namespace seamwise
