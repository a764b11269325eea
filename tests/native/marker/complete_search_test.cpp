#include <gtest/gtest.h>

#include <array>

#include "marker/layout_search.h"
#include "marker/marker_enumeration.h"
#include "marker/marker_samples.h"

namespace seamwise {
namespace {

using testing::box;
using testing::completely;
using testing::Enumeration;
using testing::expectValid;
using testing::groupOf;
using testing::kNowhere;
using testing::laid;
using testing::pieceOf;
using testing::Random;

const WallpaperGroup& someGroup(int k) {
  static const std::array groups{
      groupOf("p2", {9, 0}, {0, 8}),
      groupOf("cmm", {8, -4}, {8, 4}),
      groupOf("p1", {9, 0}, {4.5, 4}),
      groupOf("p6", {9, 0}, 9 * unit(kPi / 3)),
      groupOf("pgg", {7, 0}, {0, 8}),
      groupOf("p2", {9, 0}, {3, 8}),  // the print repeats straight up after 24 cm
  };
  return groups[static_cast<std::size_t>(k) % groups.size()];
}

/// A few pieces on fabric that is hardly wide enough for two.
MarkerProblem fewPieces(int k) {
  MarkerProblem problem{someGroup(k)};
  Random random(100 + k);
  const int count = 2 + k % 3;
  for (int n = 0; n < count; ++n) {
    const Polyline outline = n == 1 ? testing::comb(random, 2) : testing::star(random, 6, 2.5, 6);
    problem.pieces.push_back(
        pieceOf("piece", outline, {n % 2 * kPi, {random.between(0, 20), random.between(0, 20)}}));
  }
  problem.width = 24;
  problem.selvedge = 0.5;
  problem.gap = k % 2 ? 0.3 : 0;
  problem.phases = {random.between(0, 9)};
  problem.effort = 0.003;
  return problem;
}

TEST(CompleteSearch, FindsTheShortestOfAllLayouts) {
  for (int k = 0; k < 12; ++k) {
    MarkerProblem problem = fewPieces(k);
    if (k >= 6) problem.start = 0.1 * k;
    const double found = completely(problem, 40);
    EXPECT_LT(found, 40) << k;
    EXPECT_NEAR(found, Enumeration(problem, 40).length(), 1e-4) << k;
  }
}

TEST(CompleteSearch, LooksAtEqualPiecesOnceButFindsTheirBest) {
  for (int k = 0; k < 6; ++k) {
    MarkerProblem problem = fewPieces(k);
    problem.pieces.resize(2);
    problem.pieces.push_back(problem.pieces[0]);
    if (k < 3) problem.pieces.push_back(problem.pieces[0]);
    const double found = completely(problem, 50);
    EXPECT_NEAR(found, Enumeration(problem, 50).length(), 1e-4) << k;
  }
}

TEST(CompleteSearch, FindsNothingBelowTheShortest) {
  MarkerProblem problem = fewPieces(1);
  const double shortest = Enumeration(problem, 40).length();
  EXPECT_EQ(completely(problem, shortest - 0.01), kNowhere);
  EXPECT_NEAR(completely(problem, shortest), shortest, 1e-4);
}

TEST(MarkerProof, IsOfTheShortestOfAllLayouts) {
  int proven = 0;
  for (int k = 0; k < 18; ++k) {
    MarkerProblem problem = fewPieces(k);
    if (k % 5 == 0) problem.start = 0.7;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker) << k;
    expectValid(problem, *marker);
    const double shortest = Enumeration(problem, marker->length() + 1).length();
    EXPECT_GE(marker->length(), shortest - 1e-4) << k;
    EXPECT_LE(marker->bound(), shortest + 1e-4) << k;
    if (!marker->isProven()) continue;
    ++proven;
    EXPECT_LE(marker->length(), shortest + 0.01 + 1e-4) << k;  // the search skips smaller gains
  }
  EXPECT_GE(proven, 15);
}

TEST(MarkerProof, IsMadeOnLatticesHoweverTheyAreTurned) {
  for (const double angle : {0.0, kPi / 3, kPi / 2, 2 * kPi / 3}) {
    MarkerProblem problem = fewPieces(0);
    problem.group = groupOf("p6", 9 * unit(angle), 9 * unit(angle + kPi / 3));
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    EXPECT_TRUE(marker->isProven()) << angle;
    EXPECT_NEAR(marker->length(), Enumeration(problem, marker->length() + 1).length(), 0.011);
  }
}

TEST(MarkerProof, HoldsOnPrintsThatRepeatMoreOftenThanPiecesAreTried) {
  for (const double repeat : {0.2, 0.3, 0.45}) {
    MarkerProblem problem{groupOf("p1", {9, 0}, {0, repeat})};
    problem.pieces = {pieceOf("a", box(7, 5), {0, {0, 0}}),
                      pieceOf("b", box(8, 3.1), {0, {1, 0.1}}),
                      pieceOf("c", {{0, 0}, {6, 0}, {0, 7}}, {0, {0, 0.15}})};
    problem.width = 17.5;
    problem.effort = 0.003;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    expectValid(problem, *marker);
    const double shortest = Enumeration(problem, marker->length() + 1e-3).length();
    EXPECT_LE(marker->bound(), shortest + 1e-4) << repeat;
    if (marker->isProven()) {
      EXPECT_NEAR(marker->length(), shortest, 0.011) << repeat;
    }
  }
}

TEST(MarkerProof, EndsWhereLengthsAreWholeTenthsOfAMillimetre) {
  // gains equal to the least one that the search looks for, up to rounding
  for (unsigned seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const auto tenths = [&](double low, double high) {
      return std::round(100 * random.between(low, high)) / 100;
    };
    MarkerProblem problem{groupOf("p2", {10, 0}, {0, 5})};
    for (int k = 0; k < 4; ++k) {
      const double width = tenths(3, 9), height = tenths(3, 9);
      const Vec2 shift(tenths(0, 10), 0.01 * std::round(random.between(0, 4)));
      problem.pieces.push_back(pieceOf("box", box(width, height), {0, shift}));
    }
    problem.width = 33;
    problem.effort = 0.002;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker) << seed;
    expectValid(problem, *marker);
  }
}

