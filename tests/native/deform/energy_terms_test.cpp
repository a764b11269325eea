#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>
#include <limits>

#include "deform/terms.h"
#include "support/print_samples.h"
#include "tuning/paper.h"

namespace seamwise {
namespace {

using testing::Random;
using Matrix = Eigen::MatrixXd;

constexpr int kSide = 4;  ///< vertices along a side of the sample mesh
constexpr int kVertices = kSide * kSide;

Vec2 vertex(const VectorX& x, int v) { return x.segment<2>(2 * v); }

VectorX transformed(const VectorX& x, const std::function<Vec2(const Vec2&)>& map) {
  VectorX image(x.size());
  for (int v = 0; v < kVertices; ++v) image.segment<2>(2 * v) = map(vertex(x, v));
  return image;
}

/// A grid of triangles about 1 cm wide, every vertex moved at random by up to `jitter` cm.
VectorX grid(double jitter, unsigned seed) {
  Random random(seed);
  VectorX x(2 * kVertices);
  for (int v = 0; v < kVertices; ++v) {
    x[2 * v] = v % kSide + random.between(-jitter, jitter);
    x[2 * v + 1] = v / kSide + random.between(-jitter, jitter);
  }
  return x;
}

std::vector<ConformalTriangle> trianglesAt(const VectorX& rest) {
  std::vector<ConformalTriangle> triangles;
  auto add = [&](int i, int j, int k) {
    triangles.push_back(
        conformalTriangle({i, j, k}, vertex(rest, i), vertex(rest, j), vertex(rest, k)));
  };
  for (int r = 0; r + 1 < kSide; ++r) {
    for (int c = 0; c + 1 < kSide; ++c) {
      const int v = r * kSide + c;
      add(v, v + 1, v + kSide);
      add(v + 1, v + kSide + 1, v + kSide);
    }
  }
  return triangles;
}

/// Pairs of edges; the last two share a vertex, like the legs of a dart.
std::vector<EdgePair> edgePairs() {
  return {{0, 1, 4, 8, 1.0}, {5, 6, 15, 14, 0.8}, {9, 13, 9, 10, 1.1}, {2, 3, 3, 7, 1.0}};
}

/// A pair under a glide reflection; two images and an axis vertex under a true mirror.
std::vector<MirrorPair> mirrorPairs(const RigidMotion& glide, const RigidMotion& mirror) {
  return {{0, 5, glide.linear(), glide.shift},
          {1, 6, glide.linear(), glide.shift},
          {8, 11, mirror.linear(), mirror.shift},
          {12, 15, mirror.linear(), mirror.shift},
          {9, 9, mirror.linear(), mirror.shift}};
}

struct Term {
  const char* name;
  bool quadratic;
  std::function<double(const VectorX&, VectorX*, SparseHessian*)> energy;
};

std::vector<Term> terms() {
  Random random(3);
  const auto triangles = trianglesAt(grid(0.2, 1));
  // the barrier only acts on triangles that have lost half of their area
  const auto larger = trianglesAt(3 * grid(0.2, 1));
  const std::vector<Target> targets{{0, {0.5, -2}, 1.5}, {7, {3, 3}, 0.2}, {7, {2, 1}, 2.0}};
  const auto mirrors = mirrorPairs(random.glide(), random.reflection());
  return {{"proximity", true,
           [=](const VectorX& x, VectorX* g, SparseHessian* h) {
             return proximityEnergy(targets, x, g, h);
           }},
          {"conformal", true,
           [=](const VectorX& x, VectorX* g, SparseHessian* h) {
             return conformalEnergy(triangles, x, 0.7, g, h);
           }},
          {"symmetry", true,
           [=](const VectorX& x, VectorX* g, SparseHessian* h) {
             return symmetryEnergy(mirrors, x, 1.3, g, h);
           }},
          {"flip", false,
           [=](const VectorX& x, VectorX* g, SparseHessian* h) {
             return flipEnergy(larger, x, 0.3, g, h);
           }},
          {"match", false, [=](const VectorX& x, VectorX* g, SparseHessian* h) {
             return matchEnergy(edgePairs(), x, 2.0, g, h);
           }}};
}

VectorX gradientOf(const Term& term, const VectorX& x) {
  VectorX g = VectorX::Zero(x.size());
  term.energy(x, &g, nullptr);
  return g;
}

Matrix hessianOf(const Term& term, const VectorX& x) {
  const int n = static_cast<int>(x.size());
  std::vector<std::pair<int, int>> all;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) all.emplace_back(i, j);
  SparseHessian sparse(n, all);
  sparse.setZero();
  term.energy(x, nullptr, &sparse);
  const std::vector<double> values(sparse.values(), sparse.values() + sparse.nonZeros());
  Matrix dense(n, n);
  for (int i = 0; i < n; ++i) dense.col(i) = sparse.times(values, VectorX::Unit(n, i));
  return dense;
}

VectorX gradientByDifferences(const Term& term, const VectorX& x) {
  constexpr double kStep = 1e-5;
  VectorX g(x.size());
  for (int i = 0; i < x.size(); ++i) {
    const VectorX d = kStep * VectorX::Unit(x.size(), i);
    g[i] =
        (term.energy(x + d, nullptr, nullptr) - term.energy(x - d, nullptr, nullptr)) / (2 * kStep);
  }
  return g;
}

Matrix hessianByDifferences(const Term& term, const VectorX& x) {
  constexpr double kStep = 1e-5;
  Matrix h(x.size(), x.size());
  for (int i = 0; i < x.size(); ++i) {
    const VectorX d = kStep * VectorX::Unit(x.size(), i);
    h.col(i) = (gradientOf(term, x + d) - gradientOf(term, x - d)) / (2 * kStep);
  }
  return h;
}

TEST(EnergyTerms, HaveTheGradientsOfTheirValues) {
  for (const Term& term : terms()) {
    for (unsigned seed = 10; seed < 15; ++seed) {
      const VectorX x = grid(0.15, seed);
      const VectorX exact = gradientOf(term, x);
      EXPECT_GT(exact.norm(), 0.1) << term.name << " is not exercised";
      EXPECT_LT((exact - gradientByDifferences(term, x)).norm(), 1e-6 * exact.norm()) << term.name;
    }
  }
}

TEST(EnergyTerms, HaveExactHessiansWhereTheyAreQuadratic) {
  for (const Term& term : terms()) {
    if (!term.quadratic) continue;
    const VectorX x = grid(0.15, 20);
    const Matrix exact = hessianOf(term, x);
    EXPECT_LT((exact - hessianByDifferences(term, x)).norm(), 1e-6 * exact.norm()) << term.name;
  }
}

TEST(EnergyTerms, HaveHessiansWithoutNegativeEigenvalues) {
  for (const Term& term : terms()) {
    const Matrix h = hessianOf(term, grid(0.15, 21));
    EXPECT_GT(h.norm(), 0.1) << term.name;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(h);
    EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-10 * h.norm()) << term.name;
  }
}

