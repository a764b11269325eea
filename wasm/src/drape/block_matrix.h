#pragma once
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/sort_by.h"
#include "drape/vectors.h"

namespace seamwise {

/// Symmetric matrix of 3x3 blocks, one block per pair of interacting vertices, for products only.
/// It stores the upper triangle.
class BlockMatrix {
 public:
  /// @param pairs   blocks that may be non-zero, in either order, duplicates allowed; the
  ///                constructor adds the diagonal
  BlockMatrix(int size, const std::vector<std::pair<int, int>>& pairs) : start_(size + 1, 0) {
    std::vector<std::pair<int, int>> all;
    all.reserve(pairs.size() + size);
    for (int i = 0; i < size; ++i) all.emplace_back(i, i);
    for (const auto& [i, j] : pairs) all.emplace_back(std::min(i, j), std::max(i, j));
    sortOnce(all);
    for (const auto& [i, j] : all) ++start_[i + 1], column_.push_back(j);
    for (int i = 0; i < size; ++i) start_[i + 1] += start_[i];
    blocks_.assign(column_.size(), {});
  }

  std::size_t blocks() const { return blocks_.size(); }
  void setZero() { std::fill(blocks_.begin(), blocks_.end(), Block{}); }

  /// Adds a block at (i, j) and its transpose at (j, i); call it for only one of the two.
  void add(int i, int j, const Mat3& block) {
    const bool swapped = i > j;
    if (swapped) std::swap(i, j);
    const auto from = column_.begin() + start_[i], to = column_.begin() + start_[i + 1];
    Block& sum = blocks_[std::lower_bound(from, to, j) - column_.begin()];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) sum[3 * r + c] += swapped ? block(c, r) : block(r, c);
  }

  /// y = this x
  void times(const Positions& x, Positions& y) const {
    y.assign(x.size(), Vec3::Zero());
    for (std::size_t i = 0; i < x.size(); ++i) {
      double own[3] = {0, 0, 0};
      for (int k = start_[i]; k < start_[i + 1]; ++k) {
        const Block& b = blocks_[k];
        const auto j = static_cast<std::size_t>(column_[k]);
        for (int r = 0; r < 3; ++r)
          own[r] += b[3 * r] * x[j][0] + b[3 * r + 1] * x[j][1] + b[3 * r + 2] * x[j][2];
        if (j == i) continue;
        for (int c = 0; c < 3; ++c)
          y[j][c] += b[c] * x[i][0] + b[3 + c] * x[i][1] + b[6 + c] * x[i][2];
      }
      for (int r = 0; r < 3; ++r) y[i][r] += own[r];
    }
  }

 private:
  using Block = std::array<double, 9>;
  std::vector<int> start_, column_;  ///< index ranges of the rows
  std::vector<Block> blocks_;
};

}  // namespace seamwise
