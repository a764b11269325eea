#include "mesh/lengths.h"

#include <algorithm>
#include <numeric>

namespace seamwise {
namespace {

/// A union-find of edges with factors: length = factor x length of the root.
class Ties {
 public:
  explicit Ties(int n) : parent_(n), factor_(n, 1.0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    if (parent_[i] == i) return i;
    const int up = parent_[i];
    const int root = find(up);
    factor_[i] *= factor_[up];
    parent_[i] = root;
    return root;
  }
  double factor(int i) {
    find(i);
    return factor_[i];
  }
  /// length(i) = ratio x length(j)
  void tie(int i, int j, double ratio) {
    const int ri = find(i), rj = find(j);
    if (ri == rj) return;
    parent_[ri] = rj;
    factor_[ri] = ratio * factor_[j] / factor_[i];
  }

 private:
  std::vector<int> parent_;
  std::vector<double> factor_;
};

/// The geometric mean of positive numbers of similar size; exact for a single number.
class Mean {
 public:
  void add(double value) {
    if (count_ == 0) first_ = value;
    ratios_ *= value / first_;
    ++count_;
  }
  /// Newton's iteration, which decreases from above until rounding stops it.
  double value() const {
    double mean = std::max(1.0, ratios_);
    for (double next = mean; count_ > 1; mean = next) {
      double power = 1;
      for (int k = 1; k < count_; ++k) power *= mean;
      next = ((count_ - 1) * mean + ratios_ / power) / count_;
      if (next >= mean) break;
    }
    return first_ * mean;
  }

 private:
  double first_ = 1, ratios_ = 1;  ///< product of all numbers, each divided by the first
  int count_ = 0;
};

}  // namespace

std::vector<std::vector<double>> keptLengths(const Pattern& pattern) {
  std::vector<int> first(pattern.pieces.size() + 1, 0);
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    first[p + 1] = first[p] + static_cast<int>(pattern.pieces[p].outline.size());
  auto edge = [&](int piece, int u, int v) {
    return first[piece] + outlineEdge(pattern.pieces[piece], u, v);
  };
  Ties ties(first.back());
  for (const Mirror& m : pattern.mirrors) {
    const int n = static_cast<int>(pattern.pieces[m.pieces[0]].outline.size());
    for (int v = 0; v < n; ++v) {
      const int w = (v + 1) % n;
      ties.tie(edge(m.pieces[0], v, w), edge(m.pieces[1], m.image[v], m.image[w]), 1.0);
    }
  }
  for (const Seam& s : pattern.seams) {
    for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i)
      ties.tie(edge(s.a.piece, s.a.vertices[i], s.a.vertices[i + 1]),
               edge(s.b.piece, s.b.vertices[i], s.b.vertices[i + 1]), s.length_ratio);
  }
  // The root's length is the geometric mean of the estimates from its members' rest lengths.
  std::vector<Mean> means(first.back());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece& piece = pattern.pieces[p];
    const int n = static_cast<int>(piece.outline.size());
    for (int k = 0; k < n; ++k) {
      const double l = (piece.rest[(k + 1) % n] - piece.rest[k]).norm();
      const int e = first[p] + k, root = ties.find(e);
      means[root].add(l / ties.factor(e));
    }
  }
  std::vector<std::vector<double>> kept(pattern.pieces.size());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    for (std::size_t k = 0; k < pattern.pieces[p].outline.size(); ++k) {
      const int e = first[p] + static_cast<int>(k), root = ties.find(e);
      kept[p].push_back(ties.factor(e) * means[root].value());
    }
  }
  return kept;
}

}  // namespace seamwise
