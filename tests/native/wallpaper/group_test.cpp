#include "wallpaper/group.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <set>

#include "support/print_samples.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

using testing::distanceByHalf;
using testing::isSymmetryOfPrint;
using testing::kExact;
using testing::Random;
using testing::sampleGroup;

/// One group of the 17 on a lattice that is not aligned with the axes.
class EveryGroup : public ::testing::TestWithParam<GroupData> {
 protected:
  const GroupData& data() const { return GetParam(); }
  WallpaperGroup group_ = sampleGroup(GetParam(), 0.37);
  Random random_{7};

  Vec2 fromLattice(double u, double v) const { return u * group_.w1() + v * group_.w2(); }
  Vec2 toLattice(const Vec2& p) const {
    return (Mat2() << group_.w1(), group_.w2()).finished().inverse() * p;
  }
  Vec2 direction(const MirrorFamily& family) const {
    return fromLattice(family.direction[0], family.direction[1]);
  }
  /// A point of the line h . (u, v) = constant.
  Vec2 pointOf(const MirrorFamily& family, double constant) const {
    const double h1 = -family.direction[1], h2 = family.direction[0];
    const double scale = constant / (h1 * h1 + h2 * h2);
    return fromLattice(h1 * scale, h2 * scale);
  }
  bool lists(const MirrorFamilies& families, const Vec2& axis, const Vec2& point) const {
    for (const MirrorFamily& family : families) {
      if (std::abs(cross(direction(family).normalized(), axis)) > kExact) continue;
      const Vec2 uv = toLattice(point);
      const double line = -family.direction[1] * uv.x() + family.direction[0] * uv.y();
      for (const double constant : family.constants) {
        if (std::abs(std::remainder(line - constant, 1.0)) < kExact) return true;
      }
    }
    return false;
  }
};

INSTANTIATE_TEST_SUITE_P(Wallpaper, EveryGroup, ::testing::ValuesIn(wallpaperGroups()),
                         [](const auto& test) { return std::string(test.param.name); });

RigidMotion motionOf(const Element& e, const Vec2& lattice_vector = Vec2::Zero()) {
  // R(angle) diag(1, -1) = R(angle + pi) F
  return {e.mirrored ? e.angle + kPi : e.angle, e.a + lattice_vector, e.mirrored};
}

TEST_P(EveryGroup, JoinsByItsTurnsOnlyWhereNothingMayBeMirrored) {
  EXPECT_EQ(group_.joining(false), group_);
  const WallpaperGroup turns = group_.joining(true);
  for (int k = 0; k < 50; ++k) {
    const Vec2 x = random_.point(), y = random_.point();
    double least = std::numeric_limits<double>::infinity();
    for (const Element& e : group_.elements())
      if (!e.mirrored) least = std::min(least, group_.reduce(x - e(y)).norm());
    EXPECT_NEAR(turns.distance(x, y), least, kExact);
  }
}

TEST(WallpaperTable, HoldsThe17GroupsWithTheirKnownOrders) {
  std::set<std::string_view> names;
  int cosets_in_all = 0;
  for (const GroupData& data : wallpaperGroups()) {
    names.insert(data.name);
    cosets_in_all += data.order;
  }
  EXPECT_EQ(names.size(), 17u);
  EXPECT_EQ(cosets_in_all, 1 + 2 + 3 * 2 + 4 * 4 + 4 + 8 + 8 + 3 + 6 + 6 + 6 + 12);
}

TEST(WallpaperTable, NamesTheGroupsThatCarrySymmetricPiecesAndPairs) {
  EXPECT_EQ(groupsForSingle(), "pm, cm, pmm, pmg, cmm, p4m, p4g, p3m1, p31m, p6m");
  EXPECT_EQ(groupsForPair(), "pm, pg, cm, pmm, pmg, pgg, cmm, p4m, p4g, p3m1, p31m, p6m");
}

