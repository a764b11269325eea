#include "deform/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "deform/triangulation.h"
#include "geometry/polygon.h"

namespace seamwise {
namespace {

using Triangle = std::array<int, 3>;

/// A piece whose rest holds its loops only; holes are clockwise.
Piece pieceOf(const Polyline& outline, const std::vector<Polyline>& holes = {}) {
  Piece piece;
  piece.name = "piece";
  const auto add = [&](const Polyline& loop) {
    std::vector<int> ring;
    for (const Vec2& p : loop) {
      ring.push_back(static_cast<int>(piece.rest.size()));
      piece.rest.push_back(p);
    }
    return ring;
  };
  piece.outline = add(outline);
  for (const Polyline& hole : holes) piece.holes.push_back(add(hole));
  return piece;
}

/// Straight edges cut into equal parts no longer than `step`.
Polyline sampled(const Polyline& corners, double step) {
  Polyline line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step - 1e-9)));
    for (int k = 0; k < n; ++k) line.push_back(a + (b - a) * k / n);
  }
  return line;
}

Polyline circle(const Vec2& centre, double radius, int n, bool clockwise = false) {
  Polyline line;
  for (int k = 0; k < n; ++k)
    line.push_back(centre + radius * unit((clockwise ? -1 : 1) * 2 * kPi * k / n));
  return line;
}

double area(const Piece& p, const Triangle& t) {
  return cross(p.rest[t[1]] - p.rest[t[0]], p.rest[t[2]] - p.rest[t[0]]) / 2;
}

double smallestAngle(const Piece& p, const Triangle& t) {
  double least = kPi;
  for (int k = 0; k < 3; ++k) {
    const Vec2 u = p.rest[t[(k + 1) % 3]] - p.rest[t[k]], v = p.rest[t[(k + 2) % 3]] - p.rest[t[k]];
    least = std::min(least, std::atan2(cross(u, v), u.dot(v)));
  }
  return least;
}

/// Counter-clockwise triangles that fill the outline, use every vertex, and have it as their
/// border.
void expectFilled(const Piece& p) {
  double sum = 0, wanted = 0;
  std::set<std::pair<int, int>> sides, rim;
  std::set<int> used;
  for (const Triangle& t : p.triangles) {
    EXPECT_GT(area(p, t), 0);
    sum += area(p, t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
      used.insert(t[k]);
    }
  }
  std::vector<std::vector<int>> loops = p.holes;
  loops.push_back(p.outline);
  for (const auto& loop : loops) {
    Polyline line;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      line.push_back(p.rest[loop[i]]);
      rim.insert({loop[i], loop[(i + 1) % loop.size()]});
    }
    wanted += signedArea(line);
  }
  EXPECT_NEAR(sum, wanted, 1e-7 * (1 + wanted));
  EXPECT_EQ(used.size(), p.rest.size());
  std::set<std::pair<int, int>> border;
  for (const auto& [a, b] : sides)
    if (!sides.count({b, a})) border.insert({a, b});
  EXPECT_EQ(border, rim);
}

Piece filled(const Piece& piece, double coarsest = 2) {
  Pattern pattern;
  pattern.pieces = {piece};
  const auto outcome = meshed(pattern, coarsest);
  EXPECT_TRUE(outcome.ok()) << (outcome.ok() ? "" : outcome.error().message);
  if (!outcome.ok()) return piece;
  expectFilled(outcome.value().pieces[0]);
  return outcome.value().pieces[0];
}

TEST(Mesh, FillsATriangleWithItself) {
  EXPECT_EQ(filled(pieceOf({{0, 0}, {1, 0}, {0, 1}})).triangles.size(), 1u);
}

TEST(Mesh, KeepsTheOutlineAndNumbersInteriorVerticesAfterIt) {
  const Piece before = pieceOf(sampled({{0, 0}, {20, 0}, {20, 30}, {0, 30}}, 1));
  const Piece after = filled(before);
  ASSERT_GT(after.rest.size(), before.rest.size());
  for (std::size_t v = 0; v < before.rest.size(); ++v) EXPECT_EQ(after.rest[v], before.rest[v]);
}

