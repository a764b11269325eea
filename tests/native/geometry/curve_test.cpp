#include "geometry/curve.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/polygon.h"
#include "geometry/predicates.h"
#include "support/paths.h"

namespace seamwise {
namespace {

std::vector<Curve> someCurves() {
  return {Curve::line({0, 0}, {30, 4}), Curve::quadratic({0, 0}, {10, 12}, {25, 3}),
          Curve::cubic({1, 2}, {9, 30}, {20, -15}, {40, 6}),
          Curve::cubic({0, 0}, {0, 0}, {10, 10}, {20, 0}),   // speed 0 at the start
          Curve::cubic({0, 0}, {20, 15}, {0, 15}, {20, 0}),  // a cusp in the middle
          Curve::arc({0, 0}, {10, 2}, 7, false, true), Curve::arc({0, 0}, {10, 2}, 7, true, false),
          // a corner, a straight cubic, a bend, and a corner at which both cubics have zero speed
          Curve::path({{0, 0},
                       {3, 4},
                       {9, 5},
                       {10, 1},
                       {12, 2},
                       {14, 3},
                       {16, 4},
                       {17, 4.5},
                       {30, 8},
                       {30, 0},
                       {30, 0},
                       {25, -9},
                       {25, -9},
                       {25, -9},
                       {9, -4},
                       {8, -12}})};
}

double polylineLength(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

TEST(Curve, MeasuresAParabolaAsTheClosedFormDoes) {
  // y = x^2 on [0, 1]: (2 sqrt 5 + asinh 2) / 4
  const Curve c = Curve::quadratic({0, 0}, {0.5, 0}, {1, 1});
  EXPECT_NEAR(c.length(), (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4, 1e-13);
}

TEST(Curve, MeasuresEveryKindLikeAVeryFinePolyline) {
  for (const Curve& c : someCurves()) {
    Polyline fine;
    for (int k = 0; k <= 200000; ++k) fine.push_back(c.at(k / 200000.0));
    EXPECT_NEAR(c.length(), polylineLength(fine), 1e-7 * c.length());
  }
}

TEST(Curve, DrawsArcsOnTheSideThatSvgDoesInYUpCoordinates) {
  const double r = std::sqrt(2.0);
  // counter-clockwise from (0,0) to (2,0): a small arc bulges down, a large one further down
  EXPECT_NEAR((Curve::arc({0, 0}, {2, 0}, r, false, true).at(0.5) - Vec2(1, 1 - r)).norm(), 0,
              1e-12);
  EXPECT_NEAR((Curve::arc({0, 0}, {2, 0}, r, true, true).at(0.5) - Vec2(1, -1 - r)).norm(), 0,
              1e-12);
  EXPECT_NEAR((Curve::arc({0, 0}, {2, 0}, r, false, false).at(0.5) - Vec2(1, r - 1)).norm(), 0,
              1e-12);
  EXPECT_NEAR(Curve::arc({0, 0}, {2, 0}, 0.1, false, true).length(), kPi, 1e-12);
  EXPECT_NEAR(Curve::arc({0, 0}, {2, 0}, r, true, true).length(), 1.5 * kPi * r, 1e-12);
}

TEST(Curve, SpacesPointsEvenlyAlongItsLength) {
  for (const Curve& c : someCurves()) {
    for (int k = 0; k < 10; ++k) {
      const double t0 = c.parameterAt(k / 10.0), t1 = c.parameterAt((k + 1) / 10.0);
      Polyline fine;
      for (int i = 0; i <= 20000; ++i) fine.push_back(c.at(t0 + (t1 - t0) * i / 20000));
      EXPECT_NEAR(polylineLength(fine), c.length() / 10, 2e-6 * c.length());  // chords cut corners
    }
  }
}

TEST(Curve, GivesMirroredAndReversedPointsToTheNanometre) {
  const RigidMotion mirror = RigidMotion::reflection({3, 1}, {5, 9});
  for (const Curve& c : someCurves()) {
    const Curve m = c.transformed(mirror), r = c.reversed();
    EXPECT_NEAR(m.length(), c.length(), 1e-10);
    for (double s = 0; s <= 1; s += 0.0625) {
      EXPECT_NEAR((m.atFraction(s) - mirror(c.atFraction(s))).norm(), 0, 1e-9);
      EXPECT_NEAR((r.atFraction(1 - s) - c.atFraction(s)).norm(), 0, 1e-9);
    }
  }
}

TEST(Curve, IndependentlyDraftedMirrorImagesGiveMirroredPoints) {
  const Curve c = Curve::cubic({0, 0}, {20, 15}, {0, 14}, {20, 0});
  const Curve m = Curve::cubic({-20, 0}, {0, 14}, {-20, 15}, {0, 0});  // x -> -x, reversed
  for (double s = 0; s <= 1; s += 0.03125) {
    const Vec2 p = c.atFraction(s);
    EXPECT_NEAR((m.atFraction(1 - s) - Vec2(-p.x(), p.y())).norm(), 0, 1e-9);
  }
}

TEST(Curve, FlattensWithinTheToleranceAndKeepsItsEnds) {
  for (const Curve& c : someCurves()) {
    const Polyline line = c.flattened(0.01);
    EXPECT_EQ(line.front(), c.start());
    EXPECT_EQ(line.back(), c.end());
    for (int k = 0; k <= 1000; ++k)
      EXPECT_LE(nearestOnPolyline(line, c.at(k / 1000.0)).distance, 0.01);
  }
}

TEST(Curve, CountsBendsToBothSidesAsTurning) {
  EXPECT_NEAR(Curve::arc({0, 0}, {2, 0}, 1, false, true).turning(0.25, 0.75), kPi / 2, 1e-12);
  EXPECT_EQ(Curve::line({0, 0}, {1, 1}).turning(0, 1), 0);
  // S-curve: the tangent turns to one side and back again
  const Curve s = Curve::cubic({0, 0}, {1, 1}, {2, -1}, {3, 0});
  EXPECT_NEAR(s.turning(0, 1), 2 * (kPi / 4 + std::atan(0.5)), 0.05);
}

TEST(Curve, IsTheSameCurveAsAPathOfItsParts) {
  for (const Curve& c : someCurves()) {
    if (c.points().size() != 4) continue;
    for (const int parts : {2, 7, 100}) {
      const Curve path = testing::asPath(c, parts);
      ASSERT_EQ(path.points().size(), 3u * parts + 1);
      EXPECT_NEAR(path.length(), c.length(), 1e-10);
      for (double s = 0; s <= 1; s += 0.03125)
        EXPECT_NEAR((path.atFraction(s) - c.atFraction(s)).norm(), 0, 1e-9);
    }
  }
}

TEST(Curve, KeepsAPathsPointsAndItsDirectionAlongEachCubic) {
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, 1}, {5, 1}, {6, 0}};
  const Curve path = Curve::path(points);
  EXPECT_EQ(path.points(), points);
  EXPECT_EQ(path.reversed().points(), std::vector<Vec2>(points.rbegin(), points.rend()));
  EXPECT_EQ(path.reversed().reversed(), path);
  EXPECT_EQ(path.at(0.5), Vec2(3, 0));
  EXPECT_NEAR((path.derivative(0.25) - (path.at(0.250001) - path.at(0.249999)) / 2e-6).norm(), 0,
              1e-6);
  EXPECT_FALSE(path.straight());
}

TEST(Curve, CountsAPathsCornersAsTurnsBetweenButNotAtTheEnds) {
  const Curve roof = testing::polyline({{0, 0}, {3, 4}, {6, 0}});
  const double turn = 2 * std::atan2(4, 3);
  EXPECT_NEAR(roof.turning(0, 1), turn, 1e-12);
  EXPECT_NEAR(roof.turning(0.4, 0.6), turn, 1e-12);
  EXPECT_NEAR(roof.turning(0, 0.5), 0, 1e-12);
  EXPECT_NEAR(roof.turning(0.5, 1), 0, 1e-12);
  const std::vector<double> corners = roof.corners();
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_NEAR(corners[0], 0.5, 1e-12);
}

TEST(Curve, HasNoCornersButOnPathsThatTurnSharply) {
  for (const Curve& c : someCurves())
    if (c.cubics() == 0) {
      EXPECT_TRUE(c.corners().empty());
    }
  const Curve bend = Curve::cubic({1, 2}, {9, 30}, {20, -15}, {40, 6});
  EXPECT_TRUE(testing::asPath(bend, 40).corners().empty());
}

TEST(Curve, TakesCornersThatLieCloseToEachOtherForOneTheSameFromBothEnds) {
  const Curve c =
      testing::polyline({{0, 0}, {5, 0}, {5.04, 0.02}, {5.05, 0.06}, {5.05, 6}, {9, 9}});
  const std::vector<double> ahead = c.corners();
  std::vector<double> back = c.reversed().corners();
  ASSERT_EQ(ahead.size(), 2u);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_NEAR(back[0], 1 - ahead[1], 1e-12);
  EXPECT_NEAR(back[1], 1 - ahead[0], 1e-12);
  EXPECT_NEAR((c.atFraction(ahead[0]) - Vec2(5.04, 0.02)).norm(), 0, 1e-9);
}

TEST(Curve, SurvivesCubicsWithoutLengthInAPath) {
  const Vec2 a(0, 0), b(3, 4), c(6, 0);
  const Curve roof = Curve::path({a, a, b, b, b, b, b, b, c, c});
  EXPECT_NEAR(roof.length(), 10, 1e-12);
  EXPECT_NEAR((roof.atFraction(0.25) - Vec2(1.5, 2)).norm(), 0, 1e-9);
  EXPECT_EQ(roof.corners().size(), 1u);
  EXPECT_NEAR(roof.turning(0, 1), 2 * std::atan2(4, 3), 1e-9);
  EXPECT_EQ(Curve::path({a, a, a, a, a, a, a}).length(), 0);
  EXPECT_EQ(Curve::path({a, a, a, a, a, a, a}).atFraction(0.5), a);
}

TEST(Curve, SurvivesZeroLengthWithoutNotANumber) {
  const Vec2 p(1, 2);
  for (const Curve& c :
       {Curve::line(p, p), Curve::cubic(p, p, p, p), Curve::arc(p, p, 1, true, true)}) {
    EXPECT_EQ(c.length(), 0);
    EXPECT_EQ(c.atFraction(0.5), p);
  }
}

TEST(Orientation, SeesTheLastBit) {
  const Vec2 a(12, 12), b(24, 24);
  const double tiny = std::nextafter(0.5, 1.0);
  EXPECT_EQ(orientation(Vec2(0.5, 0.5), a, b), 0);
  EXPECT_EQ(orientation(Vec2(0.5, tiny), a, b), 1);
  EXPECT_EQ(orientation(Vec2(tiny, 0.5), a, b), -1);
}

TEST(Polygon, MeasuresAreaWithItsSign) {
  const Polyline square{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
  EXPECT_DOUBLE_EQ(signedArea(square), 6);
  EXPECT_DOUBLE_EQ(signedArea(Polyline(square.rbegin(), square.rend())), -6);
}

TEST(Polygon, NamesThePointWhereAnOutlineCrossesItself) {
  const auto at = findCrossing(Polyline{{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  ASSERT_TRUE(at.has_value());
  EXPECT_NEAR((at->at - Vec2(1, 1)).norm(), 0, 1e-12);
}

TEST(Polygon, AcceptsCollinearRunsAndRefusesTouchingAndFoldingBack) {
  EXPECT_FALSE(findCrossing(Polyline{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_TRUE(findCrossing(Polyline{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
  EXPECT_TRUE(findCrossing(Polyline{{0, 0}, {3, 0}, {1, 0}, {1, 2}}));
}

TEST(Polygon, FindsACutOutThatLeavesThePiece) {
  const Polyline square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_FALSE(findCrossing({square, {{4, 4}, {4, 6}, {6, 6}}}));
  EXPECT_TRUE(findCrossing({square, {{4, 4}, {4, 6}, {16, 6}}}));
}

TEST(Polygon, FindsTheOneCrossingAmongThousandsOfEdges) {
  Polyline comb;
  for (int k = 0; k < 2000; ++k) comb.push_back({0.01 * k, k % 2 == 0 ? 0.0 : 30.0});
  comb.push_back({20.0, 40.0});
  comb.push_back({-1.0, 40.0});
  EXPECT_FALSE(findCrossing(comb));
  comb[1001].x() += 0.025;
  EXPECT_TRUE(findCrossing(comb));
}

TEST(Polygon, KnowsInsideFromOutside) {
  const Polyline u{{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}};
  EXPECT_TRUE(contains(u, {0.5, 4}));
  EXPECT_FALSE(contains(u, {2.5, 4}));
  EXPECT_FALSE(contains(u, {7, 0.5}));
}

}  // namespace
}  // namespace seamwise
