#include "mesh/mirrored.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "support/mesh_checks.h"

namespace seamwise {
namespace {

using testing::area;
using testing::circle;
using testing::expectFilled;
using testing::pieceOf;
using testing::sampled;
using testing::smallestAngle;
using testing::Triangle;

const RigidMotion kAcross = RigidMotion::reflection({0, 0}, {0, 1});

/// A piece symmetric about x = 0, given by its right half, bottom to top, with both ends on the
/// axis. Vertex i of the half mirrors vertex n - i. Noise moves the left half only.
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
  // A comb with teeth only 0.06 cm apart, drafted with an error of 0.04 cm.
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

}  // namespace
}  // namespace seamwise