TEST_P(EveryGroup, ClosesAtItsOrderWithOneElementPerLinearPart) {
  const auto all = cosets(data());
  EXPECT_EQ(static_cast<int>(all.size()), data().order);
  EXPECT_EQ(static_cast<int>(group_.elements().size()), data().order);
  std::set<std::array<int, 4>> linear_parts;
  for (const LatticeElement& e : all) {
    linear_parts.insert(e.m);
    EXPECT_EQ(std::abs(e.det()), 1);
    for (const double x : e.a) EXPECT_TRUE(x >= 0 && x < 1);
  }
  EXPECT_EQ(linear_parts.size(), all.size());
}

TEST_P(EveryGroup, IsAGroupOfRigidMotionsModuloTranslations) {
  const auto& elements = group_.elements();
  EXPECT_TRUE(elements[0].A.isIdentity() && elements[0].a.isZero() && !elements[0].mirrored);
  for (const Element& e : elements) {
    EXPECT_LT((e.A * e.A.transpose() - Mat2::Identity()).norm(), 1e-14);
    EXPECT_EQ(e.A.determinant() < 0, e.mirrored);
    EXPECT_LT((e.A - motionOf(e).linear()).norm(), 1e-14) << "angle and matrix disagree";
    EXPECT_TRUE(isSymmetryOfPrint(group_, motionOf(e).inverse()));
    for (const Vec2& w : {group_.w1(), group_.w2()}) {
      EXPECT_LT(group_.reduce(e.A * w).norm(), kExact) << "the lattice is not kept";
    }
    for (const Element& f : elements) {
      EXPECT_TRUE(isSymmetryOfPrint(group_, motionOf(e).after(motionOf(f))));
    }
  }
}

TEST_P(EveryGroup, MeasuresAMetricOnPrintPoints) {
  for (int k = 0; k < 200; ++k) {
    const Vec2 x = random_.point(), y = random_.point(), z = random_.point();
    const double xy = group_.distance(x, y);
    EXPECT_NEAR(xy, group_.distance(y, x), kExact);
    EXPECT_LE(xy, (x - y).norm() + kExact);
    EXPECT_LE(group_.distance(x, z), xy + group_.distance(y, z) + kExact);
  }
}

TEST_P(EveryGroup, MeasuresNothingWithinAnOrbitAndTheSameForAllItsPoints) {
  for (int k = 0; k < 20; ++k) {
    const Vec2 x = random_.point(), y = random_.point();
    const double before = group_.distance(x, y);
    const Vec2 shift = fromLattice(3 * k - 30, 11 - 2 * k);
    for (const Element& e : group_.elements()) {
      EXPECT_LT(group_.distance(e(y) + shift, y), kExact);
      EXPECT_NEAR(group_.distance(x, e(y) + shift), before, kExact);
      EXPECT_NEAR(group_.distance(e(x) + shift, y), before, kExact);
    }
  }
}

TEST_P(EveryGroup, FindsTheNearestEquivalentPointThatASearchOfManyCellsFinds) {
  for (int k = 0; k < 50; ++k) {
    const Vec2 x = random_.between(0.05, 0.4) * random_.point();
    const Vec2 y = random_.between(0.05, 0.4) * random_.point();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Element& e : group_.elements()) {
      for (int i = -9; i <= 9; ++i) {
        for (int j = -9; j <= 9; ++j) {
          nearest = std::min(nearest, (x - e(y) - fromLattice(i, j)).norm());
        }
      }
    }
    EXPECT_NEAR(group_.distance(x, y), nearest, kExact);
    EXPECT_NEAR(std::min(distanceByHalf(group_, x, y, false), distanceByHalf(group_, x, y, true)),
                nearest, kExact);
  }
}

TEST_P(EveryGroup, HasATrueMirrorOnEveryListedMirrorLine) {
  for (const MirrorFamily& family : data().mirrors) {
    for (const double constant : family.constants) {
      for (const double line : {constant, constant + 1, constant - 2}) {
        const Vec2 p = pointOf(family, line);
        EXPECT_TRUE(isSymmetryOfPrint(group_, RigidMotion::reflection(p, p + direction(family))));
      }
      // No group has one a quarter of the spacing further.
      const Vec2 q = pointOf(family, constant + 0.25);
      EXPECT_FALSE(isSymmetryOfPrint(group_, RigidMotion::reflection(q, q + direction(family))));
    }
  }
}

