#include "marker/board.h"

#include <gtest/gtest.h>

#include "marker/marker_outlines.h"

namespace seamwise {
namespace {

using testing::Random;

/// Returns whether v is an integer combination of a and b.
bool isCombination(const Vec2& a, const Vec2& b, const Vec2& v) {
  const double area = cross(a, b), i = cross(v, b) / area, j = cross(a, v) / area;
  return std::abs(i - std::round(i)) < 1e-7 && std::abs(j - std::round(j)) < 1e-7;
}

struct Lattice {
  Vec2 w1, w2;
  bool is_level;  ///< it has a vector across the fabric
};

std::vector<Lattice> someLattices() {
  const double h = std::sqrt(3.0) / 2;
  std::vector<Lattice> all{{{10, 0}, {0, 7}, true},           {{0, 10}, {-7, 0}, true},
                           {{5, -4}, {5, 4}, true},           {{10, 0}, {6, 8}, true},
                           {{10, 0}, {5, 10 * h}, true},      {{0, 10}, {-10 * h, 5}, true},
                           {{10, 0}, {3, 8}, true},           {{8, 3}, {0, 10}, true},
                           {{8.1, 2.7}, {-3, 10 * h}, false}, {{13, 8}, {29, 24}, true}};
  // computed from angles, as in prints
  for (const double angle : {kPi / 6, kPi / 3, kPi / 2, 2 * kPi / 3, 5 * kPi / 6})
    all.push_back({12.3 * unit(angle), 12.3 * unit(angle + kPi / 3), true});
  all.push_back({7.7 * unit(kPi / 2), 4.1 * unit(kPi), true});
  Random random(1);
  for (int k = 0; k < 30; ++k) {
    const double angle = random.angle();
    all.push_back({random.between(2, 20) * unit(angle),
                   random.between(2, 20) * unit(angle + random.between(0.3, 2.8)), false});
  }
  return all;
}

TEST(MarkerBoard, HasTheLatticesOwnDots) {
  for (const auto& [w1, w2, is_level] : someLattices()) {
    const Board board = Board::ofLattice(w1, w2, 0.5);
    for (const Vec2& v : {board.along, board.up}) EXPECT_TRUE(isCombination(w1, w2, v));
    for (const Vec2& w : {w1, w2}) EXPECT_TRUE(isCombination(board.along, board.up, w));
    EXPECT_GT(board.along.x(), 0);
    EXPECT_GT(board.up.y(), 0);
    EXPECT_LE(2 * std::abs(board.along.dot(board.up)), board.along.squaredNorm() + 1e-7);
    const Vec2 v = board.shift({3, -7});
    EXPECT_LT((board.steps(v) - Vec2(3, -7)).norm(), 1e-9);
  }
}

TEST(MarkerBoard, HasLevelRowsWhereTheLatticeHasThem) {
  for (const auto& [w1, w2, is_level] : someLattices()) {
    const Board board = Board::ofLattice(w1, w2, 0.5);
    // exact, because the search through rows relies on it
    EXPECT_EQ(board.along.y() == 0, is_level) << w1.transpose() << ", " << w2.transpose();
  }
}

TEST(MarkerBoard, TakesASublatticeOfStepsThatAreLongEnough) {
  for (const auto& [w1, w2, is_level] : someLattices()) {
    for (const double least : {4.0, 15.0, 33.3}) {
      const Board board = Board::ofLattice(w1, w2, least);
      for (const Vec2& v : {board.along, board.up}) {
        EXPECT_TRUE(isCombination(w1, w2, v));
      }
      EXPECT_GE(board.along.norm(), least - 1e-6);
      EXPECT_LT(board.along.norm(), least + std::max({w1.norm(), w2.norm(), 80.1}));
      EXPECT_GT(board.along.x(), 0);
      EXPECT_GT(board.up.y(), 0);
    }
  }
  const Board stripes = Board::ofLattice({8, 0}, {0, 0.15}, 0.5);
  EXPECT_LT((stripes.along - Vec2(8, 0)).norm(), 1e-12);
  EXPECT_LT((stripes.up - Vec2(0, 0.6)).norm(), 1e-12);
}

/// The period by trying all vectors of small multiples; 0 where there is none.
double periodBySearch(const Vec2& w1, const Vec2& w2, int axis) {
  double least = 0;
  for (int i = -30; i <= 30; ++i) {
    for (int j = -30; j <= 30; ++j) {
      const Vec2 v = i * w1 + j * w2;
      if (std::abs(v[1 - axis]) > 1e-7 || v[axis] < 1e-3) continue;
      if (least == 0 || v[axis] < least) least = v[axis];
    }
  }
  return least;
}

TEST(MarkerBoard, KnowsRepeatsAlongAndAcross) {
  const double h = std::sqrt(3.0) / 2;
  const auto expect = [](const Vec2& w1, const Vec2& w2, double across, double along) {
    EXPECT_NEAR(latticePeriod(w1, w2, false).value_or(0), across, 1e-6);
    EXPECT_NEAR(latticePeriod(w1, w2, true).value_or(0), along, 1e-6);
  };
  expect({10, 0}, {0, 7}, 10, 7);
  expect({5, -4}, {5, 4}, 10, 8);
  expect({10, 0}, {6, 8}, 10, 40);
  expect({10, 0}, {5, 10 * h}, 10, 20 * h);
  expect({0, 10}, {-10 * h, 5}, 20 * h, 10);
  expect({10, 0}, {3, 8}, 10, 80);
  expect({10, 0}, {kPi, 8}, 10, 0);
  expect(10 * unit(0.3), 10 * unit(0.3 + kPi / 3), 0, 0);
  for (const auto& [w1, w2, is_level] : someLattices())
    if (w1.norm() < 15 && is_level)
      expect(w1, w2, periodBySearch(w1, w2, 0), periodBySearch(w1, w2, 1));
}

}  // namespace
}  // namespace seamwise
