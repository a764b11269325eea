// Unit of work for times, so that figures of different machines are comparable.
#include <algorithm>

#include "bench.h"
#include "numeric/sparse.h"

namespace seamwise::bench {

double gridFactorisation() {
  constexpr int kNodes = 90;
  const auto node = [](int row, int column) { return row * kNodes + column; };
  std::vector<std::pair<int, int>> pairs;
  for (int r = 0; r < kNodes; ++r)
    for (int c = 0; c < kNodes; ++c)
      for (const auto& [dr, dc] : {std::pair(0, 0), {0, 1}, {1, 0}, {1, -1}})
        if (r + dr < kNodes && c + dc >= 0 && c + dc < kNodes)
          for (int k = 0; k < 4; ++k)
            pairs.emplace_back(2 * node(r, c) + k / 2, 2 * node(r + dr, c + dc) + k % 2);
  SparseHessian matrix(2 * kNodes * kNodes, pairs);
  matrix.analyse();
  double least = 1e300;
  for (int k = 0; k < 9; ++k) {
    matrix.setZero();
    for (const auto& [i, j] : pairs) matrix.add(i, j, i == j ? 20 : -0.1);
    const Watch watch;
    if (!matrix.factorise()) throw std::runtime_error("The grid could not be factorised.");
    least = std::min(least, watch.milliseconds());
  }
  return least;
}

}  // namespace seamwise::bench