TEST(Mesh, HasNoSliversAwayFromSharpCorners) {
  const Piece square = filled(pieceOf(sampled({{0, 0}, {30, 0}, {30, 30}, {0, 30}}, 1)));
  for (const Triangle& t : square.triangles) EXPECT_GT(smallestAngle(square, t), 24 * kPi / 180);
  const Piece disc = filled(pieceOf(circle({0, 0}, 20, 130)), 1);
  for (const Triangle& t : disc.triangles) EXPECT_GT(smallestAngle(disc, t), 25 * kPi / 180);
}

TEST(Mesh, GrowsCoarserInsideUpToItsLimit) {
  const Piece piece = filled(pieceOf(circle({0, 0}, 30, 188)), 3);
  double longest = 0;
  for (const Triangle& t : piece.triangles)
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (piece.rest[t[k]] - piece.rest[t[(k + 1) % 3]]).norm());
  EXPECT_GT(longest, 2.5);
  EXPECT_LT(longest, 5);
}

TEST(Mesh, TurnsAndScalesWithThePiece) {
  const Polyline outline = sampled({{0, 0}, {20, 0}, {14, 30}, {0, 22}}, 1);
  Polyline larger;
  for (const Vec2& p : outline) larger.push_back(2 * p);
  EXPECT_EQ(filled(pieceOf(outline), 2).triangles, filled(pieceOf(larger), 4).triangles);
}

TEST(Mesh, FillsAroundCutOuts) {
  const Piece piece = filled(pieceOf(sampled({{0, 0}, {20, 0}, {20, 20}, {0, 20}}, 1),
                                     {circle({6, 6}, 3, 20, true), circle({14, 13}, 0.3, 20, true),
                                      circle({6, 14}, 0.04, 5, true)}));
  EXPECT_EQ(piece.holes.size(), 3u);
}

TEST(Mesh, SurvivesWhatPatternsHold) {
  filled(pieceOf(sampled({{0, 0}, {40, 0}, {40, 0.001}, {0, 0.001}}, 1)));  // a thread
  filled(pieceOf({{0, 0}, {40, 0}, {40, 0.3}, {0, 0.3}}));                  // a bare strip
  filled(pieceOf(sampled({{0, 0}, {19.8, 0}, {20, 12}, {20.2, 0}, {40, 0}, {40, 20}, {0, 20}}, 1)));
  filled(
      pieceOf(sampled({{0, 0}, {20, 0}, {20.05, 15}, {20.1, 0}, {40, 0}, {40, 20}, {0, 20}}, 1)));
  filled(pieceOf(sampled({{0, 0}, {9, 0}, {9.09, 0}, {20, 0}, {20, 9}, {0, 9}}, 1)));  // 0.09 cm
  filled(pieceOf(sampled({{0, 0}, {30, 0}, {15.05, 1}, {15, 25}, {14.95, 1}}, 1)));    // a spike
}

TEST(Mesh, MakesNoTriangleOfVerticesOnOneStraightEdge) {
  // Turned, so that the vertices of an edge are collinear but for rounding.
  const Mat2 turn = rotation(0.3);
  Polyline outline;
  for (const Vec2& p : sampled({{0, 0}, {30, 0}, {15, 2}}, 0.1)) outline.push_back(turn * p);
  const Piece piece = filled(pieceOf(outline));
  for (const Triangle& t : piece.triangles) EXPECT_GT(area(piece, t), 1e-4);
}

TEST(Mesh, FillsCombsAndStars) {
  Polyline comb;
  for (int k = 0; k < 40; ++k) {
    comb.push_back({0.5 * k, 20});
    comb.push_back({0.5 * k + 0.2, 0.1 * (k % 7)});
  }
  comb.push_back({20, 25});
  comb.push_back({-1, 25});
  filled(pieceOf(sampled(comb, 1)));
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    Polyline star;
    const int n = 5 + round;
    for (int k = 0; k < n; ++k)
      star.push_back((0.2 + 30 * (random() % 1000) / 1000.0) * unit(2 * kPi * k / n));
    if (findCrossing(star)) continue;
    filled(pieceOf(round % 2 == 0 ? star : sampled(star, 1)));
  }
}

