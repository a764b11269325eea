#include "mesh/mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/triangulation.h"
#include "support/mesh_checks.h"

namespace seamwise {
namespace {

using testing::area;
using testing::circle;
using testing::filled;
using testing::pieceOf;
using testing::sampled;
using testing::smallestAngle;
using testing::Triangle;

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
  // Rotated, so that the vertices of an edge are collinear only up to rounding.
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

TEST(Triangulation, RefusesLoopsThatTouch) {
  const std::vector<Vec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {1, 3}, {1, 1}};
  EXPECT_FALSE(Triangulation::make(square, {{0, 1, 2, 3}, {4, 5, 6}}).has_value());
}

}  // namespace
}  // namespace seamwise
