#pragma once
#include <cstddef>
#include <vector>

namespace seamwise {

/// Normal equations with each row stored from its first entry on. Few entries are stored if
/// neighbours follow each other closely, and Cholesky's method adds none before the first of a row
/// (George & Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, ch. 4).
class NormalEquations {
 public:
  /// @param first   per unknown: the first unknown coupled to it, at most itself
  explicit NormalEquations(std::vector<int> first);

  std::vector<double> right;  ///< the right side; once solved, the solution
  /// An entry of the lower half: column <= row.
  double& at(int row, int column) { return values_[starts_[row] + column - first_[row]]; }
  void clear();

  /// Returns false if the equations are not positive definite, or not finite. Destroys the matrix.
  bool solve();
  /// Number of multiplications in solve().
  double work() const;

 private:
  std::vector<int> first_;
  std::vector<std::size_t> starts_;  ///< start of each row
  std::vector<double> values_;
};

}  // namespace seamwise
