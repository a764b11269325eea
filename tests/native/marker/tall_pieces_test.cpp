#include <gtest/gtest.h>

#include <array>

#include "marker/marker_enumeration.h"
#include "marker/marker_samples.h"
#include "support/level.h"

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
      groupOf("p2", {5, 0}, {0, 4}),
      groupOf("cmm", {4, -2}, {4, 2}),
      groupOf("p1", {4, 0}, {2, 4}),
      groupOf("p6", {8, 0}, 8 * unit(kPi / 3)),
      groupOf("p4", {8, 0}, {0, 8}),
      groupOf("p2", {5, 0}, {1.25, 4}),  // the print repeats straight up after 16 cm
  };
  return groups[static_cast<std::size_t>(k) % groups.size()];
}

/// A long piece with a bulge and a notch at random places, so that neighbours interlock.
Polyline longPiece(Random& random) {
  const double wide = random.between(2, 5), high = random.between(14, 17);
  const double at = random.between(2, 10), by = random.between(0.5, 3);
  const double notch = random.between(0.3, 0.7) * wide;
  return {{0, 0},       {wide, 0}, {wide, at},    {wide + by, at + 1}, {wide, at + 3},
          {wide, high}, {0, high}, {0, at + 2.5}, {notch, at + 1.5},   {0, at}};
}

/// Three or four long pieces and a short one, on fabric that is hardly wide enough.
MarkerProblem longPieces(int k) {
  MarkerProblem problem{someGroup(k)};
  Random random(500 + k);
  const int count = 3 + k % 2;
  for (int n = 0; n < count; ++n) {
    problem.pieces.push_back(pieceOf(
        "long", longPiece(random), {n % 2 * kPi, {random.between(0, 20), random.between(0, 20)}}));
    problem.pieces.back().garment = n % 2;
  }
  if (k % 5 == 0) problem.pieces[2] = problem.pieces[0];
  if (k % 7 == 0) problem.pieces[1] = problem.pieces[0];
  if (count == 3) {
    problem.pieces.push_back(
        pieceOf("short", box(3, 2), {kPi, {random.between(0, 8), random.between(0, 8)}}));
    problem.pieces.back().garment = 1;
  }
  if (k % 6 == 4)
    for (MarkerPiece& piece : problem.pieces) piece.turns = LayTurns::kQuarter;
  if (k % 6 == 3)
    for (MarkerPiece& piece : problem.pieces) piece.turns = LayTurns::kAny;
  problem.width = random.between(4.5, 6.5) * count;
  problem.selvedge = k % 3 * 0.3;
  problem.gap = k % 4 == 1 ? 0.3 : 0;
  problem.repeat_tolerance = k % 4 == 3 ? 0.01 : 0;
  problem.phases = {random.between(0, 5)};
  problem.effort = 0.003;
  return problem;
}

/// Expects the search to agree with brute force, at lengths that put long pieces side by side.
/// @returns whether there is a layout
bool expectSame(const MarkerProblem& problem, double longest, const std::string& what) {
  const double shortest = Enumeration(problem, longest).length();
  const double found = completely(problem, longest - 1e-5);
  if (shortest < longest - 2e-5) {
    EXPECT_NEAR(found, shortest, 1e-4) << what;
    return true;
  }
  EXPECT_EQ(found, kNowhere) << what;
  return false;
}

TEST(TallPieces, LieSideBySideAsShortAsInAnyLayout) {
  int found = 0;
  const int all = testing::cases(12, 90);
  for (int k = 0; k < all; ++k) found += expectSame(longPieces(k), 27, std::to_string(k)) ? 1 : 0;
  EXPECT_GT(found, all / 4);
  EXPECT_LT(found, all - all / 9);
}

TEST(TallPieces, LieSideBySideFromACutWithFlawsAndPins) {
  int found = 0;
  const int all = testing::cases(12, 90);
  for (int k = 0; k < all; ++k) {
    MarkerProblem problem = longPieces(k);
    Random random(900 + k);
    problem.start = random.between(0, 4);
    const double x = random.between(1, problem.width - 2), y = random.between(0, 20);
    if (k % 2 == 0) problem.flaws = {{{x, y}, {x + 0.5, y}, {x + 0.5, y + 1}, {x, y + 1}}};
    if (k % 3 == 0) {
      const double right = problem.width - problem.selvedge - 8.1;
      problem.pieces[1].pin = RigidMotion{
          0, {random.between(problem.selvedge, std::max(problem.selvedge, right)), 1.37}};
    }
    found += expectSame(problem, 27, std::to_string(k)) ? 1 : 0;
  }
  EXPECT_GT(found, all / 5);
  EXPECT_LT(found, all - all / 9);
}

TEST(TallPieces, KeepTheNapOfTheirGarments) {
  int found = 0;
  const int all = testing::cases(8, 40);
  for (int k = 0; k < all; ++k) {
    MarkerProblem problem = longPieces(k);
    problem.nap = Nap::kGarment;
    found += expectSame(problem, 27, std::to_string(k)) ? 1 : 0;
  }
  EXPECT_GT(found, all / 4);
  EXPECT_LT(found, all);
}

TEST(TallPieces, AreProvenInAllWaysThatTheirGarmentsMayBeTurned) {
  int proven = 0;
  const int all = testing::cases(4, 12);
  for (int k = 0; k < all; ++k) {
    MarkerProblem problem = longPieces(k);
    problem.nap = Nap::kGarment;
    problem.width += 4;
    // four garments have more combinations of turns than the search tries at first
    for (std::size_t n = 0; n < 4; ++n) problem.pieces[n].garment = k % 2 ? n : n % 2;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker) << k;
    expectValid(problem, *marker);
    for (std::size_t n = 0; n < 4; ++n) {
      const auto is_up = [&](std::size_t piece) {
        return std::cos(marker->places()[piece].angle) > -1e-6;
      };
      if (k % 2 == 0 && problem.pieces[n].turns == LayTurns::kHalf) {
        EXPECT_EQ(is_up(n), is_up(n % 2)) << k;
      }
    }
    const double shortest = Enumeration(problem, marker->length() + 1).length();
    EXPECT_GE(marker->length(), shortest - 1e-4) << k;
    EXPECT_LE(marker->bound(), shortest + 1e-4) << k;
    if (!marker->isProven()) continue;
    ++proven;
    EXPECT_LE(marker->length(), shortest + 0.01 + 1e-4) << k;
  }
  EXPECT_GE(proven, all - all / 6);
}

TEST(TallPieces, AreProvenBesidePins) {
  MarkerProblem problem = longPieces(0);
  problem.start = 0.5;
  problem.pieces[3].pin = RigidMotion{0.3, {10.3, 1.7}};
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  expectValid(problem, *marker);
  EXPECT_TRUE(marker->isProven());
  EXPECT_NEAR(marker->length(), Enumeration(problem, marker->length() + 1).length(), 0.011);
}

}  // namespace
}  // namespace seamwise
