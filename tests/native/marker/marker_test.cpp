#include "marker/marker.h"

#include <gtest/gtest.h>

#include "marker/marker_samples.h"

namespace seamwise {
namespace {

using testing::boundsOf;
using testing::box;
using testing::expectValid;
using testing::groupOf;
using testing::laid;
using testing::moved;
using testing::pieceOf;
using testing::Random;
using testing::someProblem;

WallpaperGroup tiles() { return groupOf("p2", {8, 0}, {0, 6}); }

TEST(Marker, LaysPiecesOfAnyGroupWhereThePrintIsTheirs) {
  for (const GroupData& data : wallpaperGroups()) {
    for (const double turn : {0.0, kPi / 2}) {
      MarkerProblem problem = someProblem(testing::sampleGroup(data, turn), 4, 55, 3);
      problem.phases = {2.3};
      problem.pieces[1].turns = LayTurns::kAny;
      problem.pieces[1].alignment.angle = 0.3;
      problem.pieces[2].turns = LayTurns::kQuarter;
      const auto marker = laid(problem);
      ASSERT_TRUE(marker) << data.name;
      expectValid(problem, *marker);
      EXPECT_NEAR(problem.group.reduce(marker->origin() - Vec2(2.3, marker->origin().y())).x(), 0,
                  1e-9);
    }
  }
}

TEST(Marker, UsesTheShiftsThatFitAsWell) {
  MarkerProblem problem{groupOf("p1", {20, 0}, {0, 20})};
  for (int k = 0; k < 3; ++k) problem.pieces.push_back(pieceOf("bar", box(9.5, 9)));
  problem.width = 40;
  problem.effort = 0.002;
  const auto without = laid(problem);
  for (MarkerPiece& piece : problem.pieces) piece.shifts = {{10, 0}};
  const auto with = laid(problem);
  ASSERT_TRUE(without && with);
  EXPECT_NEAR(without->length(), 29, 1e-6);
  EXPECT_NEAR(with->length(), 9, 1e-6);
  expectValid(problem, *with);
}

TEST(Marker, KeepsPinnedPiecesWhereTheyAre) {
  MarkerProblem problem = someProblem(tiles(), 4, 50, 5);
  problem.start = 1.5;
  problem.phases = {0.7};
  problem.pieces[1].pin = RigidMotion{kPi, {26.123, 51.77}};
  problem.pieces[2].pin = RigidMotion{0.4, {10.5, 30.25}};
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  for (const int k : {1, 2}) {
    const RigidMotion &there = marker->places()[k], &pin = *problem.pieces[k].pin;
    for (const Vec2& p : problem.pieces[k].outline) EXPECT_LT((there(p) - pin(p)).norm(), 1e-6);
  }
  expectValid(problem, *marker);
}

TEST(Marker, LaysPiecesFreelyWithoutRegardToPins) {
  MarkerProblem problem = someProblem(tiles(), 4, 50, 5);
  problem.start = 1.5;
  problem.phases = {0.7};
  problem.also_free = true;
  const auto without = laid(problem);
  problem.pieces[1].pin = RigidMotion{kPi, {26.123, 51.77}};
  const auto with = laid(problem);
  ASSERT_TRUE(without && with);
  EXPECT_GT(with->length(), without->length() + 1);
  EXPECT_EQ(with->freeLength(), without->freeLength());
}

TEST(Marker, KeepsPinnedPiecesWhereTheyAreWithoutAPrintToo) {
  MarkerProblem problem = someProblem(tiles(), 3, 50, 5);
  problem.start = 1.5;
  problem.phases = {0.7};
  problem.ignores_print = true;
  problem.pieces[1].pin = RigidMotion{kPi, {26.123, 51.77}};
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  EXPECT_LT((marker->places()[1].shift - problem.pieces[1].pin->shift).norm(), 1e-6);
}

TEST(Marker, LaysNothingOnFlaws) {
  MarkerProblem problem = someProblem(tiles(), 4, 44, 6);
  problem.start = 0;
  const auto without = laid(problem);
  problem.flaws = {{{0, 10}, {44, 14}, {44, 15}, {0, 11}}, {{20, 0}, {21, 0}, {21, 60}, {20, 60}}};
  const auto marker = laid(problem);
  ASSERT_TRUE(without && marker);
  expectValid(problem, *marker);
  EXPECT_GT(marker->length(), without->length());
}

/// Returns whether a piece's grain line points up the fabric.
bool isUp(const MarkerPiece& piece, const RigidMotion& place) {
  return (place(piece.up) - place(Vec2::Zero())).y() > 0;
}

TEST(Marker, KeepsTheNapOfAGarmentOrOfAll) {
  MarkerProblem problem = someProblem(tiles(), 6, 50, 7);
  problem.pieces[3].up = {0, -1};
  for (const Nap nap : {Nap::kGarment, Nap::kOneWay}) {
    problem.nap = nap;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    expectValid(problem, *marker);
    for (std::size_t k = 0; k < 6; ++k) {
      const bool up = isUp(problem.pieces[k], marker->places()[k]);
      EXPECT_EQ(up, nap == Nap::kOneWay || isUp(problem.pieces[k % 2], marker->places()[k % 2]));
    }
  }
}

TEST(Marker, TurnsQuartersOnlyWhereAPieceMay) {
  MarkerProblem problem{groupOf("p4", {10, 0}, {0, 10})};
  problem.pieces = {pieceOf("long", box(9, 39))};
  problem.width = 41;
  problem.effort = 0.002;
  for (const LayTurns turns : {LayTurns::kHalf, LayTurns::kQuarter, LayTurns::kAny}) {
    problem.pieces[0].turns = turns;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    EXPECT_NEAR(marker->length(), turns == LayTurns::kHalf ? 39 : 9, 1e-6);
  }
}

TEST(Marker, RoundsUpToWholeRepeats) {
  MarkerProblem problem = someProblem(groupOf("cmm", {6, -4}, {6, 4}), 4, 44, 8);
  const auto plain = laid(problem);
  problem.whole_repeats = true;
  const auto whole = laid(problem);
  ASSERT_TRUE(plain && whole);
  const double repeats = whole->length() / 8;  // 8 cm along the warp
  EXPECT_NEAR(repeats, std::round(repeats), 1e-9);
  EXPECT_GE(whole->length(), plain->bound() - 1e-6);
  EXPECT_LE(whole->length(), plain->length() + 8);
  const auto& places = whole->places();
  double top = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
    top = std::max(top, boundsOf(moved(problem.pieces[k].outline, places[k])).second.y());
  EXPECT_LE(top, whole->length() + 1e-6);
}

TEST(Marker, IsTheSameWhereverAnAlignmentsRepeatIsCountedFromAndHoweverPiecesAreNamed) {
  for (const char* name : {"p2", "pgg", "cmm", "p6m"}) {
    const GroupData* data = findGroup(name);
    MarkerProblem problem = someProblem(testing::sampleGroup(*data), 4, 50, 9);
    const auto before = laid(problem);
    Random random(10);
    for (MarkerPiece& piece : problem.pieces) {
      const double i = std::round(random.between(-4, 4)), j = std::round(random.between(-4, 4));
      piece.alignment.shift +=
          piece.alignment.linear() * (i * problem.group.w1() + j * problem.group.w2());
      piece.name += " of another name";
    }
    const auto after = laid(problem);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->length(), before->length(), 1e-6) << name;
  }
}

TEST(Marker, LaysPiecesAnywhereWhereThePrintDoesNotMatter) {
  for (unsigned seed = 20; seed < 24; ++seed) {
    MarkerProblem problem = someProblem(tiles(), 8, 50, seed);
    problem.ignores_print = true;
    problem.effort = 0.05;
    const auto marker = laid(problem);
    ASSERT_TRUE(marker);
    expectValid(problem, *marker);
  }
}

TEST(Marker, TakesTheSameWithoutThePrintWhateverOfItAPieceShows) {
  MarkerProblem problem = someProblem(tiles(), 6, 50, 9);
  problem.ignores_print = true;
  problem.effort = 0.05;
  const auto before = laid(problem);
  Random random(10);
  for (MarkerPiece& piece : problem.pieces) {
    const double turn = random.between(0, 1) < 0.5 ? 0 : kPi;
    piece.alignment = {turn, {random.between(-9, 9), random.between(-9, 9)}, false};
  }
  const auto after = laid(problem);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->length(), before->length());
}

