#include "marker/shape.h"

#include <gtest/gtest.h>

#include "geometry/polygon.h"
#include "marker/board.h"
#include "marker/convex_parts.h"
#include "marker/marker_outlines.h"

namespace seamwise {
namespace {

using testing::boundsOf;
using testing::distanceTo;
using testing::isInside;
using testing::Random;

constexpr double kOverlap = 2 * kTouching;

std::vector<Polyline> somePolygons(unsigned seed) {
  Random random(seed);
  std::vector<Polyline> all;
  for (int corners = 3; corners < 24; ++corners)
    all.push_back(testing::star(random, corners, corners < 5 ? 6 : 2, 12));
  for (int teeth = 2; teeth < 8; ++teeth) all.push_back(testing::comb(random, teeth));
  // corners on straight edges and on the lines of others
  all.push_back({{0, 0}, {4, 0}, {8, 0}, {8, 3}, {6, 3}, {6, 6}, {4, 6}, {2, 6}, {2, 3}, {0, 3}});
  all.push_back({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}});
  return all;
}

/// Depth of a point in a convex polygon; negative outside. [cm]
double depthIn(const Polyline& convex, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const Vec2 &a = convex[k], &b = convex[(k + 1) % convex.size()];
    if ((b - a).norm() > 1e-9) least = std::min(least, cross(b - a, p - a) / (b - a).norm());
  }
  return least;
}

TEST(Shape, IsTheSameWhicheverWayRoundItIsGiven) {
  const Polyline ring = {{0, 0}, {6, 0}, {6, 5}, {3, 2}, {0, 5}};
  const Shape shape = shapeOf(ring, Mat2::Identity());
  const Shape other = shapeOf({ring.rbegin(), ring.rend()}, Mat2::Identity());
  EXPECT_GT(other.area, 0);
  EXPECT_EQ(other.area, shape.area);
  EXPECT_EQ(other.parts.size(), shape.parts.size());
}

TEST(ConvexParts, CoverThePolygonAlsoAlongTheirDiagonals) {
  for (const Polyline& ring : somePolygons(1)) {
    const auto parts = convexParts(ring, kOverlap);
    Random random(2);
    const auto [low, high] = boundsOf(ring);
    std::vector<Vec2> points;
    for (int k = 0; k < 400; ++k) {
      const double x = random.between(low.x(), high.x());
      points.emplace_back(x, random.between(low.y(), high.y()));
    }
    for (const Vec2& p : ring)
      for (const Vec2& q : ring)
        for (const double share : {0.5, 0.013}) points.emplace_back(p + share * (q - p));
    for (const Vec2& p : points) {
      if (!isInside(ring, p) || distanceTo(ring, p) < 1e-6) continue;
      double deepest = -1;
      for (const Polyline& part : parts) deepest = std::max(deepest, depthIn(part, p));
      EXPECT_GT(deepest, -1e-9) << p.transpose();
    }
  }
}

TEST(ConvexParts, AreConvexAndReachHardlyBeyondThePolygon) {
  for (const Polyline& ring : somePolygons(3)) {
    double area = 0;
    for (const Polyline& part : convexParts(ring, kOverlap)) {
      area += signedArea(part);
      for (std::size_t k = 0; k < part.size(); ++k) {
        const Vec2 &a = part[k], &b = part[(k + 1) % part.size()];
        const Vec2& c = part[(k + 2) % part.size()];
        EXPECT_GE(distanceTo(a, c, b) * (cross(b - a, c - b) < 0 ? -1 : 1), -1e-9);
        for (int s = 0; s < 8; ++s) {
          const Vec2 p = a + s / 8.0 * (b - a);
          if (!isInside(ring, p)) {
            EXPECT_LT(distanceTo(ring, p), 4 * kOverlap) << p.transpose();
          }
        }
      }
    }
    // the parts overlap by no more than their tolerance
    EXPECT_NEAR(area, signedArea(ring), 0.01 * signedArea(ring) + 0.5);
  }
}

TEST(ConvexParts, AreOneOfAConvexPolygonAndFewOfAComb) {
  Polyline round;
  for (int k = 0; k < 40; ++k) round.emplace_back(10 * unit(2 * kPi * k / 40));
  EXPECT_EQ(convexParts(round, kOverlap).size(), 1u);
  const Polyline comb{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}};
  EXPECT_EQ(convexParts(comb, kOverlap).size(), 3u);
}

