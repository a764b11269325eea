#include "wallpaper/lattice.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::kExact;
using testing::Random;

/// The message with which a lattice is refused; empty when it is accepted.
std::string refusal(std::string_view group, const Vec2& w1, const Vec2& w2) {
  const auto made = WallpaperGroup::make(group, w1, w2);
  if (made.ok()) return "";
  EXPECT_EQ(made.error().code, Failure::kLattice);
  return made.error().message;
}

TEST(Lattice, ReducesAnySkewedBasisToTheShortestVectors) {
  const Vec2 a(10, 0), b(4, 12);
  for (const auto& [p, q, r, s] :
       {std::array{1, 0, 0, 1}, std::array{1, 5, 0, 1}, std::array{7, 3, 2, 1},
        std::array{21, 13, 8, 5}, std::array{-3, 1, -1, 0}, std::array{0, 1, -1, 40}}) {
    ASSERT_EQ(std::abs(p * s - q * r), 1);
    const auto [r1, r2] = lagrangeReduced(p * a + q * b, r * a + s * b);
    EXPECT_NEAR(r1.norm(), a.norm(), kExact);
    EXPECT_NEAR(r2.norm(), b.norm(), kExact);
    EXPECT_GE(r1.dot(r2), 0);
    EXPECT_LE(2 * r1.dot(r2), r1.squaredNorm() + kExact);
  }
}

TEST(Lattice, ReductionOfParallelVectorsEnds) {
  for (const double times : {1.0, 2.0, 1.5, -3.0, 0.0}) {
    const auto [r1, r2] = lagrangeReduced(Vec2(6, 0), times * Vec2(6, 0));
    EXPECT_EQ(r1, Vec2(0, 0)) << times;
    EXPECT_GT(r2.norm(), 2.9) << times;
  }
}

TEST(Lattice, ReducesAVectorToTheShortestOneInItsClassOnLatticesOfEveryShape) {
  Random random(3);
  for (int k = 0; k < 300; ++k) {
    const Vec2 w1 = random.between(1, 20) * unit(random.angle());
    const Vec2 w2 = random.between(1, 20) * rotation(random.between(0.15, 3)) * w1.normalized();
    const auto group = WallpaperGroup::make("p1", w1, w2);
    ASSERT_TRUE(group.ok()) << group.error().message;
    const auto& [r1, r2] = group.value().reducedBasis();
    const Vec2 v = random.point(), short_v = group.value().reduce(v);
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        shortest = std::min(shortest, (short_v - i * r1 - j * r2).norm());
      }
    }
    EXPECT_NEAR(short_v.norm(), shortest, kExact);
    // The difference is a lattice vector.
    const double area = cross(w1, w2);
    const double u = cross(v - short_v, w2) / area, n = cross(w1, v - short_v) / area;
    EXPECT_NEAR(u, std::round(u), 1e-7);
    EXPECT_NEAR(n, std::round(n), 1e-7);
  }
}

TEST(Lattice, MeasuresTheSameWhicheverBasisDescribesIt) {
  const auto plain = WallpaperGroup::make("p2", {10, 0}, {3, 8});
  const auto other = WallpaperGroup::make("p2", {13, 8}, {29, 24});  // w1 + w2, 2 w1 + 3 w2
  ASSERT_TRUE(plain.ok() && other.ok());
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    const Vec2 x = random.point(), y = random.point();
    EXPECT_NEAR(plain.value().distance(x, y), other.value().distance(x, y), kExact);
  }
}

TEST(Lattice, AnyLatticeIsGoodForP1AndP2) {
  for (const char* group : {"p1", "p2"}) {
    EXPECT_EQ(refusal(group, {10, 0}, {3, 8}), "");
    EXPECT_EQ(refusal(group, {10, 0}, {0, 10}), "");
    EXPECT_EQ(refusal(group, {10, 0}, {-40, 0.5}), "");
  }
}

