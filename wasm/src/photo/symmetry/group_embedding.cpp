#include "photo/symmetry/group_embedding.h"

#include <algorithm>

namespace seamwise {
namespace {

IntegerMatrix integerProduct(const IntegerMatrix& a, const IntegerMatrix& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],  //
          a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}

/// Returns the inverse for determinant 1.
IntegerMatrix integerInverse(const IntegerMatrix& m) { return {m[3], -m[1], -m[2], m[0]}; }

Mat2 gramIn(const Mat2& gram, const IntegerMatrix& basis) {
  const Mat2 b = (Mat2() << basis[0], basis[1], basis[2], basis[3]).finished();
  return b.transpose() * gram * b;
}

/// Returns the change to a basis of shortest vectors (Lagrange), determinant +1.
IntegerMatrix reducingBasis(const Mat2& gram) {
  IntegerMatrix basis{1, 0, 0, 1};
  // Each step shortens the basis or ends the loop; the limit holds for any numbers.
  for (int step = 0; step < 64; ++step) {
    Mat2 g = gramIn(gram, basis);
    const int times = static_cast<int>(std::round(g(0, 1) / g(0, 0)));
    basis = integerProduct(basis, {1, -times, 0, 1});
    g = gramIn(gram, basis);
    if (g(1, 1) >= g(0, 0) * (1 - 1e-9)) break;
    basis = integerProduct(basis, {0, -1, 1, 0});  // (w1, w2) -> (w2, -w1)
  }
  return basis;
}

bool isOfLatticeType(LatticeType type, const Mat2& gram, double tolerance) {
  const double product = std::sqrt(gram(0, 0) * gram(1, 1));
  const double cosine = gram(0, 1) / product;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const bool equal = std::abs(gram(0, 0) - gram(1, 1)) <= 2 * tolerance * product;
  const bool upright = std::abs(cosine) <= tolerance;
  switch (type) {
    case LatticeType::kOblique:
      return true;
    case LatticeType::kRectangular:
      return upright;
    case LatticeType::kRhombic:
      return equal;
    case LatticeType::kSquare:
      return equal && upright;
    case LatticeType::kHexagonal:
      // sine of the angle's difference from 60 degrees
      return equal && cosine > 0 && std::abs(sine - std::sqrt(3.0) * cosine) <= 2 * tolerance;
  }
  return false;
}

/// Converts elements of the group in its basis B to coordinates of the lattice: B M B^-1, B a.
std::vector<LatticeElement> elementsIn(const std::vector<LatticeElement>& own,
                                       const IntegerMatrix& basis) {
  const IntegerMatrix back = integerInverse(basis);
  const auto fraction = [](double x) { return x - std::floor(x); };
  std::vector<LatticeElement> elements;
  elements.reserve(own.size());
  for (const LatticeElement& e : own) {
    elements.push_back({integerProduct(integerProduct(basis, e.m), back),
                        {fraction(basis[0] * e.a[0] + basis[1] * e.a[1]),
                         fraction(basis[2] * e.a[0] + basis[3] * e.a[1])}});
  }
  return elements;
}

bool areSameElements(const std::vector<LatticeElement>& a, const std::vector<LatticeElement>& b) {
  const auto is_in_b = [&](const LatticeElement& e) {
    return std::any_of(b.begin(), b.end(), [&](const LatticeElement& other) {
      return e.m == other.m && e.a == other.a;  // shifts are multiples of 1/2
    });
  };
  return std::all_of(a.begin(), a.end(), is_in_b);
}

/// Returns the distance of a basis from the given one.
int basisChange(const IntegerMatrix& b) {
  return std::abs(b[0] - 1) + std::abs(b[1]) + std::abs(b[2]) + std::abs(b[3] - 1);
}

}  // namespace

Mat2 reducingMatrix(const Mat2& gram) {
  const IntegerMatrix b = reducingBasis(gram);
  return (Mat2() << b[0], b[1], b[2], b[3]).finished();
}

std::vector<GroupEmbedding> embeddingsOf(const GroupData& group, const Mat2& gram,
                                         double tolerance) {
  std::vector<LatticeElement> own = cosets(group);
  std::vector<GroupEmbedding> found;
  if (group.lattice == LatticeType::kOblique) {
    found.push_back({{1, 0, 0, 1}, std::move(own)});
    return found;
  }
  const IntegerMatrix reducing = reducingBasis(gram);
  const Mat2 reduced = gramIn(gram, reducing);
  // The convention's vectors are sums of at most two of each vector of a reduced basis.
  constexpr int kMost = 2;
  for (int code = 0; code < 5 * 5 * 5 * 5; ++code) {
    const IntegerMatrix change{code % 5 - kMost, code / 5 % 5 - kMost, code / 25 % 5 - kMost,
                               code / 125 - kMost};
    if (change[0] * change[3] - change[1] * change[2] != 1) continue;
    if (!isOfLatticeType(group.lattice, gramIn(reduced, change), tolerance)) continue;
    const IntegerMatrix basis = integerProduct(reducing, change);
    GroupEmbedding embedding{basis, elementsIn(own, basis)};
    const auto same = std::find_if(found.begin(), found.end(), [&](const GroupEmbedding& other) {
      return areSameElements(other.elements, embedding.elements);
    });
    if (same == found.end()) {
      found.push_back(std::move(embedding));
    } else if (basisChange(basis) < basisChange(same->basis)) {
      *same = std::move(embedding);
    }
  }
  return found;
}

}  // namespace seamwise