TEST(ConvexParts, DifferencesAreTheHullsOfAllDifferencesOfCorners) {
  Random random(4);
  for (int times = 0; times < 60; ++times) {
    const auto convex = [&] {
      Polyline ring;
      const int corners = 3 + times % 7;
      const Vec2 middle = random.point();
      for (int k = 0; k < corners; ++k)
        ring.emplace_back(middle + random.between(1, 9) *
                                       unit(2 * kPi * (k + random.between(0, 0.9)) / corners));
      // leaves out corners that the points between them hide
      for (bool again = true; again && ring.size() > 3;) {
        again = false;
        for (std::size_t k = 0; k < ring.size() && !again; ++k) {
          const std::size_t n = ring.size();
          if (triangleArea(ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]) > 0.1) continue;
          ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
          again = true;
        }
      }
      return ring;
    };
    const Polyline a = times % 5 == 0 ? testing::box(3, 5) : convex();
    const Polyline b = times % 10 == 0 ? testing::box(2, 7) : convex();
    if (signedArea(a) < 0.2 || signedArea(b) < 0.2) continue;
    const Polyline sum = convexDifference(a, b);
    for (const Vec2& p : a)
      for (const Vec2& q : b) EXPECT_GT(depthIn(sum, p - q), -1e-9);
    for (const Vec2& corner : sum) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec2& p : a)
        for (const Vec2& q : b) nearest = std::min(nearest, (p - q - corner).norm());
      EXPECT_LT(nearest, 1e-9);
    }
    EXPECT_LE(sum.size(), a.size() + b.size());
  }
}

/// A shape with bays, sampled as finely as outlines.
Polyline blob(double phase) {
  Polyline ring;
  for (int k = 0; k < 240; ++k) {
    const double angle = 2 * kPi * k / 240;
    ring.emplace_back((10 + 2.5 * std::cos(3 * angle + phase)) * unit(angle));
  }
  return ring;
}

TEST(SimplifiedOutlines, HoldThePolygonWithFewerCornersAndHardlyMore) {
  std::vector<Polyline> rings = somePolygons(5);
  for (int k = 0; k < 6; ++k) rings.push_back(blob(k));
  for (const Polyline& ring : rings) {
    const Polyline simple = simplifiedOutwards(ring, 0.04, 0.12);
    EXPECT_FALSE(findCrossing(simple));
    for (const Vec2& p : ring)
      if (!isInside(simple, p)) {
        EXPECT_LT(distanceTo(simple, p), 1e-9);
      }
    for (std::size_t k = 0; k < simple.size(); ++k) {
      const Vec2 &a = simple[k], &b = simple[(k + 1) % simple.size()];
      for (int s = 0; s < 10; ++s) {
        const Vec2 p = a + s / 10.0 * (b - a);
        if (!isInside(ring, p)) {
          EXPECT_LT(distanceTo(ring, p), 0.12 + 1e-9);
        }
      }
    }
    EXPECT_LE(simple.size(), ring.size());
    if (ring.size() == 240) {
      EXPECT_LT(simple.size(), 100u);
    }
  }
}

TEST(SimplifiedOutlines, DoNotRunFarOffAtTheEndOfANeedle) {
  for (const double angle : {0.03, 0.06, 0.1}) {
    const Polyline ring = testing::needle(angle, 1.5 * angle);
    ASSERT_FALSE(findCrossing(ring));
    for (const Vec2& p : simplifiedOutwards(ring, 0.04, 0.12)) {
      if (!isInside(ring, p)) {
        EXPECT_LT(distanceTo(ring, p), 0.04 + 1e-9) << p.transpose();
      }
    }
  }
}

TEST(MarkerShapes, AreTheTurnedOutlineOnAFineGrid) {
  const Polyline ring = blob(1);
  const Mat2 turn = rotation(0.7);
  const Shape shape = shapeOf(ring, turn);
  ASSERT_EQ(shape.ring.size(), ring.size());
  Polyline turned;
  for (const Vec2& p : ring) turned.emplace_back(turn * p);
  for (std::size_t k = 0; k < ring.size(); ++k) EXPECT_LT((shape.ring[k] - turned[k]).norm(), 1e-6);
  EXPECT_NEAR(shape.area, signedArea(ring), 1e-3);
  const auto [low, high] = boundsOf(shape.ring);
  EXPECT_EQ(shape.low, low);
  EXPECT_EQ(shape.high, high);
  // rounding error of another machine
  for (Vec2& p : turned) p *= 1 + 1e-15;
  EXPECT_EQ(shapeOf(turned, Mat2::Identity()).ring, shape.ring);
}

}  // namespace
}  // namespace seamwise