TEST(Lattice, KeepsTheDigitsItWasGivenAndRemovesOnlyWhatIsOff) {
  const auto exact = WallpaperGroup::make("p4m", {10, 0}, {0, 10});
  ASSERT_TRUE(exact.ok());
  EXPECT_EQ(exact.value().w2(), Vec2(0, 10));
  EXPECT_FALSE(std::signbit(exact.value().w2().x()));
  const auto rounded = WallpaperGroup::make("p6m", {10, 0}, {5, 8.66025});
  ASSERT_TRUE(rounded.ok()) << rounded.error().message;
  EXPECT_NEAR(rounded.value().w2().y(), 10 * std::sqrt(3.0) / 2, 1e-12);
  const auto rhombic = WallpaperGroup::make("cm", {10, 0}, {6, 8.000003});
  ASSERT_TRUE(rhombic.ok()) << rhombic.error().message;
  EXPECT_NEAR(rhombic.value().w1().norm(), rhombic.value().w2().norm(), 1e-14);
}

TEST(Lattice, RefusesAnUnknownGroupByNamingThoseThatExist) {
  const auto made = WallpaperGroup::make("c3m1", {10, 0}, {0, 10});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, Failure::kGroupUnknown);
  EXPECT_EQ(made.error().message,
            "print group 'c3m1' is unknown: choose one of p1, p2, pm, pg, cm, pmm, pmg, pgg, cmm, "
            "p4, p4m, p4g, p3, p3m1, p31m, p6, p6m");
}

TEST(Lattice, RefusesNumbersThatAreNoLengths) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal("p1", {std::nan(""), 0}, {0, 10}),
            "print lattice: w1 is not finite: give two numbers in cm");
  EXPECT_EQ(refusal("p1", {10, 0}, {0, infinite}),
            "print lattice: w2 is not finite: give two numbers in cm");
  EXPECT_EQ(refusal("p1", {10, 0}, {0, 0}),
            "print lattice: w2 is 0 cm long, but a repeat must be between 0.05 and 1000 cm: check "
            "that it is given in cm");
  EXPECT_NE(refusal("p1", {0.049, 0}, {0, 10}), "");
  EXPECT_EQ(refusal("p1", {0.05, 0}, {0, 10}), "");
  EXPECT_EQ(refusal("p1", {1000, 0}, {0, 10}), "");
  EXPECT_NE(refusal("p1", {1001, 0}, {0, 10}), "");
}

TEST(Lattice, RefusesParallelVectorsAndRepeatsTooShortToPrint) {
  EXPECT_EQ(refusal("p1", {10, 0}, {-20, 0}),
            "print lattice: w1 (10, 0) and w2 (-20, 0) are parallel: give two repeats in different "
            "directions (for stripes, a short one along the stripe)");
  EXPECT_EQ(refusal("p1", {10, 0}, {20, 0.01}),
            "print lattice: w1 and w2 combine to a repeat of only 0.01 cm, but none may be below "
            "0.05 cm: make them less parallel");
}

TEST(Lattice, TellsHowToMakeALeftHandedLatticeRightHandedWithoutMovingTheMirrors) {
  EXPECT_EQ(refusal("p4m", {0, 10}, {10, 0}),
            "print lattice: w1 to w2 turns clockwise, but must turn counter-clockwise: swap them: "
            "w1 = (10, 0), w2 = (0, 10)");
  // Swapping would turn the mirrors of pm by 90 degrees.
  EXPECT_EQ(refusal("pm", {0, 10}, {7, 0}),
            "print lattice: w1 to w2 turns clockwise, but must turn counter-clockwise: take w2 = "
            "(-7, 0)");
  EXPECT_EQ(refusal("pm", {0, 10}, {-7, 0}), "");
}

TEST(Lattice, RefusesARectangularGroupOnAnObliqueLatticeWithTheVectorThatWouldDo) {
  EXPECT_EQ(refusal("pgg", {10, 0}, {3, 4}),
            "print group pgg needs w1 perpendicular to w2, but w1 and w2 are at 53.130102 degrees: "
            "take w2 = (0, 5) or choose p1 or p2, which take any lattice");
  EXPECT_EQ(refusal("pgg", {10, 0}, {0, 5}), "");
}

