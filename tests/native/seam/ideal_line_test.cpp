#include "seam/ideal_line.h"

#include <gtest/gtest.h>

#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::kExact;
using testing::Random;
using testing::sampleGroup;

constexpr int kPoints = 13;

/// A random curve with about 1 cm between vertices and a total turn of `bend`, plus some noise.
std::vector<Vec2> curve(Random& random, double bend, double noise = 0) {
  std::vector<Vec2> line{random.point()};
  double heading = random.angle();
  for (int i = 1; i < kPoints; ++i) {
    line.push_back(line.back() + unit(heading) * (1 + 0.1 * (i % 3)));
    heading += bend / (kPoints - 2) + random.between(-noise, noise);
  }
  return line;
}

double length(const std::vector<Vec2>& line) {
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i) total += (line[i] - line[i - 1]).norm();
  return total;
}

/// Signed sum of the turning angles.
double totalTurn(const std::vector<Vec2>& line) {
  double total = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Vec2 a = line[i - 1] - line[i - 2], b = line[i] - line[i - 1];
    total += std::atan2(cross(a, b), a.dot(b));
  }
  return total;
}

/// One seam between piece 0, given by its points in print space, and piece 1. `carried` are the
/// points to which the join `g` maps the vertices of piece 1.
struct Sewn {
  Seam seam;
  Shapes shapes{2};
  std::vector<Alignment> at;

  Sewn(Random& random, const std::vector<Vec2>& own, const std::vector<Vec2>& carried,
       const Element& g)
      : at{random.alignment(), random.alignment()} {
    seam.a.piece = 0, seam.b.piece = 1;
    for (std::size_t i = 0; i < own.size(); ++i) {
      seam.a.vertices.push_back(static_cast<int>(i));
      seam.b.vertices.insert(seam.b.vertices.begin(), static_cast<int>(i));
      shapes[0].push_back(at[0].toPiece(own[i]));
      const Vec2 before = g.A.transpose() * (carried[i] - g.a);
      shapes[1].insert(shapes[1].begin(), at[1].toPiece(before));
    }
  }
};

/// An element of the print, with a random lattice shift added.
Element shifted(const WallpaperGroup& group, Element e, Random& random) {
  e.a += std::round(random.between(-4, 4)) * group.w1();
  e.a += std::round(random.between(-4, 4)) * group.w2();
  return e;
}

class SeamInGroup : public ::testing::TestWithParam<GroupData> {
 protected:
  WallpaperGroup group_ = sampleGroup(GetParam(), 0.4);
  Random random_{5};
};

INSTANTIATE_TEST_SUITE_P(All, SeamInGroup, ::testing::ValuesIn(wallpaperGroups()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(SeamInGroup, IsJoinedByTheElementThatItWasMadeWith) {
  for (const Element& e : group_.elements()) {
    const Element g = shifted(group_, e, random_);
    const auto line = curve(random_, 1.2, 0.2);
    const Sewn sewn(random_, line, line, g);
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at);
    EXPECT_LT(join.cost, kExact * length(line));
    EXPECT_LT((join.element.A - g.A).norm() + (join.element.a - g.a).norm(), kExact);
    EXPECT_EQ(join.mirrored(), g.mirrored);
    for (double d : joinMismatch(join, sewn.seam, sewn.shapes, sewn.at)) EXPECT_LT(d, kExact);
  }
}

TEST_P(SeamInGroup, ShowsHowFarItsSideWasMovedAway) {
  const Vec2 off(0.12, -0.05);
  for (const Element& e : group_.elements()) {
    const auto line = curve(random_, 1.2, 0.2);
    std::vector<Vec2> carried = line;
    for (Vec2& p : carried) p += off;
    const Sewn sewn(random_, line, carried, shifted(group_, e, random_));
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at);
    EXPECT_NEAR(join.cost, length(line) * off.norm(), kExact * length(line));
    for (double d : joinMismatch(join, sewn.seam, sewn.shapes, sewn.at))
      EXPECT_NEAR(d, off.norm(), kExact);
  }
}

TEST_P(SeamInGroup, HasNoCheaperJoinThanTheBestOne) {
  const auto& [u1, u2] = group_.reducedBasis();
  for (int k = 0; k < 60; ++k) {
    const Sewn sewn(random_, curve(random_, 1), curve(random_, -0.5), group_.elements()[0]);
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at);
    const SeamMidpoints m = seamMidpoints(sewn.seam, sewn.shapes, sewn.at);
    double least = 1e300;
    for (const Element& e : group_.elements()) {
      // lattice points in a wide window around the first midpoint's best
      const Vec2 first = m.x[0] - e(m.y[0]), origin = first - group_.reduce(first);
      for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
          double cost = 0;
          for (std::size_t s = 0; s < m.x.size(); ++s)
            cost += m.length[s] * (m.x[s] - e(m.y[s]) - origin - i * u1 - j * u2).norm();
          least = std::min(least, cost);
        }
      }
    }
    EXPECT_NEAR(join.cost, least, 1e-9 * least);
  }
}

TEST_P(SeamInGroup, IsNeverMirroredWhenOnlyContinuousJoinsAreAllowed) {
  for (const Element& e : group_.elements()) {
    const auto line = curve(random_, 1.2, 0.2);
    const Sewn sewn(random_, line, line, shifted(group_, e, random_));
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at, true);
    EXPECT_FALSE(join.mirrored());
    if (e.mirrored)
      EXPECT_GT(join.cost, 1e-3);
    else
      EXPECT_LT(join.cost, kExact * length(line));
  }
}

