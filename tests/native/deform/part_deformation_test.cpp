#include <gtest/gtest.h>

#include <functional>

#include "deform/fitting.h"
#include "mesh/lengths.h"
#include "support/meshed_samples.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::meshedPattern;
using testing::Random;

constexpr double kReach = 1.0;  ///< cm

/// Marks the outline vertices of the part that belong to a sewn edge.
std::vector<char> sewnVertices(const Part& part) {
  std::vector<char> sewn(part.rest.size(), 0);
  for (const Part::Edge& e : part.edges)
    if (e.sewn) sewn[e.i] = sewn[e.j] = 1;
  return sewn;
}

void expectKept(const PartDeformation& deformation) {
  const Part& part = deformation.part();
  const auto& x = deformation.shape();
  for (const Part::Edge& e : part.edges) {
    if (e.sewn) {
      EXPECT_NEAR((x[e.i] - x[e.j]).norm(), e.length, 1e-3);
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (part.reach[i] > 0) {
      EXPECT_LT((x[i] - part.rest[i]).norm(), part.reach[i] + 0.02 * kReach);
    }
  }
  for (const auto& [i, j, k] : part.triangles) {
    auto area = [i = i, j = j, k = k](const std::vector<Vec2>& p) {
      return cross(p[j] - p[i], p[k] - p[i]);
    };
    EXPECT_GT(area(x), 0.3 * area(part.rest));
  }
}

TEST(KeptLengths, HaveTheRatioOfEverySeamAndAreEqualOnMirrorImages) {
  for (bool symmetric : {false, true}) {
    const Pattern pattern = meshedPattern(small::tee(1.5), symmetric);
    const auto kept = keptLengths(pattern);
    auto edge = [&](int piece, int u, int v) {
      const int n = static_cast<int>(pattern.pieces[piece].outline.size());
      return kept[piece][(u + 1) % n == v ? u : v];
    };
    for (const Seam& s : pattern.seams) {
      for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i) {
        const double a = edge(s.a.piece, s.a.vertices[i], s.a.vertices[i + 1]);
        const double b = edge(s.b.piece, s.b.vertices[i], s.b.vertices[i + 1]);
        EXPECT_NEAR(a, s.length_ratio * b, 1e-9);
      }
    }
    for (const Mirror& m : pattern.mirrors) {
      const int n = static_cast<int>(pattern.pieces[m.pieces[0]].outline.size());
      for (int v = 0; v < n; ++v)
        EXPECT_NEAR(kept[m.pieces[0]][v], edge(m.pieces[1], m.image[v], m.image[(v + 1) % n]),
                    1e-9);
    }
  }
}

TEST(KeptLengths, AreTheRestLengthsUpToTwoPercent) {
  const Pattern pattern = meshedPattern(small::tee(1.5), true);
  const auto kept = keptLengths(pattern);
  for (std::size_t p = 0; p < kept.size(); ++p) {
    const auto& rest = pattern.pieces[p].rest;
    for (std::size_t k = 0; k < kept[p].size(); ++k) {
      const double length = (rest[(k + 1) % kept[p].size()] - rest[k]).norm();
      EXPECT_NEAR(kept[p][k], length, 0.02 * length);
    }
  }
}

/// Right-angled triangles whose first edges have these lengths; each is sewn to the next.
Pattern chain(const std::vector<double>& lengths) {
  Pattern pattern;
  for (const double length : lengths) {
    Piece piece;
    piece.rest = {{0, 0}, {length, 0}, {0, 1}};
    piece.outline = {0, 1, 2};
    pattern.pieces.push_back(piece);
  }
  for (int p = 0; p + 1 < static_cast<int>(lengths.size()); ++p) {
    Seam seam;
    seam.a = {p, {0, 1}}, seam.b = {p + 1, {0, 1}};
    pattern.seams.push_back(seam);
  }
  return pattern;
}

TEST(KeptLengths, AreTheGeometricMeanOfWhatIsSewnTogether) {
  EXPECT_NEAR(keptLengths(chain({4, 9}))[1][0], 6, 1e-12);
  EXPECT_NEAR(keptLengths(chain({8, 4, 2}))[0][0], 4, 1e-12);
  EXPECT_NEAR(keptLengths(chain({2, 4, 8}))[0][0], 4, 1e-12);
  const auto many = keptLengths(chain(std::vector<double>(200, 0.3)));
  for (const auto& piece : many) EXPECT_NEAR(piece[0], 0.3, 1e-12);
}