TEST(MarkerProof, IsOfPiecesThatAreTallerOneWayThanTheOther) {
  MarkerProblem problem{groupOf("p4", {6, 0}, {0, 6})};
  problem.pieces = {pieceOf("facing", box(21, 4)), pieceOf("pocket", box(5, 5))};
  problem.width = 18;
  problem.effort = 0.002;
  for (MarkerPiece& piece : problem.pieces) piece.turns = LayTurns::kQuarter;
  for (int count = 1; count < 3; ++count) {
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    EXPECT_TRUE(marker->isProven());
    EXPECT_NEAR(marker->length(), 21, 1e-4);
    expectValid(problem, *marker);
    problem.pieces.pop_back();
  }
}

TEST(LayoutSearch, FindsShorterAndShorterLayouts) {
  MarkerProblem problem = fewPieces(2);
  PiecesOnBoard pieces(problem, false);
  while (pieces.makeTable()) continue;
  LayFabric fabric;
  fabric.left = problem.selvedge;
  fabric.right = problem.width - problem.selvedge;
  fabric.origin = {problem.phases[0], 0};
  LayoutSearch search(pieces, fabric, 1);
  EXPECT_FALSE(search.best());
  double before = kNowhere;
  const auto look = [&] {
    if (!search.best()) return;
    EXPECT_LE(search.best()->length(), before);
    before = search.best()->length();
  };
  while (search.construct()) look();
  for (int k = 0; k < 300 && search.improve(); ++k) look();
  EXPECT_GT(search.reads(), 100);
  EXPECT_NEAR(before, Enumeration(problem, before + 1).length(), 0.011);
}

}  // namespace
}  // namespace seamwise
