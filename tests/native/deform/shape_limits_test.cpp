#include "deform/shape_limits.h"

#include <gtest/gtest.h>

#include "io/problem_json.h"
#include "problem/prepare.h"
#include "support/garment_texts.h"
#include "support/mesh_checks.h"

namespace seamwise {
namespace {

/// A square of 4 cm, outline edges 1 cm: vertices 0 to 4 along its lower side.
Piece square() {
  return testing::filled(testing::pieceOf(testing::sampled({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1)));
}

/// The limit that the square exceeds when the middle of its lower side moves by `by`.
BrokenLimit moved(const Vec2& by, ShapeLimits limits = {}) {
  const Piece piece = square();
  std::vector<Vec2> shape = piece.rest;
  shape[2] += by;
  return brokenLimit(piece, shape, limits);
}

TEST(ShapeLimits, HoldsAtRest) {
  ShapeLimits nothing{0, 0, 0, 1};
  EXPECT_EQ(moved({0, 0}, nothing), BrokenLimit::kNone);
}

TEST(ShapeLimits, BoundsMovementKinksAndStretch) {
  EXPECT_EQ(moved({0.1, 0}), BrokenLimit::kNone);
  EXPECT_EQ(moved({0.2, 0}), BrokenLimit::kStretch);  // stretched by 20 %
  ShapeLimits limits;
  limits.moved = 0.09;
  EXPECT_EQ(moved({0.1, 0}, limits), BrokenLimit::kMoved);
  EXPECT_EQ(moved({0, -0.12}), BrokenLimit::kNone);  // 2 atan 0.12 = 13.7 degrees
  EXPECT_EQ(moved({0, -0.14}), BrokenLimit::kKink);  // 16 degrees
}

TEST(ShapeLimits, LetsCornersBend) {
  const Piece piece = square();
  std::vector<Vec2> shape = piece.rest;
  for (Vec2& p : shape) p.x() += 0.3 * p.y();  // corners of 73 and 107 degrees
  ShapeLimits limits;
  limits.moved = 2;
  EXPECT_EQ(brokenLimit(piece, shape, limits), BrokenLimit::kNone);
}

TEST(ShapeLimits, RefusesTurnedTrianglesAndOutlinesThatCross) {
  ShapeLimits any{10, 10, 10, 0.3};
  EXPECT_EQ(moved({0, 3.5}, any), BrokenLimit::kArea);
  any.area = -100;
  EXPECT_EQ(moved({0, 5}, any), BrokenLimit::kCrossing);
}

TEST(SeamError, IsTheWorstEdgeOrAllOfThemTogether) {
  Seam seam;
  seam.a = {0, {0, 1, 2}};
  seam.b = {1, {0, 1, 2}};
  seam.length_ratio = 2;
  const std::vector<Vec2> b{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_NEAR(seamError(seam, {{{0, 0}, {2, 0}, {4, 0}}, b}), 0, 1e-12);
  EXPECT_NEAR(seamError(seam, {{{0, 0}, {2.1, 0}, {4, 0}}, b}), 0.1, 1e-12);
  EXPECT_NEAR(seamError(seam, {{{0, 0}, {2.1, 0}, {4.2, 0}}, b}), 0.2, 1e-12);
}

// --- limits of a prepared problem --------------------------------------------------------------

/// Two rectangles; the front's upper right corner is shifted to the left.
ProblemTexts leaning(double by, const char* symmetry, const char* options) {
  Json garment = testing::twoRectangles();
  testing::panelOf(garment, "front")["vertices"][2][0] = 10 - by;
  garment["pattern"]["stitches"] = Json::array();
  ProblemTexts texts;
  texts.garment = garment.dump();
  texts.print = R"({"group": "pm", "w1": [10, 0], "w2": [0, 12]})";
  texts.symmetry = symmetry;
  texts.options = options;
  return texts;
}

constexpr const char* kFrontOnly = R"({"symmetries": [{"kind": "piece", "piece": "front"}]})";

TEST(Prepared, EvensOutANearlySymmetricPieceExactly) {
  const Problem problem = makeProblem(leaning(0.08, kFrontOnly, "")).value();
  const Pattern pattern = prepared(problem).value().pattern;
  ASSERT_EQ(pattern.mirrors.size(), 1u);
  const Mirror& m = pattern.mirrors[0];
  const Shapes evened = evenedShapes(pattern);
  for (std::size_t v = 0; v < m.image.size(); ++v)
    EXPECT_LT((m.map(evened[0][v]) - evened[0][m.image[v]]).norm(), 1e-12);
  EXPECT_GT(pieceMovement(pattern.pieces[0], evened[0]), 0.005);
  EXPECT_LT(pieceMovement(pattern.pieces[0], evened[0]), 0.08);
  EXPECT_EQ(evened[1], pattern.pieces[1].rest);
}

TEST(Prepared, DropsADetectedSymmetryThatNeedsMoreThanTheGreatestChange) {
  const Problem problem = makeProblem(leaning(0.08, "auto", R"({"maxChangeCm": 0.001})")).value();
  ASSERT_FALSE(problem.symmetries.imposed.empty());
  const Prepared made = prepared(problem).value();
  EXPECT_LT(made.symmetries.imposed.size(), problem.symmetries.imposed.size());
  ASSERT_FALSE(made.notes.empty());
  EXPECT_NE(made.notes.back().text.find("'front'"), std::string::npos);
  EXPECT_NE(made.notes.back().text.find("maxChangeCm"), std::string::npos);
}

TEST(Prepared, RefusesToDropASymmetryThatWasAskedFor) {
  const Problem problem =
      makeProblem(leaning(0.08, kFrontOnly, R"({"maxChangeCm": 0.001})")).value();
  testing::expectError(prepared(problem), Failure::kSymmetryDoesNotMirror,
                       {"'front'", "raise maxChangeCm to 0.0", "leave out that symmetry"});
}

TEST(Prepared, KeepsAnExactSymmetryThatMayNotMove) {
  const Problem problem = makeProblem(leaning(0, kFrontOnly, R"({"maxChangeCm": 0})")).value();
  EXPECT_EQ(prepared(problem).value().pattern.mirrors.size(), 1u);
}

}  // namespace
}  // namespace seamwise