TEST_P(EveryGroup, GlidesByHalfARepeatAlongEveryListedGlideLineAndHasNoMirrorThere) {
  for (const MirrorFamily& family : data().glides) {
    const Vec2 d = direction(family);
    for (const double constant : family.constants) {
      const Vec2 p = pointOf(family, constant);
      const RigidMotion reflection = RigidMotion::reflection(p, p + d);
      EXPECT_FALSE(isSymmetryOfPrint(group_, reflection));
      RigidMotion glide = reflection;
      glide.shift += d / 2;
      EXPECT_TRUE(isSymmetryOfPrint(group_, glide));
    }
  }
}

TEST_P(EveryGroup, ListsEveryMirrorAndEveryGlideAxisThatItsElementsHave) {
  for (const Element& e : group_.elements()) {
    if (!e.mirrored) continue;
    const Vec2 axis = unit(e.angle / 2);
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        const Vec2 shift = e.a + fromLattice(i, j);
        const double along = shift.dot(axis);
        const Vec2 on_axis = (shift - along * axis) / 2;
        const bool mirror = lists(data().mirrors, axis, on_axis);
        const bool glide = lists(data().glides, axis, on_axis);
        EXPECT_TRUE(mirror || std::abs(along) > kExact) << "a mirror is not in the table";
        EXPECT_NE(mirror, glide) << "an axis is a mirror or a mere glide";
      }
    }
  }
}

TEST_P(EveryGroup, CarriesAPieceByAMirrorAndAPairByAnyReversingElement) {
  bool reversing = false;
  for (const Element& e : group_.elements()) reversing = reversing || e.mirrored;
  EXPECT_EQ(group_.carriesPair(), reversing);
  EXPECT_EQ(group_.carriesSingle(), !data().mirrors.empty());
  EXPECT_TRUE(group_.carriesPair() || !group_.carriesSingle());
}

TEST_P(EveryGroup, TurnsAndScalesWithItsLattice) {
  const double scale = 2.5, turn = 1.1;
  const auto larger = WallpaperGroup::make(data().name, scale * rotation(turn) * group_.w1(),
                                           scale * rotation(turn) * group_.w2());
  ASSERT_TRUE(larger.ok());
  for (int k = 0; k < 20; ++k) {
    const Vec2 x = random_.point(), y = random_.point();
    EXPECT_NEAR(larger.value().distance(scale * rotation(turn) * x, scale * rotation(turn) * y),
                scale * group_.distance(x, y), kExact);
  }
}

TEST(WallpaperTable, HasItsMirrorsAtThePapersAnglesAndOnlyCmAndCmmAtAnglesOfTheLattice) {
  // Wolff et al. 2019, Fig. 4, with w1 on the x-axis; here |w1| = |w2| at 53.13 degrees for
  // rhombic.
  const double rhombic = std::atan2(8, 6) * 90 / kPi;
  const std::vector<std::pair<std::string_view, std::set<double>>> expected{
      {"pm", {0}},
      {"pmm", {0, 90}},
      {"pmg", {0}},
      {"cm", {rhombic}},
      {"cmm", {rhombic, rhombic + 90}},
      {"p4m", {0, 45, 90, 135}},
      {"p4g", {45, 135}},
      {"p3m1", {30, 90, 150}},
      {"p31m", {0, 60, 120}},
      {"p6m", {0, 30, 60, 90, 120, 150}}};
  for (const auto& [name, degrees] : expected) {
    const WallpaperGroup group = sampleGroup(*findGroup(name));
    std::set<long> found, wanted;
    for (const MirrorFamily& f : group.data().mirrors) {
      const Vec2 d = f.direction[0] * group.w1() + f.direction[1] * group.w2();
      const double angle = std::atan2(d.y(), d.x()) * 180 / kPi;
      found.insert(std::lround((angle < -1e-9 ? angle + 180 : angle) * 1000));
    }
    for (const double angle : degrees) wanted.insert(std::lround(angle * 1000));
    EXPECT_EQ(found, wanted) << name;
  }
}

}  // namespace
}  // namespace seamwise