TEST_P(SeamInGroup, GetsIdealLinesOnEquivalentPointsOfThePrint) {
  for (const Element& e : group_.elements()) {
    const Sewn sewn(random_, curve(random_, 1, 0.1), curve(random_, 0.4, 0.1),
                    shifted(group_, e, random_));
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at);
    for (IdealShape shape : {IdealShape::kTransported, IdealShape::kAveraged}) {
      const IdealLines lines = idealLines(sewn.seam, join, sewn.shapes, sewn.at, shape);
      ASSERT_EQ(lines.a.size(), static_cast<std::size_t>(kPoints));
      for (int i = 0; i < kPoints; ++i) {
        const Vec2 x = sewn.at[0].toPrint(lines.a[i]), y = sewn.at[1].toPrint(lines.b[i]);
        EXPECT_LT((x - join.element(y)).norm(), kExact);
        EXPECT_LT(group_.distance(x, y), kExact);
      }
      EXPECT_NEAR(length(lines.a), length(lines.b), kExact);
    }
  }
}

TEST_P(SeamInGroup, KeepsSidesThatMatchAlready) {
  for (const Element& e : group_.elements()) {
    const auto line = curve(random_, 1.5, 0.1);
    const Sewn sewn(random_, line, line, shifted(group_, e, random_));
    const Join join = bestJoin(group_, sewn.seam, sewn.shapes, sewn.at);
    for (IdealShape shape : {IdealShape::kTransported, IdealShape::kAveraged}) {
      // holds for mirrored joins too, in which the pieces' sides turn in opposite senses
      const IdealLines lines = idealLines(sewn.seam, join, sewn.shapes, sewn.at, shape);
      for (int i = 0; i < kPoints; ++i) {
        EXPECT_LT((lines.a[i] - sewn.shapes[0][sewn.seam.a.vertices[i]]).norm(), kExact);
        EXPECT_LT((lines.b[i] - sewn.shapes[1][sewn.seam.b.vertices[i]]).norm(), kExact);
      }
    }
  }
}

TEST_P(SeamInGroup, KeepsItsMeanCurvatureUnderMirroredJoinsToo) {
  for (const Element& e : group_.elements()) {
    // side b, mapped by the join, turns by half as much
    const auto own = curve(random_, 1.6), carried = laidOn(curve(random_, 0.8), own);
    const Sewn sewn(random_, own, carried, shifted(group_, e, random_));
    Join join;
    join.element = e;
    const IdealLines lines =
        idealLines(sewn.seam, join, sewn.shapes, sewn.at, IdealShape::kAveraged);
    EXPECT_NEAR(totalTurn(lines.a), 1.2, 1e-9);
    EXPECT_NEAR(totalTurn(lines.b), e.mirrored ? -1.2 : 1.2, 1e-9);
    const IdealLines copied =
        idealLines(sewn.seam, join, sewn.shapes, sewn.at, IdealShape::kTransported);
    EXPECT_NEAR(totalTurn(copied.a), 0.8, 1e-9) << "a rigid copy of side b";
  }
}

TEST(AveragedShape, HasTheMeanOfEveryEdgeLengthAndTurn) {
  Random random(6);
  const auto first = curve(random, 0.9, 0.3);
  auto second = curve(random, -0.4, 0.3);
  for (Vec2& p : second) p *= 1.1;
  const auto mean = averagedShape(first, second);
  ASSERT_EQ(mean.size(), first.size());
  for (int i = 1; i < kPoints; ++i) {
    const double a = (first[i] - first[i - 1]).norm(), b = (second[i] - second[i - 1]).norm();
    EXPECT_NEAR((mean[i] - mean[i - 1]).norm(), (a + b) / 2, kExact);
  }
  for (int i = 2; i < kPoints; ++i) {
    auto turnAt = [&](const std::vector<Vec2>& l) { return totalTurn({l[i - 2], l[i - 1], l[i]}); };
    EXPECT_NEAR(turnAt(mean), (turnAt(first) + turnAt(second)) / 2, kExact);
  }
}

TEST(LaidOn, IsARigidMotionThatNoSmallMotionImproves) {
  Random random(7);
  for (int k = 0; k < 10; ++k) {
    const auto line = curve(random, 1, 0.3), onto = curve(random, 0.3, 0.3);
    const auto laid = laidOn(line, onto);
    auto squares = [&](double turn, const Vec2& shift) {
      double total = 0;
      for (int i = 0; i < kPoints; ++i)
        total += (rotation(turn) * (laid[i] - laid[0]) + laid[0] + shift - onto[i]).squaredNorm();
      return total;
    };
    EXPECT_NEAR(length(laid), length(line), kExact);
    EXPECT_NEAR(totalTurn(laid), totalTurn(line), kExact) << "it may not be reflected";
    for (int p = 0; p < 20; ++p) {
      const Vec2 shift = random.point() * 1e-4;
      EXPECT_GT(squares(random.between(-1e-2, 1e-2), shift), squares(0, Vec2::Zero()));
    }
  }
}

}  // namespace
}  // namespace seamwise