TEST(KeptLengths, OfEdgesThatNothingTiesAreTheirOwn) {
  const auto kept = keptLengths(chain({4, 9}));
  EXPECT_EQ(kept[0][2], 1);
  EXPECT_EQ(kept[1][1], std::sqrt(82.0));
}

TEST(Parts, CoverEveryVertexOfEveryPieceAtItsRestPosition) {
  for (bool symmetric : {false, true}) {
    const Pattern pattern = meshedPattern(small::tee(1.5), symmetric);
    const Parts parts = splitIntoParts(pattern, kReach);
    EXPECT_EQ(parts.parts.size(), symmetric ? 3u : 4u) << "two halves and one sleeve";
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
      const Follower& f = parts.pieces[p];
      for (std::size_t v = 0; v < pattern.pieces[p].rest.size(); ++v) {
        const Vec2 at = f.at(static_cast<int>(v), parts.parts[f.part].rest[f.source[v]]);
        EXPECT_LT((at - pattern.pieces[p].rest[v]).norm(), 1e-6);
      }
    }
  }
}

class ClothOf : public ::testing::TestWithParam<bool> {
 protected:
  Pattern pattern_ = meshedPattern(small::tee(1.5), GetParam());
  Parts parts_ = splitIntoParts(pattern_, kReach);
};

INSTANTIATE_TEST_SUITE_P(Tee, ClothOf, ::testing::Bool(), [](const auto& test) {
  return test.param ? "WithSymmetry" : "WithoutSymmetry";
});

TEST_P(ClothOf, StaysWhereItIsWithoutTargets) {
  for (const Part& part : parts_.parts) {
    const DeformationPlan plan(part, {});
    PartDeformation deformation(plan);
    for (int k = 0; k < 10; ++k) deformation.step();
    for (std::size_t i = 0; i < part.rest.size(); ++i)
      EXPECT_LT((deformation.shape()[i] - part.rest[i]).norm(), 0.02);
    EXPECT_LT(deformation.violations().length, 1e-3);
  }
}

TEST_P(ClothOf, KeepsSeamLengthsReachAndUprightTrianglesHoweverFarItsTargetsLie) {
  // pulls as strong as those of seams, whose weight falls as the mismatch grows
  Random random(11);
  const auto anywhere = [&](const Vec2&) { return Vec2(random.point() / 10); };
  const auto smoothly = [](const Vec2& p) { return Vec2(5 * unit(p.sum() / 7)); };
  for (const std::function<Vec2(const Vec2&)>& offset :
       {std::function<Vec2(const Vec2&)>(anywhere), std::function<Vec2(const Vec2&)>(smoothly)}) {
    for (const Part& part : parts_.parts) {
      const DeformationPlan plan(part, {});
      PartDeformation deformation(plan);
      const auto sewn = sewnVertices(part);
      for (std::size_t i = 0; i < part.rest.size(); ++i)
        if (sewn[i])
          deformation.addTarget(static_cast<int>(i), part.rest[i] + offset(part.rest[i]), 0.1);
      for (int k = 0; k < 60; ++k) deformation.step();
      EXPECT_EQ(deformation.factorisations(), 60);
      expectKept(deformation);
    }
  }
}

TEST_P(ClothOf, NeverTurnsATriangleOverHoweverStrongThePull) {
  Random random(12);
  for (const Part& part : parts_.parts) {
    const DeformationPlan plan(part, {});
    PartDeformation deformation(plan);
    for (std::size_t i = 0; i < part.rest.size(); ++i)
      if (part.reach[i] > 0)
        deformation.addTarget(static_cast<int>(i), part.rest[i] + random.point() / 5, 20);
    for (int k = 0; k < 15; ++k) {
      deformation.step();
      EXPECT_GT(deformation.violations().area, 0.3);
    }
  }
}