TEST(Marker, GivesTheSamePlanTwice) {
  MarkerProblem problem = someProblem(tiles(), 6, 50, 11);
  problem.phases = {0, 2.5};
  const auto first = laid(problem), second = laid(problem);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->places(), second->places());
  EXPECT_EQ(first->phaseLengths(), second->phaseLengths());
  // the result is independent of the size of the steps
  auto other = Marker::make(problem);
  ASSERT_TRUE(other.ok());
  while (other.value()->advance(0.01)) continue;
  EXPECT_EQ(other.value()->places(), first->places());
}

TEST(Marker, StopsAtTheFirstLayoutWithoutEffort) {
  MarkerProblem problem = someProblem(tiles(), 6, 50, 12);
  const auto sought = laid(problem);
  problem.effort = 0;
  const auto first = laid(problem);
  ASSERT_TRUE(sought && first);
  EXPECT_EQ(first->count(), 1);
  EXPECT_FALSE(first->isProven());
  EXPECT_EQ(first->fraction(), 1);
  EXPECT_GE(first->length(), sought->length());
  expectValid(problem, *first);
}

TEST(Marker, ChoosesTheBestOfSeveralPhases) {
  MarkerProblem problem{groupOf("p1", {20, 0}, {0, 20})};
  problem.pieces = {pieceOf("left", box(18, 5), {0, {0, 0}}),
                    pieceOf("right", box(18, 5), {0, {19, 1}})};
  problem.width = 39;
  problem.effort = 0.002;
  problem.phases = {7, 1, 0};  // phase 0: from 0 to 37; phase 1: from 1 to 38
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  EXPECT_NEAR(marker->length(), 6, 1e-6);
  ASSERT_EQ(marker->phaseLengths().size(), 3u);
  EXPECT_GT(marker->phaseLengths()[0], 10);
  EXPECT_NEAR(marker->phaseLengths()[2], 6, 1e-6);
  expectValid(problem, *marker);
}

