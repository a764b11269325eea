#include "deform/sparse.h"

#include <algorithm>

namespace seamwise {

SparseHessian::SparseHessian(int size, const std::vector<std::pair<int, int>>& pairs)
    : matrix_(size, size), ldlt_(std::make_shared<Factor>()) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(pairs.size() + size);
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  for (const auto& [i, j] : pairs)
    if (i >= 0 && j >= 0 && i != j) entries.emplace_back(std::max(i, j), std::min(i, j), 0.0);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
  ldlt_->analyzePattern(matrix_);
}

void SparseHessian::add(int i, int j, double v) {
  if (i < 0 || j < 0) return;
  const int row = std::max(i, j), column = std::min(i, j);
  const int* const inner = matrix_.innerIndexPtr();
  const int* const from = inner + matrix_.outerIndexPtr()[column];
  const int* const to = inner + matrix_.outerIndexPtr()[column + 1];
  matrix_.valuePtr()[std::lower_bound(from, to, row) - inner] += v;
}

VectorX SparseHessian::times(const std::vector<double>& values, const VectorX& x) const {
  const Eigen::Map<const Matrix> given(matrix_.rows(), matrix_.cols(), matrix_.nonZeros(),
                                       matrix_.outerIndexPtr(), matrix_.innerIndexPtr(),
                                       values.data());
  return given.selfadjointView<Eigen::Lower>() * x;
}

bool SparseHessian::factorise() {
  ldlt_->factorize(matrix_);
  return ldlt_->info() == Eigen::Success && ldlt_->vectorD().minCoeff() > 0;
}

}  // namespace seamwise