TEST(Mesh, NamesAPieceWhoseOutlineCrossesItself) {
  Pattern pattern;
  pattern.pieces = {pieceOf({{0, 0}, {9, 9}, {9, 0}, {0, 9}})};
  const auto outcome = meshed(pattern, 2);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().code, Failure::kMesh);
  EXPECT_NE(outcome.error().message.find("'piece'"), std::string::npos);
}

// --- mirrors ---------------------------------------------------------------------------------

const RigidMotion kAcross = RigidMotion::reflection({0, 0}, {0, 1});

/// A piece symmetric about x = 0 from its right half, bottom to top, both ends on the axis; vertex
/// i of the half mirrors vertex n - i. Noise moves the left half only.
Pattern symmetricPattern(const Polyline& right, double noise) {
  Polyline outline = right;
  std::mt19937 random(3);
  const auto jitter = [&] { return noise * ((random() % 2001) / 1000.0 - 1); };
  for (std::size_t i = right.size() - 1; i-- > 1;)
    outline.push_back(kAcross(right[i]) + Vec2(jitter(), jitter()));
  Pattern pattern;
  pattern.pieces = {pieceOf(outline)};
  const int n = static_cast<int>(outline.size());
  Mirror mirror{{0, 0}, kAcross, {}};
  for (int v = 0; v < n; ++v) mirror.image.push_back((n - v) % n);
  pattern.mirrors = {mirror};
  return pattern;
}

Polyline rightHalf() {
  Polyline half = sampled({{0, 0}, {9, 1}, {14, 20}, {5, 30}, {0, 24}}, 1);
  while (half.back().x() < 0 || (half.back() - Vec2(0, 24)).norm() > 1e-9) half.pop_back();
  return half;
}

void expectMirrored(const Pattern& p, double slack) {
  const auto key = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  for (const Mirror& m : p.mirrors) {
    const Piece &a = p.pieces[m.pieces[0]], &b = p.pieces[m.pieces[1]];
    ASSERT_EQ(m.image.size(), a.rest.size());
    ASSERT_EQ(b.rest.size(), a.rest.size());
    EXPECT_EQ(std::set<int>(m.image.begin(), m.image.end()).size(), b.rest.size());
    std::set<Triangle> triangles;
    for (const Triangle& t : b.triangles) triangles.insert(key(t));
    for (const Triangle& t : a.triangles)
      EXPECT_TRUE(triangles.count(key({m.image[t[0]], m.image[t[2]], m.image[t[1]]})));
    std::size_t boundary = a.outline.size();
    for (const auto& hole : a.holes) boundary += hole.size();
    for (std::size_t v = 0; v < a.rest.size(); ++v)
      EXPECT_LE((m.map(a.rest[v]) - b.rest[m.image[v]]).norm(), v < boundary ? slack : 1e-12);
  }
}

TEST(MirroredMesh, LetsNoTriangleCrossTheAxis) {
  const auto outcome = meshed(symmetricPattern(rightHalf(), 0), 2);
  ASSERT_TRUE(outcome.ok());
  const Piece& p = outcome.value().pieces[0];
  expectFilled(p);
  expectMirrored(outcome.value(), 1e-12);
  for (const Triangle& t : p.triangles) {
    const double x[3] = {p.rest[t[0]].x(), p.rest[t[1]].x(), p.rest[t[2]].x()};
    EXPECT_GE(*std::min_element(x, x + 3) * *std::max_element(x, x + 3), -1e-9);
    EXPECT_GT(smallestAngle(p, t), 20 * kPi / 180);
  }
}

TEST(MirroredMesh, KeepsTheDraftedRestOfANearlySymmetricPiece) {
  const Pattern before = symmetricPattern(rightHalf(), 0.05);
  const auto outcome = meshed(before, 2);
  ASSERT_TRUE(outcome.ok());
  expectFilled(outcome.value().pieces[0]);
  expectMirrored(outcome.value(), 0.08);
  for (std::size_t v = 0; v < before.pieces[0].rest.size(); ++v)
    EXPECT_EQ(outcome.value().pieces[0].rest[v], before.pieces[0].rest[v]);
}