TEST(Marker, IsNeverMuchLongerOnWiderFabric) {
  MarkerProblem problem = someProblem(groupOf("p2", {5, 0}, {0, 5}), 6, 50, 13);
  problem.effort = 0.01;
  problem.also_free = true;
  problem.widths = {40, 45, 50, 60, 70, 80};
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  const std::vector<double>& lengths = marker->widthLengths();
  ASSERT_EQ(lengths.size(), 6u);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_LE(lengths[k], 1.005 * lengths[k - 1]) << k;
  EXPECT_EQ(lengths[2], marker->length());
  EXPECT_GT(marker->freeLength(), 10);
  EXPECT_LE(marker->freeLength(), marker->length());
}

TEST(Marker, OffersPlacesThatAreFree) {
  MarkerProblem problem = someProblem(groupOf("pgg", {7, 0}, {0, 5}), 4, 40, 14);
  problem.start = 0;
  problem.flaws = {{{20, 20}, {22, 20}, {22, 22}, {20, 22}}};
  const auto marker = laid(problem);
  ASSERT_TRUE(marker);
  int count = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    for (const RigidMotion& place : marker->freePlaces(static_cast<int>(k))) {
      ++count;
      const Polyline ring = moved(problem.pieces[k].outline, place);
      EXPECT_TRUE(testing::showsPrint(problem, problem.pieces[k], place, marker->origin()));
      EXPECT_GT(boundsOf(ring).first.x(), 1 - 1e-4);
      EXPECT_LT(boundsOf(ring).second.x(), 39 + 1e-4);
      EXPECT_GE(testing::separation(problem.flaws[0], ring), 0);
      for (std::size_t other = 0; other < 4; ++other) {
        if (other == k) continue;
        EXPECT_TRUE(testing::areApart(moved(problem.pieces[other].outline, marker->places()[other]),
                                      ring, problem.gap, 0.008));
      }
    }
  }
  EXPECT_GT(count, 4);  // more than their actual places
}

}  // namespace
}  // namespace seamwise
