// Wolff et al. 2019, Eqs. (4)-(7) and E_sym as printed, evaluated at sample points. The tests show
// the groups and lattices for which they hold under the paper's own p_wp = R^T (p - t). They
// explain why the program computes the alignment from an element of the group instead.
#include <gtest/gtest.h>

#include <set>

#include "alignment/model/symmetric.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::asymmetry;
using testing::kExact;
using testing::Random;
using testing::sampleGroup;

using Names = std::set<std::string_view>;

const Names kPairGroups{"pm",  "pg",  "cm",  "pmm",  "pmg",  "pgg",
                        "cmm", "p4m", "p4g", "p3m1", "p31m", "p6m"};
const Names kTurnedGroups{"cm", "cmm", "p3m1"};  // "CM, CMM, C3M1" in Eq. 5

/// Variants of Eqs. (5) and (7).
struct Reading {
  double sense_of_eq5 = 1;  ///< +1 as printed: rot(angle(w1, w2)); 0: no rotation; -1: the inverse
  Names turned = kTurnedGroups;
  bool eq7 = true;
  double extra_turn = 0;  ///< added to R_g
};

/// R'_c and t'_c of Eqs. (4)-(7) for the first piece's alignment and the pair's (R_sym, t_sym).
Alignment paperImage(const WallpaperGroup& group, const Alignment& first, const RigidMotion& map,
                     const Reading& reading) {
  const std::string_view name = group.data().name;
  const Vec2 &w1 = group.w1(), &w2 = group.w2();
  const double between = std::atan2(cross(w1, w2), w1.dot(w2));
  const double turn_g =  // Eq. 5
      (reading.turned.contains(name) ? reading.sense_of_eq5 * between : 0) + reading.extra_turn;
  const Mat2 r_sym = rotation(map.angle), r_pi = rotation(kPi), r_c = rotation(first.angle);
  const Mat2 r = rotation(turn_g) * r_sym * r_pi * r_c.transpose();  // Eq. 4
  Vec2 half = Vec2::Zero();                                          // Eq. 7
  if (name == "pg") half = w1 / 2;
  if (name == "pmg") half = w2 / 2;
  if (name == "pgg" || name == "p4g") half = (w1 + w2) / 2;
  Vec2 t_g = Vec2::Zero();
  if (reading.eq7) t_g = r * half;
  const Mat2 flip = Vec2(-1, 1).asDiagonal();
  return {std::atan2(r(1, 0), r(0, 0)), t_g + r_sym * flip * first.translation + map.shift};
}

/// Returns whether random pairs become symmetric; either all do or none.
bool holds(const WallpaperGroup& group, const Reading& reading) {
  Random random(31);
  int symmetric = 0;
  for (int k = 0; k < 20; ++k) {
    const Alignment first = random.alignment();
    const RigidMotion map = random.glide();
    const double off = asymmetry(group, first, paperImage(group, first, map, reading), map);
    EXPECT_TRUE(off < kExact || off > 0.1) << group.data().name << ": neither, " << off << " cm";
    if (off < kExact) ++symmetric;
  }
  EXPECT_TRUE(symmetric == 0 || symmetric == 20) << group.data().name;
  return symmetric == 20;
}

/// Groups that carry a pair and for which the formulas hold on a lattice with w1 at `turn`.
Names holdsFor(const Reading& reading, double turn = 0) {
  Names names;
  for (const std::string_view name : kPairGroups) {
    if (holds(sampleGroup(*findGroup(name), turn), reading)) names.insert(name);
  }
  return names;
}

Names without(Names names, const Names& removed) {
  for (const std::string_view name : removed) names.erase(name);
  return names;
}

TEST(PaperFormulas, HoldAsPrintedForW1OnTheXAxisSaveForCmAndCmm) {
  EXPECT_EQ(holdsFor({}), without(kPairGroups, {"cm", "cmm"}));
}

TEST(PaperFormulas, HoldForEveryGroupWithW1OnTheXAxisOnceEquation5TurnsTheOtherWay) {
  Reading inverse;
  inverse.sense_of_eq5 = -1;
  EXPECT_EQ(holdsFor(inverse), kPairGroups);
}

TEST(PaperFormulas, NeedTheTurnOfEquation5ForP3m1SoThatC3m1IsP3m1AndNotP31m) {
  Reading none;
  none.sense_of_eq5 = 0;
  EXPECT_EQ(holdsFor(none), without(kPairGroups, kTurnedGroups));
  Reading other;
  other.turned = {"cm", "cmm", "p31m"};
  for (const double sense : {1.0, -1.0}) {
    other.sense_of_eq5 = sense;
    const Names found = holdsFor(other);
    EXPECT_FALSE(found.contains("p31m") || found.contains("p3m1"));
  }
}

