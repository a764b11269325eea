#include "marker/difference_table.h"

#include <gtest/gtest.h>

#include "marker/marker_outlines.h"

namespace seamwise {
namespace {

using testing::box;
using testing::Random;
using testing::shifted;

Shape asShape(const Polyline& ring) { return shapeOf(ring, Mat2::Identity()); }

const Spacing kExactly{0, 0, true};

DifferenceTable tableOf(const Polyline& first, const Polyline& second, double step,
                        const Spacing& spacing = kExactly, const Vec2& offset = Vec2::Zero()) {
  return {asShape(first), asShape(second), offset, Board::square(step), spacing};
}

std::vector<Board> someBoards() {
  return {Board::ofLattice({3, 0}, {0, 2.2}, 0.5),
          Board::ofLattice(4 * unit(0), 4 * unit(kPi / 3), 0.5),
          Board::ofLattice({2.5, 0.9}, {-1.1, 3.1}, 0.5), Board::ofLattice({3, -2}, {3, 2}, 0.5)};
}

/// Visits all dots at which the shapes' boxes may be near each other, and some more.
template <class Each>
void forDots(const Polyline& a, const Polyline& b, const Vec2& offset, const Board& board,
             double gap, Each each) {
  const auto [low, high] = testing::boundsOf(a);
  const auto [low_b, high_b] = testing::boundsOf(b);
  const Vec2 from = low - high_b - Vec2::Constant(gap + 3);
  const Vec2 to = high - low_b + Vec2::Constant(gap + 3);
  for (int j = -40; j <= 40; ++j) {
    for (int i = -40; i <= 40; ++i) {
      const Vec2 d = offset + board.shift({i, j});
      if ((d.array() > from.array()).all() && (d.array() < to.array()).all()) each(Dot{i, j}, d);
    }
  }
}

TEST(DifferenceTable, IsFreeWherePolygonsAreAGapApartAndOnlyThere) {
  Random random(1);
  int free = 0, forbidden = 0;
  for (int times = 0; times < 24; ++times) {
    const Polyline a = times % 2 ? testing::comb(random, 3) : testing::star(random, 9, 2, 7);
    const Polyline b = times % 3 ? testing::star(random, 12, 2, 5) : testing::comb(random, 2);
    const double gap = times % 4 < 2 ? 0 : 0.4;
    const Board board = someBoards()[times / 2 % 4];
    const Vec2 offset(random.between(0, 2), random.between(0, 2));
    const DifferenceTable table(asShape(a), asShape(b), offset, board, {gap, 0, true});
    forDots(a, b, offset, board, gap, [&](Dot dot, const Vec2& d) {
      const double apart = testing::separation(a, shifted(b, d));
      const bool is_free = table.depth(dot) == 0;
      if (apart >= gap && apart > 0) {
        ++free;
        EXPECT_TRUE(is_free) << times << ": " << apart << " apart at " << d.transpose();
      } else if (!testing::areApart(a, shifted(b, d), gap, 4 * kTouching)) {
        ++forbidden;
        EXPECT_FALSE(is_free) << times << ": " << apart << " apart at " << d.transpose();
      }
    });
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(forbidden, 300);
}

TEST(DifferenceTable, LetsLongEdgesTouchWithoutAGapButNotOverlapByAHair) {
  const Polyline band = {{0, 0}, {60, 0}, {60, 4}, {0, 4}};
  for (const double hair : {0.0, 1e-4, 1e-3}) {
    const Board board = Board::ofLattice({70, 0}, {0, 4 - hair}, 0.5);
    const DifferenceTable table(asShape(band), asShape(band), Vec2::Zero(), board, {0, 0, true});
    EXPECT_EQ(table.depth({0, 1}) == 0, hair == 0) << hair;
    EXPECT_EQ(table.depth({0, -1}) == 0, hair == 0) << hair;
    EXPECT_EQ(table.depth({1, 0}), 0);
  }
}

TEST(DifferenceTable, OnFineBoardsForbidsAllOverlapsAndHardlyMore) {
  Random random(2);
  for (int times = 0; times < 4; ++times) {
    const Polyline a = testing::star(random, 9, 2, 5), b = testing::comb(random, 2);
    const double gap = times % 2 ? 0.3 : 0;
    const DifferenceTable table = tableOf(a, b, 0.7, {gap, 0, false});
    forDots(a, b, Vec2::Zero(), Board::square(0.7), gap, [&](Dot dot, const Vec2& d) {
      const Polyline there = shifted(b, d);
      if (testing::separation(a, there) > gap + 0.3) {
        EXPECT_EQ(table.depth(dot), 0);
      }
      if (table.depth(dot) == 0) {
        EXPECT_TRUE(testing::areApart(a, there, gap, 4 * kTouching));
      }
    });
  }
}

TEST(DifferenceTable, ReversedIsThatOfTheSecondShapeAndTheFirst) {
  Random random(3);
  for (const Board& board : someBoards()) {
    const Shape a = asShape(testing::star(random, 8, 2, 7)), b = asShape(testing::comb(random, 3));
    const Vec2 offset(random.between(0, 2), random.between(0, 2));
    const DifferenceTable table(a, b, offset, board, {0.2, 0, true});
    const DifferenceTable reversed = table.reversed(), other(b, a, -offset, board, {0.2, 0, true});
    for (int j = -20; j <= 20; ++j) {
      for (int i = -20; i <= 20; ++i) {
        EXPECT_EQ(reversed.depth({-i, -j}), table.depth({i, j}));
        EXPECT_EQ(other.depth({-i, -j}) > 0, table.depth({i, j}) > 0);
      }
    }
  }
}

TEST(DifferenceTable, IsDeeperWhereShapesOverlapMore) {
  const DifferenceTable table = tableOf(box(8, 8), box(8, 8), 1);
  int before = 60001;
  for (int i = 0; i <= 8; ++i) {
    EXPECT_LT(table.depth({i, 0}), before);
    before = table.depth({i, 0});
  }
  EXPECT_NEAR(table.depth({3, 0}), 500, 2);  // hundredths of a centimetre to the nearer end
  EXPECT_NEAR(table.depth({6, -5}), 200, 2);
}

TEST(DifferenceTable, LetsRectanglesTouchButNotOverlapByATenthOfAMillimetre) {
  for (const double height : {10.0, 3.0}) {
    const Polyline whole = box(10, height), more = box(10.01, height);
    const Dot right{10, 0}, left{-10, 0};
    EXPECT_EQ(tableOf(whole, whole, 1).depth(right), 0);
    EXPECT_EQ(tableOf(whole, whole, 1).depth(left), 0);
    EXPECT_EQ(tableOf(whole, whole, 1).depth({0, static_cast<int>(height)}), 0);
    EXPECT_GT(tableOf(whole, whole, 1).depth({9, 0}), 0);
    EXPECT_GT(tableOf(more, whole, 1).depth(right), 0);
    EXPECT_EQ(tableOf(more, whole, 1).depth(left), 0);
    EXPECT_GT(tableOf(whole, more, 1).depth(left), 0);
  }
  // exactly the required gap apart, and a little less
  EXPECT_EQ(tableOf(box(9.5, 4), box(9.5, 4), 1, {0.5, 0, true}).depth({10, 0}), 0);
  EXPECT_GT(tableOf(box(9.51, 4), box(9.5, 4), 1, {0.5, 0, true}).depth({10, 0}), 0);
}

TEST(DifferenceTable, SeesOverlapsAlongCommonLines) {
  const Spacing spacing{0, 0, true};
  for (const double size : {8.0, 2.0}) {
    const Polyline square = box(size, size);
    for (const double by : {0.05, -0.05, 0.5}) {
      EXPECT_GT(tableOf(square, square, 20, spacing, {by, 0}).depth({0, 0}), 0);
      EXPECT_GT(tableOf(square, square, 20, spacing, {0, by}).depth({0, 0}), 0);
    }
    EXPECT_GT(tableOf(square, square, 20).depth({0, 0}), 0);
  }
  // one within the other, with a common side
  EXPECT_GT(tableOf(box(8, 8), box(4, 8), 20).depth({0, 0}), 0);
}

TEST(DifferenceTable, SeesThatEqualNarrowStripsCoincide) {
  for (const double width : {0.4, 0.9, 2.0}) {
    EXPECT_GT(tableOf(box(20, width), box(20, width), 30).depth({0, 0}), 0) << width;
    EXPECT_GT(tableOf(box(width, 20), box(width, 20), 30).depth({0, 0}), 0) << width;
  }
}

TEST(DifferenceTable, LetsPiecesFillGapsOfTheirOwnWidth) {
  // a U and a box that fits into it, but only from above
  const Polyline u{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  const DifferenceTable table = tableOf(u, box(3, 4), 1);
  EXPECT_EQ(table.depth({3, 3}), 0);
  EXPECT_EQ(table.depth({3, 5}), 0);
  EXPECT_GT(table.depth({3, 2}), 0);
  EXPECT_GT(table.depth({2, 3}), 0);
  EXPECT_GT(tableOf(u, box(3.02, 4), 1).depth({3, 3}), 0);
}

TEST(DifferenceTable, KeepsPiecesFurtherApartThatLieFarFromEachOther) {
  // middles 100 cm apart: the repeat may bring them nearer by 0.5 cm
  const Polyline strip = box(99.6, 5);
  EXPECT_EQ(tableOf(strip, strip, 100, {0, 0, true}).depth({1, 0}), 0);
  EXPECT_EQ(tableOf(strip, strip, 100, {0, 0.0035, true}).depth({1, 0}), 0);
  EXPECT_GT(tableOf(strip, strip, 100, {0, 0.005, true}).depth({1, 0}), 0);
}

TEST(DifferenceTable, HoldsAllDifferencesOfNeedles) {
  for (const double angle : {0.03, 0.06, 0.1}) {
    for (int k = 0; k < 32; ++k) {
      const Mat2 turned = rotation(k * kPi / 2);
      const Vec2 off = k / 4 * Vec2(0.009, 0.009);
      const Polyline needle = testing::needle(angle, 1.5 * angle);
      const Shape one = shapeOf(needle, turned), other = shapeOf(needle, -turned);
      const DifferenceTable table(one, other, off, Board::square(0.07), {0, 0, false});
      // the forbidden area ends before the table does
      for (int i = table.columns().lo; i <= table.columns().hi; ++i) {
        EXPECT_EQ(table.depth({i, table.rows().lo}), 0);
        EXPECT_EQ(table.depth({i, table.rows().hi}), 0);
      }
      for (int j = table.rows().lo; j <= table.rows().hi; ++j) {
        EXPECT_EQ(table.depth({table.columns().lo, j}), 0);
        EXPECT_EQ(table.depth({table.columns().hi, j}), 0);
      }
    }
  }
}

}  // namespace
}  // namespace seamwise
