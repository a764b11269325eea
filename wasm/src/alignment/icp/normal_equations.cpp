#include "alignment/icp/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seamwise {
namespace {

/// Additions to each diagonal entry: a share of the greatest one, and a constant. Unknowns that no
/// seam determines stay unchanged.
constexpr double kHeld = 1e-9, kHeldAnyway = 1e-12;

}  // namespace

NormalEquations::NormalEquations(std::vector<int> first) : first_(std::move(first)) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    starts_.push_back(size);
    size += i + 1 - static_cast<std::size_t>(first_[i]);
  }
  values_.resize(size);
  right.resize(first_.size());
}

void NormalEquations::clear() {
  std::fill(values_.begin(), values_.end(), 0);
  std::fill(right.begin(), right.end(), 0);
}

bool NormalEquations::solve() {
  const int n = static_cast<int>(right.size());
  double greatest = 0;
  for (int i = 0; i < n; ++i) greatest = std::max(greatest, at(i, i));
  for (int i = 0; i < n; ++i) {
    const int from = first_[i];
    double* const row = &values_[starts_[i]];
    double pivot = row[i - from] + kHeld * greatest + kHeldAnyway;
    for (int j = from; j < i; ++j) {
      const int common = std::max(from, first_[j]);
      const double* const mine = row + (common - from);
      const double* const other = &values_[starts_[j]] + (common - first_[j]);
      double entry = row[j - from];
      for (int k = 0; k < j - common; ++k) entry -= mine[k] * other[k];
      entry /= other[j - common];
      row[j - from] = entry;
      pivot -= entry * entry;
      right[i] -= entry * right[j];
    }
    if (!(pivot > 0)) return false;
    row[i - from] = std::sqrt(pivot);
    right[i] /= row[i - from];
  }
  for (int i = n - 1; i >= 0; --i) {
    const int from = first_[i];
    const double* const row = &values_[starts_[i]];
    right[i] /= row[i - from];
    for (int j = from; j < i; ++j) right[j] -= row[j - from] * right[i];
  }
  return std::all_of(right.begin(), right.end(), [](double x) { return std::isfinite(x); });
}

double NormalEquations::work() const {
  double sum = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const double length = static_cast<double>(i) - first_[i];
    sum += length * length / 2;
  }
  return sum;
}

}  // namespace seamwise
