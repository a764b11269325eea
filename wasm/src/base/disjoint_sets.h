#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace seamwise {

/// A partition of the numbers 0 to count - 1, at first into sets of one number. The least member
/// identifies a set. Joining and finding take about the logarithm of their number, usually far
/// less.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The least member of the set that contains i.
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace seamwise