TEST_P(ClothOf, ReportsWhatItViolates) {
  for (const Part& part : parts_.parts) {
    const DeformationPlan plan(part, {});
    PartDeformation deformation(plan);
    deformation.addTarget(part.edges[0].i, part.rest[part.edges[0].i] + Vec2(0, 5), 10);
    for (int k = 0; k < 3; ++k) deformation.step();
    const auto& x = deformation.shape();
    const PartDeformation::Violations v = deformation.violations();
    double length = 0, stretch = 0, reach = 0, area = 1;
    for (const Part::Edge& e : part.edges) {
      const double now = (x[e.i] - x[e.j]).norm();
      if (e.sewn) length = std::max(length, std::abs(now - e.length));
      stretch = std::max(stretch, std::abs(now / (part.rest[e.i] - part.rest[e.j]).norm() - 1));
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      if (part.reach[i] > 0) reach = std::max(reach, (x[i] - part.rest[i]).norm() - part.reach[i]);
    for (const auto& [i, j, k] : part.triangles)
      area = std::min(area, cross(x[j] - x[i], x[k] - x[i]) /
                                cross(part.rest[j] - part.rest[i], part.rest[k] - part.rest[i]));
    EXPECT_NEAR(v.length, length, 1e-12);
    EXPECT_NEAR(v.stretch, stretch, 1e-12);
    EXPECT_NEAR(v.reach, reach, 1e-12);
    EXPECT_NEAR(v.area, area, 1e-12);
  }
}

TEST(ClothWithoutMirror, FollowsTargetsThatAreARigidShiftWithinItsReach) {
  const Pattern pattern = meshedPattern(small::tee(1.5), false);
  const Parts parts = splitIntoParts(pattern, kReach);
  DeformationWeights weights;
  weights.line = 0;
  for (const Part& part : parts.parts) {
    const DeformationPlan plan(part, weights);
    PartDeformation deformation(plan);
    const auto sewn = sewnVertices(part);
    const Vec2 shift(0.3, -0.5);
    for (std::size_t i = 0; i < part.rest.size(); ++i)
      if (sewn[i]) deformation.addTarget(static_cast<int>(i), part.rest[i] + shift, 5);
    for (int k = 0; k < 30; ++k) deformation.step();
    for (std::size_t i = 0; i < part.rest.size(); ++i) {
      if (sewn[i]) {
        EXPECT_LT((deformation.shape()[i] - part.rest[i] - shift).norm(), 0.05);
      }
    }
    EXPECT_LT(deformation.violations().kink, 0.02);
  }
}

TEST(ClothWithStiffenedKinks, BendsLess) {
  const Pattern pattern = meshedPattern(small::skirt(), false);
  const Parts parts = splitIntoParts(pattern, kReach);
  const Part& part = parts.parts[0];
  const DeformationPlan plan(part, {});
  PartDeformation deformation(plan);
  // A bend on a sewn edge: other edges are held to their line at any cost of their kinks.
  const auto sewn = sewnVertices(part);
  const auto bend = std::find_if(part.bends.begin(), part.bends.end(), [&](const auto& b) {
    return sewn[b.h] && sewn[b.i] && sewn[b.j];
  });
  ASSERT_NE(bend, part.bends.end());
  const int pulled = bend->i;
  deformation.addTarget(pulled, part.rest[pulled] + perp(part.rest[pulled]).normalized(), 50);
  for (int k = 0; k < 20; ++k) deformation.step();
  const double before = deformation.violations().kink;
  EXPECT_FALSE(deformation.stiffenKinks(2 * before)) << "nothing bends by so much";
  EXPECT_TRUE(deformation.stiffenKinks(before / 2));
  for (int k = 0; k < 20; ++k) deformation.step();
  EXPECT_LT(deformation.violations().kink, 0.8 * before);
}

TEST(SeamFitting, BringsTheSidesOfSeamsTogetherWhileSeamsStaySewable) {
  const WallpaperGroup group = testing::sampleGroup(*findGroup("pmm"));
  const Pattern pattern = meshedPattern(small::skirt(), true);
  ASSERT_FALSE(pattern.mirrors.empty());
  std::vector<Alignment> at(pattern.pieces.size());
  at[0].translation = {0, 1.3}, at[1].translation = {0, 0.7};
  auto mismatch = [&](const SeamFitting& fitting) {
    double total = 0;
    for (const Seam& s : pattern.seams) total += bestJoin(group, s, fitting.shapes(), at).cost;
    return total;
  };
  for (bool average : {false, true}) {
    const FittingPlan plan(pattern, {}, kReach);
    SeamFitting fitting(plan, pattern, group, {false, average, {}});
    fitting.chooseJoins(at);
    const double before = mismatch(fitting);
    for (int k = 0; k < 20; ++k) fitting.step(at);
    for (PartDeformation& deformation : fitting.deformations())
      for (int k = 0; k < 10; ++k) deformation.step();
    fitting.collectShapes();
    EXPECT_LT(mismatch(fitting), 0.9 * before);
    EXPECT_LT(testing::seamError(pattern, fitting.shapes()), 0.01);
    EXPECT_LT(testing::shapeAsymmetry(pattern, fitting.shapes()), 1e-9);
    EXPECT_GT(testing::leastArea(pattern, fitting.shapes()), 0.3);
  }
}

}  // namespace
}  // namespace seamwise