TEST(PaperFormulas, NeedTheShiftOfEquation7InTheFourGroupsItNames) {
  Reading unshifted;
  unshifted.sense_of_eq5 = -1;
  unshifted.eq7 = false;
  EXPECT_EQ(holdsFor(unshifted), without(kPairGroups, {"pg", "pmg", "pgg", "p4g"}));
}

TEST(PaperFormulas, HoldForCmmAsPrintedOnlyOnASquareLattice) {
  // Here the other mirrors of cmm are where Eq. 5 turns to; cm has no others.
  const auto on_square = [](std::string_view name) {
    return holds(WallpaperGroup::make(name, {10, 0}, {0, 10}).value(), {});
  };
  EXPECT_TRUE(on_square("cmm"));
  EXPECT_FALSE(on_square("cm"));
}

TEST(PaperFormulas, HoldForNoGroupAsPrintedWhenW1IsNotOnTheXAxis) {
  Reading inverse;
  inverse.sense_of_eq5 = -1;
  for (const double turn : {0.3, -1.2, 2.0}) {
    EXPECT_EQ(holdsFor({}, turn), Names{});
    EXPECT_EQ(holdsFor(inverse, turn), Names{});
    // Turned back by twice the angle of w1, Eq. 4 is right on every lattice.
    inverse.extra_turn = -2 * turn;
    EXPECT_EQ(holdsFor(inverse, turn), kPairGroups);
    inverse.extra_turn = 0;
  }
}

TEST(PaperFormulas, HoldOffTheXAxisOnlyWhereAnotherAxisOfTheGroupFallsOnIt) {
  EXPECT_EQ(holdsFor({}, kPi / 2), Names({"pmm", "pmg", "pgg", "p4m", "p4g", "p6m"}));
  EXPECT_EQ(holdsFor({}, kPi / 4), Names({"p4m", "p4g"}));
  EXPECT_EQ(holdsFor({}, kPi / 6), Names({"p6m"}));
}

TEST(PaperFormulas, AgreeWithTheRuleByElementsWhereTheyHold) {
  Random random(8);
  Reading inverse;
  inverse.sense_of_eq5 = -1;
  for (const std::string_view name : kPairGroups) {
    const WallpaperGroup group = sampleGroup(*findGroup(name));
    const Alignment first = random.alignment();
    const RigidMotion map = random.glide();
    const Alignment paper = paperImage(group, first, map, inverse);
    bool same = false;
    for (const Element& e : group.elements()) {
      if (!e.mirrored) continue;
      const Alignment ours = mirrorImage(first, map, e);
      const Vec2 between = rotation(-ours.angle) * (paper.translation - ours.translation);
      same = same || (std::abs(wrapAngle(paper.angle - ours.angle)) < kExact &&
                      group.reduce(between).norm() < kExact);
    }
    EXPECT_TRUE(same) << name;
  }
}

/// E_sym of the paper as printed, sum |b - (R_sym F b' + t_sym)|^2, and with b and b' swapped to
/// agree with its Eq. 3, for vertices b' to which Eq. 3 maps b. [cm^2]
struct SymmetryEnergies {
  double printed = 0, swapped = 0;
};
SymmetryEnergies energies(const RigidMotion& map, int vertices) {
  Random random(17);
  SymmetryEnergies sum;
  for (int k = 0; k < vertices; ++k) {
    const Vec2 b = random.point(), b_mirrored = map(b);
    sum.printed += (b - map(b_mirrored)).squaredNorm();
    sum.swapped += (b_mirrored - map(b)).squaredNorm();
  }
  return sum;
}

TEST(PaperFormulas, HaveASymmetryEnergyThatVanishesForReflectionsAndNotForPairsWithAGlide) {
  Random random(4);
  for (int k = 0; k < 10; ++k) {
    const RigidMotion reflection = random.reflection();
    EXPECT_NEAR(energies(reflection, 30).printed, 0, kExact);
    RigidMotion glide = reflection;
    const double along = random.between(0.5, 20);
    glide.shift += along * unit((reflection.angle - kPi) / 2);
    const SymmetryEnergies e = energies(glide, 30);
    EXPECT_EQ(e.swapped, 0);
    // The map applied twice is a shift by twice the glide, at every vertex.
    EXPECT_NEAR(e.printed, 30 * 4 * along * along, 1e-6);
  }
}

}  // namespace
}  // namespace seamwise