TEST(ConformalEnergy, IsZeroForEverySimilarityAndForNoMirrorImage) {
  const VectorX rest = grid(0.2, 1);
  const auto triangles = trianglesAt(rest);
  Random random(7);
  for (int k = 0; k < 10; ++k) {
    const Mat2 linear = random.between(0.2, 3) * rotation(random.angle());
    const Vec2 shift = random.point();
    const auto similar = transformed(rest, [&](const Vec2& p) { return linear * p + shift; });
    EXPECT_LT(conformalEnergy(triangles, similar, 1, nullptr, nullptr), 1e-18 * 2500);
  }
  const auto mirrored = transformed(rest, [](const Vec2& p) { return Vec2(-p.x(), p.y()); });
  EXPECT_GT(conformalEnergy(triangles, mirrored, 1, nullptr, nullptr), 1);
}

TEST(ConformalEnergy, OfAShearIsAreaTimesItsSquare) {
  // J = [[1, s], [0, 1]], so |J - cof J|^2 / 2 = s^2 on 9 cm2
  const VectorX rest = grid(0, 1);
  const auto sheared =
      transformed(rest, [](const Vec2& p) { return Vec2(p.x() + 0.3 * p.y(), p.y()); });
  EXPECT_NEAR(conformalEnergy(trianglesAt(rest), sheared, 2, nullptr, nullptr), 2 * 9 * 0.09, 1e-9);
}

TEST(FlipBarrier, IsZeroAboveItsStartAndInfiniteOnceATriangleTurnsOver) {
  const VectorX rest = grid(0.1, 1);
  const auto triangles = trianglesAt(rest);
  auto withWidth = [&](double factor) {
    const auto x = transformed(rest, [&](const Vec2& p) { return Vec2(factor * p.x(), p.y()); });
    return flipEnergy(triangles, x, 1, nullptr, nullptr);
  };
  EXPECT_EQ(withWidth(1), 0);
  EXPECT_EQ(withWidth(PaperTuning::kFlipStart + 1e-9), 0);
  EXPECT_GT(withWidth(0.9 * PaperTuning::kFlipStart), 0);
  EXPECT_GT(withWidth(0.01), withWidth(0.1));
  EXPECT_EQ(withWidth(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(withWidth(-0.5), std::numeric_limits<double>::infinity());
}

TEST(FlipBarrier, IsInfiniteWhenASingleTriangleTurnsOver) {
  VectorX x = grid(0, 1);
  const auto triangles = trianglesAt(x);
  x.segment<2>(0) = Vec2(0.8, 0.8);  // the corner vertex crosses its triangle's long side
  EXPECT_EQ(flipEnergy(triangles, x, 1, nullptr, nullptr), std::numeric_limits<double>::infinity());
}

TEST(MatchEnergy, IsZeroAtTheRatioAndItsHessianIsExactThere) {
  const VectorX x = grid(0.15, 30);
  std::vector<EdgePair> pairs = edgePairs();
  for (EdgePair& p : pairs)
    p.rho = (vertex(x, p.a1) - vertex(x, p.a0)).norm() / (vertex(x, p.b1) - vertex(x, p.b0)).norm();
  const Term term{"match", false, [&](const VectorX& y, VectorX* g, SparseHessian* h) {
                    return matchEnergy(pairs, y, 2.0, g, h);
                  }};
  EXPECT_LT(term.energy(x, nullptr, nullptr), 1e-28);
  EXPECT_LT((hessianOf(term, x) - hessianByDifferences(term, x)).norm(), 1e-7);
}

TEST(SymmetryEnergy, IsZeroForSymmetricShapesAndNotForOthers) {
  Random random(8);
  const RigidMotion glide = random.glide(), mirror = random.reflection();
  const auto pairs = mirrorPairs(glide, mirror);
  VectorX x = grid(0.15, 31);
  EXPECT_GT(symmetryEnergy(pairs, x, 1, nullptr, nullptr), 1);
  for (const MirrorPair& p : pairs) {
    const RigidMotion& map = p.source < 8 ? glide : mirror;
    const Vec2 image = map(vertex(x, p.source));
    if (p.source == p.image)
      x.segment<2>(2 * p.image) = (image + vertex(x, p.source)) / 2;
    else
      x.segment<2>(2 * p.image) = image;
  }
  EXPECT_LT(symmetryEnergy(pairs, x, 1, nullptr, nullptr), 1e-24);
}

}  // namespace
}  // namespace seamwise
