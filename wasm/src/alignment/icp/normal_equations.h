#pragma once
#include <cstddef>
#include <vector>

namespace seamwise {

/// Normal equations of which each row is stored from its first entry on: when neighbours follow
/// each other closely, few entries are stored, and Cholesky's method adds none before the first of
/// a row (George & Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, ch. 4).
class NormalEquations {
 public:
  /// @param first   per unknown: the first that anything ties it to, at most itself
  explicit NormalEquations(std::vector<int> first);

  std::vector<double> right;  ///< the right side; once solved, the solution
  /// An entry of the lower half: column <= row.
  double& at(int row, int column) { return values_[starts_[row] + column - first_[row]]; }
  void clear();

  /// False when they are not positive definite, or not finite. The matrix is lost.
  bool solve();
  /// Multiplications that solving takes.
  double work() const;

 private:
  std::vector<int> first_;
  std::vector<std::size_t> starts_;  ///< of the rows
  std::vector<double> values_;
};

}  // namespace seamwise
