#include "pattern/discretise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometry/polygon.h"

namespace seamwise {
namespace {

Panel polygonPanel(const std::string& name, const Polyline& corners) {
  Panel panel;
  panel.name = name;
  for (std::size_t i = 0; i < corners.size(); ++i)
    panel.edges.push_back(Curve::line(corners[i], corners[(i + 1) % corners.size()]));
  return panel;
}

Panel rectangle(const std::string& name, double x0, double y0, double x1, double y1) {
  return polygonPanel(name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Panel mirrored(const Panel& panel, const std::string& name, const RigidMotion& map) {
  Panel image;
  image.name = name;
  for (auto c = panel.edges.rbegin(); c != panel.edges.rend(); ++c)
    image.edges.push_back(c->reversed().transformed(map));
  return image;
}

const RigidMotion kAcrossY = RigidMotion::reflection({0, 0}, {0, 1});

Pattern pattern(const Garment& garment, const std::vector<BodySymmetry>& imposed = {},
                double edge_length = 1) {
  auto outcome = discretise(garment, imposed, imposed, edge_length);
  EXPECT_TRUE(outcome.ok()) << (outcome.ok() ? "" : outcome.error().message);
  return outcome.ok() ? outcome.value() : Pattern{};
}

double sideLength(const Pattern& p, const SeamSide& side) {
  double sum = 0;
  for (std::size_t i = 1; i < side.vertices.size(); ++i)
    sum += (p.pieces[side.piece].rest[side.vertices[i]] -
            p.pieces[side.piece].rest[side.vertices[i - 1]])
               .norm();
  return sum;
}

bool hasVertexAt(const Piece& piece, const Vec2& p) {
  return std::any_of(piece.rest.begin(), piece.rest.end(),
                     [&](const Vec2& q) { return (p - q).norm() < 1e-9; });
}

/// Every imposed mirror is one-to-one, reverses the outline's direction and is off by at most
/// `slack` cm. A single one is its own inverse.
void expectMirrored(const Pattern& p, double slack) {
  for (const Mirror& m : p.mirrors) {
    const Piece &a = p.pieces[m.pieces[0]], &b = p.pieces[m.pieces[1]];
    ASSERT_EQ(m.image.size(), a.rest.size());
    EXPECT_EQ(std::set<int>(m.image.begin(), m.image.end()).size(), b.rest.size());
    const int n = static_cast<int>(a.outline.size());
    for (int v = 0; v < n; ++v) {
      EXPECT_LE((m.map(a.rest[v]) - b.rest[m.image[v]]).norm(), slack);
      EXPECT_EQ(m.image[(v + 1) % n], (m.image[v] + n - 1) % n);
      if (m.single()) {
        EXPECT_EQ(m.image[m.image[v]], v);
      }
    }
  }
}

TEST(Discretise, GivesBothSidesOfASeamTheVerticesOfTheLongerOne) {
  Garment g;
  g.panels = {rectangle("long", 0, 0, 10, 5), rectangle("short", 0, 0, 7.3, 5)};
  g.stitches = {{{0, 0}, {1, 2}}};
  const Pattern p = pattern(g);
  ASSERT_EQ(p.seams.size(), 1u);
  EXPECT_EQ(p.seams[0].a.vertices.size(), 11u);
  EXPECT_EQ(p.seams[0].b.vertices.size(), 11u);
  EXPECT_NEAR(p.seams[0].length_ratio, 10 / 7.3, 1e-12);
  EXPECT_EQ(p.pieces[0].edge_start, (std::vector<int>{0, 10, 15, 25}));
}

TEST(Discretise, ListsSidesInSewingOrder) {
  Garment g;
  g.panels = {rectangle("a", 0, 0, 3, 2), rectangle("b", 0, 0, 3, 2), rectangle("c", 0, 0, 3, 2)};
  g.stitches = {{{0, 0}, {1, 2}}, {{1, 0}, {2, 0}, true}};
  const Pattern p = pattern(g);
  EXPECT_EQ(p.seams[0].a.vertices, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(p.seams[0].b.vertices, (std::vector<int>{8, 7, 6, 5}));
  EXPECT_EQ(p.seams[1].a.vertices, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(p.seams[1].b.vertices, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Discretise, ClosesTheLastEdgeAtVertexZero) {
  Garment g;
  g.panels = {rectangle("a", 0, 0, 3, 2), rectangle("b", 0, 0, 3, 2)};
  g.stitches = {{{0, 3}, {1, 1}}};
  const Pattern p = pattern(g);
  EXPECT_EQ(p.seams[0].a.vertices, (std::vector<int>{8, 9, 0}));
  EXPECT_EQ(p.seams[0].b.vertices, (std::vector<int>{5, 4, 3}));
}

TEST(Discretise, NeverMakesAnEdgeLongerThanMismatchAllows) {
  Garment g;
  g.panels = {rectangle("a", 0, 0, 30.7, 20), rectangle("b", 0, 0, 29, 20)};
  g.stitches = {{{0, 0}, {1, 0}}};
  const Pattern p = pattern(g, {}, 5);
  for (const Piece& piece : p.pieces)
    for (std::size_t v = 0; v < piece.rest.size(); ++v)
      EXPECT_LE((piece.rest[v] - piece.rest[(v + 1) % piece.rest.size()]).norm(), 1.05 + 1e-9);
}

TEST(Discretise, PutsAVertexWhereAnAxisCrossesAnEdgeAndOnTheOtherSideOfItsSeam) {
  Garment g;
  // The skirt is symmetric; its waist is sewn to an asymmetric band of another length.
  g.panels = {polygonPanel("skirt", {{-7, 0}, {7, 0}, {5.3, 9}, {-5.3, 9}}),
              polygonPanel("band", {{0, 0}, {13, 0}, {13, 2}, {0, 3}})};
  g.stitches = {{{0, 2}, {1, 0}}};
  const Pattern p = pattern(g, {{{0, 0}, kAcrossY}});
  EXPECT_TRUE(hasVertexAt(p.pieces[0], {0, 0}));
  EXPECT_TRUE(hasVertexAt(p.pieces[0], {0, 9}));
  EXPECT_TRUE(hasVertexAt(p.pieces[1], {6.5, 0}));
  expectMirrored(p, 1e-9);
  for (std::size_t v = 0; v < p.pieces[0].rest.size(); ++v) {
    if (std::abs(p.pieces[0].rest[v].x()) < 1e-9) {
      EXPECT_EQ(p.mirrors[0].image[v], static_cast<int>(v));
    }
  }
}

TEST(Discretise, MatchesANecklineDraftedAsOneEdgeHereAndAsTwoThere) {
  const Panel left = polygonPanel("left", {{1, 0}, {9, 0}, {9, 8}, {1, 6}});
  Panel right = polygonPanel("right", {{-1, 6}, {-5, 7}, {-9, 8}, {-9, 0}, {-1, 0}});
  Garment g;
  g.panels = {left, right};
  const Pattern p = pattern(g, {{{0, 1}, kAcrossY}});
  EXPECT_TRUE(hasVertexAt(p.pieces[0], {5, 7}));
  expectMirrored(p, 1e-9);
}

TEST(Discretise, FollowsCurvesToTheirMirrorImages) {
  Panel left;
  left.name = "left";
  left.edges = {Curve::cubic({1, 0}, {4, -2}, {9, 1}, {12, 0}),
                Curve::quadratic({12, 0}, {16, 6}, {12, 11}),
                Curve::arc({12, 11}, {1, 9}, 9, false, true), Curve::line({1, 9}, {1, 0})};
  Garment g;
  g.panels = {left, mirrored(left, "right", kAcrossY)};
  expectMirrored(pattern(g, {{{0, 1}, kAcrossY}}), 1e-8);
}

TEST(Discretise, RecognisesASeamBetweenMirrorTwins) {
  // A dart on the axis: its legs 1 and 2 are images of each other.
  Garment g;
  g.panels = {
      polygonPanel("front", {{-6, 0}, {-0.5, 0}, {0, 4}, {0.5, 0}, {6, 0}, {6, 9}, {-6, 9}}),
      rectangle("other", 0, 0, 9, 3)};
  g.stitches = {{{0, 1}, {0, 2}}, {{0, 4}, {1, 3}}};
  const BodySymmetry axis{{0, 0}, kAcrossY};
  const Pattern with = pattern(g, {axis}), without = pattern(g);
  EXPECT_TRUE(with.seams[0].twin);
  EXPECT_FALSE(with.seams[1].twin);
  EXPECT_FALSE(without.seams[0].twin);
}

TEST(Discretise, AveragesSeamRatiosOverTheTwoSidesOfASymmetricPiece) {
  // The left side is 10 long, the right one 10.04: under symmetry both become 10.02.
  Garment g;
  g.panels = {polygonPanel("front", {{-4, 0}, {4, -0.04}, {4, 10}, {-4, 10}}),
              rectangle("back", 0, 0, 4, 10)};
  g.stitches = {{{0, 1}, {1, 3}}};
  EXPECT_NEAR(pattern(g, {{{0, 0}, kAcrossY}}).seams[0].length_ratio, 1.002, 1e-12);
  EXPECT_NEAR(pattern(g).seams[0].length_ratio, 1.004, 1e-12);
}

TEST(Discretise, FollowsTightArcsCloselyEnoughForTheirLength) {
  Garment g;
  Panel panel = rectangle("pocket", 0, 0, 6, 6);
  panel.holes = {{Curve::arc({2.7, 3}, {3.3, 3}, 0.3, false, false),
                  Curve::arc({3.3, 3}, {2.7, 3}, 0.3, false, false)}};
  g.panels = {panel};
  const Pattern p = pattern(g);
  ASSERT_EQ(p.pieces[0].holes.size(), 1u);
  Polyline hole;
  for (const int v : p.pieces[0].holes[0]) hole.push_back(p.pieces[0].rest[v]);
  EXPECT_LT(signedArea(hole), 0);
  double length = 0;
  for (std::size_t i = 0; i < hole.size(); ++i)
    length += (hole[(i + 1) % hole.size()] - hole[i]).norm();
  EXPECT_NEAR(length / (2 * kPi * 0.3), 1, 5e-3);
}

TEST(Discretise, GivesAPieceOfTwoEdgesAnArea) {
  Garment g;
  Panel lens;
  lens.name = "lens";
  lens.edges = {Curve::line({0, 0}, {0.8, 0}), Curve::quadratic({0.8, 0}, {0.4, 0.2}, {0, 0})};
  g.panels = {lens};
  const Pattern p = pattern(g);
  EXPECT_GE(p.pieces[0].rest.size(), 3u);
  EXPECT_GT(signedArea(p.pieces[0].rest), 0);
}

TEST(Discretise, RefinesUntilChordsNoLongerCross) {
  // A crescent whose arcs meet at 2 degrees. Its inner arc is gathered, so it is finely sampled;
  // coarse chords of the outer one would cut through it.
  Garment g;
  Panel crescent;
  crescent.name = "crescent";
  crescent.edges = {Curve::arc({-8, 0}, {8, 0}, 8.2, false, true),
                    Curve::arc({8, 0}, {-8, 0}, 8.27, false, false)};
  g.panels = {crescent, rectangle("frill", 0, 0, 100, 5)};
  g.stitches = {{{0, 1}, {1, 0}}};
  const Pattern p = pattern(g);
  EXPECT_FALSE(findCrossing(p.pieces[0].rest).has_value());
  EXPECT_GT(signedArea(p.pieces[0].rest), 0);
}

TEST(Discretise, EndsWhereSeamsAndSymmetriesDisagree) {
  // The skirt's axis is 0.3 cm beside the seam between the halves of the top. The two symmetries
  // and the waist seams together would shift the waist by 0.6 cm, again and again.
  Garment g;
  const Panel left = polygonPanel("left", {{0, 0}, {20, 0}, {18, 30}, {0, 30}});
  g.panels = {
      left, mirrored(left, "right", kAcrossY),
      polygonPanel("skirt", {{-25, 0}, {25, 0}, {20.3, 40}, {0.3, 40}, {-19.7, 40}, {-20.3, 40}})};
  g.stitches = {{{0, 0}, {2, 2}, false}, {{1, 3}, {2, 3}, false}};
  const std::vector<BodySymmetry> imposed{{{0, 1}, kAcrossY}, {{2, 2}, kAcrossY}};
  const Pattern p = pattern(g, imposed);
  ASSERT_EQ(p.seams.size(), 2u);
  expectMirrored(p, 0.35);
  EXPECT_LT(p.pieces[2].rest.size(), 400u);
  for (const Seam& s : p.seams) {
    ASSERT_EQ(s.a.vertices.size(), s.b.vertices.size());
    for (std::size_t i = 1; i < s.a.vertices.size(); ++i) {
      const auto &a = p.pieces[s.a.piece].rest, &b = p.pieces[s.b.piece].rest;
      const double la = (a[s.a.vertices[i]] - a[s.a.vertices[i - 1]]).norm() / sideLength(p, s.a);
      const double lb = (b[s.b.vertices[i]] - b[s.b.vertices[i - 1]]).norm() / sideLength(p, s.b);
      EXPECT_NEAR(la / lb, 1, 0.1);
    }
  }
}

TEST(Discretise, KeepsToTheDraftedOutlineWhenItIsNotQuiteSymmetric) {
  Garment g;
  g.panels = {
      polygonPanel("front", {{-10, 0}, {10.06, 0}, {10, 20}, {3, 24.05}, {-3, 24}, {-10, 20}})};
  const Pattern p = pattern(g, {{{0, 0}, kAcrossY, 0.06}});
  expectMirrored(p, 0.2);
  Polyline outline;
  for (const Curve& c : g.panels[0].edges) outline.push_back(c.start());
  outline.push_back(outline.front());
  for (const Vec2& v : p.pieces[0].rest) EXPECT_LT(nearestOnPolyline(outline, v).distance, 1e-9);
  for (std::size_t v = 0; v < p.pieces[0].rest.size(); ++v)
    EXPECT_GT((p.pieces[0].rest[v] - p.pieces[0].rest[(v + 1) % p.pieces[0].rest.size()]).norm(),
              0.3);
}

TEST(Discretise, NamesThePieceThatDoesNotMirrorAndIgnoresItWhenNobodyImposedIt) {
  Garment g;
  g.panels = {polygonPanel("crooked", {{-5, 0}, {8, 0}, {3, 9}})};
  const BodySymmetry axis{{0, 0}, kAcrossY};
  const auto imposed = discretise(g, {axis}, {axis}, 1);
  ASSERT_FALSE(imposed.ok());
  EXPECT_EQ(imposed.error().code, Failure::kMesh);
  EXPECT_EQ(imposed.error().piece, 0);
  EXPECT_NE(imposed.error().message.find("crooked"), std::string::npos);
  EXPECT_TRUE(discretise(g, {axis}, {}, 1).ok());
}

TEST(Discretise, NamesAPieceThatCrossesItself) {
  Garment g;
  g.panels = {polygonPanel("bow", {{0, 0}, {9, 9}, {9, 0}, {0, 9}})};
  const auto outcome = discretise(g, {}, {}, 1);
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.error().message.find("'bow'"), std::string::npos);
}

}  // namespace
}  // namespace seamwise