TEST(MirroredMesh, NeverHandsOutATurnedTriangleWhereNoiseExceedsTheFeatures) {
  // A comb of teeth only 0.06 cm apart, drafted with an error of 0.04 cm.
  Polyline right{{0, 0}};
  for (int k = 0; k < 20; ++k) right.push_back({5 + 0.06 * k, k % 2 == 0 ? 0.0 : 5.0});
  right.push_back({9, 0});
  right.push_back({9, 12});
  right.push_back({0, 12});
  const Pattern before = symmetricPattern(right, 0.04);
  const auto outcome = meshed(before, 2);
  ASSERT_TRUE(outcome.ok());
  const Piece& p = outcome.value().pieces[0];
  for (const Triangle& t : p.triangles) EXPECT_GT(area(p, t), 0);
  expectMirrored(outcome.value(), 0.06);
  for (std::size_t v = 0; v < before.pieces[0].rest.size(); ++v)
    EXPECT_LT((p.rest[v] - before.pieces[0].rest[v]).norm(), 0.03);
}

TEST(MirroredMesh, CutsThroughCutOutsOnTheAxisAndSharesTheOthers) {
  Pattern pattern;
  const Polyline outline = sampled({{-15, 0}, {15, 0}, {15, 40}, {-15, 40}}, 1);
  const Polyline low = circle({0, 10}, 3, 20, true), high = circle({0, 25}, 2, 12, true);
  const Polyline right = circle({8, 30}, 2, 13, true);
  Polyline left;
  for (const Vec2& p : right) left.push_back(kAcross(p));
  std::reverse(left.begin(), left.end());
  pattern.pieces = {pieceOf(outline, {low, right, high, left})};
  const auto& rest = pattern.pieces[0].rest;
  Mirror mirror{{0, 0}, kAcross, {}};
  for (const Vec2& p : rest) {
    const auto distance = [&](const Vec2& q) { return (q - kAcross(p)).norm(); };
    const auto image =
        std::min_element(rest.begin(), rest.end(),
                         [&](const Vec2& a, const Vec2& b) { return distance(a) < distance(b); });
    mirror.image.push_back(static_cast<int>(image - rest.begin()));
  }
  pattern.mirrors = {mirror};
  const auto outcome = meshed(pattern, 2);
  ASSERT_TRUE(outcome.ok()) << outcome.error().message;
  expectFilled(outcome.value().pieces[0]);
  expectMirrored(outcome.value(), 1e-9);
}

TEST(MirroredMesh, CarriesTheFirstOfAPairToTheSecond) {
  const RigidMotion map = RigidMotion::reflection({3, -2}, {5, 9});
  const Polyline sleeve = sampled({{0, 0}, {20, 0}, {17, 25}, {9, 31}, {2, 25}}, 1);
  Polyline other;
  for (const Vec2& p : sleeve) other.push_back(map(p));
  std::reverse(other.begin(), other.end());
  Pattern pattern;
  pattern.pieces = {pieceOf(sleeve), pieceOf(other)};
  Mirror mirror{{0, 1}, map, {}};
  const int n = static_cast<int>(sleeve.size());
  for (int v = 0; v < n; ++v) mirror.image.push_back(n - 1 - v);
  pattern.mirrors = {mirror};
  const auto outcome = meshed(pattern, 2);
  ASSERT_TRUE(outcome.ok());
  for (const Piece& p : outcome.value().pieces) expectFilled(p);
  expectMirrored(outcome.value(), 1e-9);
}

TEST(MirroredMesh, RefusesAPieceInTwoSymmetries) {
  Pattern pattern = symmetricPattern(rightHalf(), 0);
  pattern.mirrors.push_back(pattern.mirrors[0]);
  const auto outcome = meshed(pattern, 2);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().piece, 0);
}

TEST(Triangulation, RefusesLoopsThatTouch) {
  const std::vector<Vec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {1, 3}, {1, 1}};
  EXPECT_FALSE(Triangulation::make(square, {{0, 1, 2, 3}, {4, 5, 6}}).has_value());
}

}  // namespace
}  // namespace seamwise