TEST(Lattice, SaysThatPmgIsSwappedInTheInternationalTables) {
  EXPECT_EQ(refusal("pmg", {0, 10}, {7, 0}),
            "print lattice: w1 to w2 turns clockwise, but must turn counter-clockwise: take w2 = "
            "(-7, 0) (the mirrors of pmg run along w1 here, its glides along w2; in the "
            "International Tables it is the other way round)");
}

TEST(Lattice, RefusesASquareGroupOnOtherLattices) {
  EXPECT_EQ(refusal("p4m", {10, 0}, {0, 12}),
            "print group p4m needs a square lattice, but w1 is 10 cm and w2 is 12 cm long: take w2 "
            "= (0, 10) or choose a group of the rectangular lattice (pm, pg, pmm, pmg, pgg)");
  EXPECT_EQ(refusal("p4", {10, 0}, {6, 8}),
            "print group p4 needs a square lattice, but w1 and w2 are at 53.130102 degrees: take "
            "w2 = (0, 10) or choose p1 or p2, which take any lattice");
}

TEST(Lattice, TurnsTheSidesOfACentredRectangleIntoTheRhombicLatticeThatHasThem) {
  EXPECT_EQ(
      refusal("cm", {10, 0}, {0, 8}),
      "print group cm needs a rhombic lattice, w1 and w2 of one length, but w1 is 10 cm and "
      "w2 is 8 cm long: if they are the sides of the centred rectangle, take w1 = (5, -4) and "
      "w2 = (5, 4)");
  EXPECT_EQ(refusal("cm", {5, -4}, {5, 4}), "");
  EXPECT_EQ(refusal("cmm", {10, 0}, {3, 4}),
            "print group cmm needs a rhombic lattice, w1 and w2 of one length, but w1 is 10 cm and "
            "w2 is 5 cm long: scale one of them or choose p1 or p2, which take any lattice");
}

TEST(Lattice, TurnsAHexagonalLatticeAt120DegreesIntoOneAt60) {
  EXPECT_EQ(
      refusal("p31m", {10, 0}, 10 * unit(2 * kPi / 3)),
      "print group p31m needs a hexagonal lattice, w1 and w2 of one length at 60 degrees, but "
      "w1 and w2 are at 120 degrees: take w1 + w2 = (5, 8.66025403784439) for w2");
  EXPECT_EQ(refusal("p31m", {10, 0}, {5, 8.66025403784439}), "");
  EXPECT_EQ(
      refusal("p6", {10, 0}, {0, 10}),
      "print group p6 needs a hexagonal lattice, w1 and w2 of one length at 60 degrees, but "
      "w1 and w2 are at 90 degrees: take w2 = (5, 8.66025403784439) or choose p1 or p2, which "
      "take any lattice");
  EXPECT_NE(refusal("p3", {10, 0}, {5, 8.67}), "");
}

TEST(Lattice, AcceptsWhatIsWithinAMillionthOfItsTypeAndRefusesTenTimesThat) {
  for (const double off : {5e-7, -5e-7}) {
    EXPECT_EQ(refusal("pm", {10, 0}, {7 * off, 7}), "");
    EXPECT_EQ(refusal("cm", {10, 0}, (1 + off) * Vec2(6, 8)), "");
    EXPECT_EQ(refusal("p4", {10, 0}, {0, 10 + 10 * off}), "");
    EXPECT_EQ(refusal("p6", {10, 0}, (10 + 10 * off) * unit(kPi / 3)), "");
    EXPECT_NE(refusal("pm", {10, 0}, {70 * off, 7}), "");
    EXPECT_NE(refusal("cm", {10, 0}, (1 + 10 * off) * Vec2(6, 8)), "");
    EXPECT_NE(refusal("p4", {10, 0}, {0, 10 + 100 * off}), "");
    EXPECT_NE(refusal("p6", {10, 0}, (10 + 100 * off) * unit(kPi / 3)), "");
  }
}

}  // namespace
}  // namespace seamwise
