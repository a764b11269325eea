#include "alignment/model/symmetric.h"

#include <gtest/gtest.h>

#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::asymmetry;
using testing::kExact;
using testing::Random;
using testing::sampleGroup;

std::vector<GroupData> groupsThat(bool (*carry)(const WallpaperGroup&)) {
  std::vector<GroupData> found;
  for (const GroupData& data : wallpaperGroups()) {
    if (carry(sampleGroup(data))) found.push_back(data);
  }
  return found;
}

const auto kNameOfGroup = [](const auto& test) { return std::string(test.param.name); };

class Pair : public ::testing::TestWithParam<GroupData> {
 protected:
  WallpaperGroup group_ = sampleGroup(GetParam(), -0.83);
  Random random_{21};
};

INSTANTIATE_TEST_SUITE_P(SymmetricAlignment, Pair,
                         ::testing::ValuesIn(groupsThat([](const WallpaperGroup& group) {
                           return group.carriesPair();
                         })),
                         kNameOfGroup);

class Single : public Pair {
 protected:
  /// The piece's own reflection as a motion of the print.
  static RigidMotion inPrint(const Alignment& alignment, const RigidMotion& map) {
    const RigidMotion to_piece{alignment.angle, alignment.translation, false};
    return to_piece.inverse().after(map.after(to_piece));
  }
};

INSTANTIATE_TEST_SUITE_P(SymmetricAlignment, Single,
                         ::testing::ValuesIn(groupsThat([](const WallpaperGroup& group) {
                           return group.carriesSingle();
                         })),
                         kNameOfGroup);

TEST(SymmetricAlignment, IsThereForTwelveGroupsOfPairsAndTenOfSinglePieces) {
  EXPECT_EQ(groupsThat([](const WallpaperGroup& g) { return g.carriesPair(); }).size(), 12u);
  EXPECT_EQ(groupsThat([](const WallpaperGroup& g) { return g.carriesSingle(); }).size(), 10u);
}

TEST_P(Pair, ShowsEveryPointOfTheImageTheMirroredPrintOfItsSource) {
  for (int k = 0; k < 30; ++k) {
    const Alignment first = random_.alignment();
    const RigidMotion map = random_.glide();
    for (const Element& e : group_.elements()) {
      if (!e.mirrored) continue;
      EXPECT_LT(asymmetry(group_, first, mirrorImage(first, map, e), map), kExact);
    }
    EXPECT_GT(asymmetry(group_, first, random_.alignment(), map), 0.1) << "it could not fail";
  }
}

TEST_P(Pair, HasTheSamePrintWhicheverReversingElementMakesIt) {
  const Alignment first = random_.alignment();
  const RigidMotion map = random_.glide();
  std::vector<Alignment> images;
  for (const Element& e : group_.elements()) {
    if (e.mirrored) images.push_back(mirrorImage(first, map, e));
  }
  for (const Alignment& other : images) {
    for (int k = 0; k < 10; ++k) {
      const Vec2 p = random_.point();
      EXPECT_LT(testing::distanceByHalf(group_, images[0].toPrint(p), other.toPrint(p), false),
                kExact);
    }
  }
}

TEST_P(Pair, FindsTheSourceOfAnImage) {
  for (int k = 0; k < 10; ++k) {
    const Alignment first = random_.alignment();
    const RigidMotion map = random_.glide();
    for (const Element& e : group_.elements()) {
      if (!e.mirrored) continue;
      const Alignment back = mirrorSource(mirrorImage(first, map, e), map, e);
      EXPECT_NEAR(wrapAngle(back.angle - first.angle), 0, kExact);
      EXPECT_LT((back.translation - first.translation).norm(), kExact);
    }
  }
}

TEST_P(Pair, TurnsTheOtherWayAndShiftsAsTheMirrorDoes) {
  const Alignment first = random_.alignment();
  const RigidMotion map = random_.glide();
  const Vec2 shift(0.3, -0.2);
  for (const Element& e : group_.elements()) {
    if (!e.mirrored) continue;
    const Alignment image = mirrorImage(first, map, e);
    const Alignment turned = mirrorImage({first.angle + 0.1, first.translation}, map, e);
    EXPECT_NEAR(wrapAngle(turned.angle - image.angle), -0.1, kExact);
    const Alignment shifted = mirrorSource({image.angle, image.translation + shift}, map, e);
    EXPECT_LT((shifted.translation - first.translation - map.linear().transpose() * shift).norm(),
              kExact);
  }
}

TEST_P(Single, ShowsEveryPointOfThePieceTheMirroredPrintOfItsTwin) {
  for (int k = 0; k < 100; ++k) {
    const RigidMotion map = random_.reflection();
    const Alignment wanted = random_.alignment();
    const Alignment snapped = snapToMirror(wanted, map, random_.point(), group_);
    EXPECT_LT(asymmetry(group_, snapped, snapped, map), kExact);
    EXPECT_GT(asymmetry(group_, wanted, wanted, map), 1e-3) << "it could not fail";
  }
}

TEST_P(Single, LeavesASymmetricAlignmentWhereItIs) {
  for (int k = 0; k < 20; ++k) {
    const RigidMotion map = random_.reflection();
    const Alignment once = snapToMirror(random_.alignment(), map, random_.point(), group_);
    const Alignment twice = snapToMirror(once, map, random_.point(), group_);
    EXPECT_NEAR(wrapAngle(twice.angle - once.angle), 0, kExact);
    EXPECT_LT((twice.translation - once.translation).norm(), kExact);
  }
}

TEST_P(Single, TurnsNoFurtherThanToTheNearestMirrorDirection) {
  for (int k = 0; k < 20; ++k) {
    const RigidMotion map = random_.reflection();
    const Alignment wanted = random_.alignment();
    const double turned = std::abs(
        wrapAngle(snapToMirror(wanted, map, random_.point(), group_).angle - wanted.angle));
    // All mirror directions, from the elements and not from the table: those for which some lattice
    // vector leaves no glide.
    double least = kPi;
    for (const Element& e : group_.elements()) {
      if (!e.mirrored) continue;
      bool mirror = false;
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          const Vec2 shift = e.a + i * group_.w1() + j * group_.w2();
          mirror = mirror || std::abs(shift.dot(unit(e.angle / 2))) < kExact;
        }
      }
      if (!mirror) continue;
      const double axis = (map.angle - kPi) / 2;
      least = std::min(least, std::abs(std::remainder(axis - e.angle / 2 - wanted.angle, kPi)));
    }
    EXPECT_NEAR(turned, least, kExact);
    EXPECT_LE(turned, kPi / 2 + kExact);
  }
}

TEST_P(Single, ShiftsAcrossTheAxisOnlyAndNoFurtherThanToTheNearestMirrorLine) {
  for (int k = 0; k < 20; ++k) {
    const RigidMotion map = random_.reflection();
    const Vec2 pivot = random_.point(), q = (pivot + map(pivot)) / 2;
    const Alignment wanted = random_.alignment();
    const Alignment snapped = snapToMirror(wanted, map, pivot, group_);
    const Vec2 turned_only = q + rotation(snapped.angle - wanted.angle) * (wanted.translation - q);
    const Vec2 shift = snapped.translation - turned_only;
    EXPECT_NEAR(shift.dot(unit((map.angle - kPi) / 2)), 0, kExact);
    // All mirror lines of that direction near the axis, from the elements.
    const Vec2 axis_point = rotation(-snapped.angle) * (q - turned_only);
    const RigidMotion reflection = inPrint(snapped, map);
    double least = std::numeric_limits<double>::infinity();
    for (const Element& e : group_.elements()) {
      if (!e.mirrored || (e.A - reflection.linear()).norm() > kExact) continue;
      const Vec2 along = unit(e.angle / 2), across = perp(along);
      for (int i = -60; i <= 60; ++i) {
        for (int j = -60; j <= 60; ++j) {
          const Vec2 moved = e.a + i * group_.w1() + j * group_.w2();
          if (std::abs(moved.dot(along)) > kExact) continue;
          least = std::min(least, std::abs(across.dot(moved / 2 - axis_point)));
        }
      }
    }
    EXPECT_NEAR(shift.norm(), least, kExact);
  }
}

TEST(SymmetricAlignment, IsRefusedByGroupsWithoutTheReversingElementsForIt) {
  for (const char* name : {"p1", "p2", "p3", "p4", "p6"}) {
    const WallpaperGroup group = sampleGroup(*findGroup(name));
    EXPECT_FALSE(group.carriesPair() || group.carriesSingle()) << name;
    for (const Element& e : group.elements()) EXPECT_FALSE(e.mirrored) << name;
  }
  // A glide carries a pair, but not a single piece: no line along it is a mirror.
  for (const char* name : {"pg", "pgg"}) {
    const WallpaperGroup group = sampleGroup(*findGroup(name));
    EXPECT_TRUE(group.carriesPair() && !group.carriesSingle()) << name;
    for (const double angle : {0.0, kPi / 2}) {
      for (double at = 0; at < 10; at += 0.125) {
        const Vec2 p(at, at);
        const RigidMotion map = RigidMotion::reflection(p, p + unit(angle));
        EXPECT_GT(asymmetry(group, {}, {}, map), 0.1) << name;
        const Alignment same = snapToMirror({0.2, p}, map, p, group);
        EXPECT_TRUE(same.angle == 0.2 && same.translation == p) << name;
      }
    }
  }
}

TEST(SymmetricAlignment, NeverPutsAnAxisOnAGlideOfP4gOrCm) {
  // Almost on the glide line v = 1/4 of p4g, along w1: the nearest mirrors are the diagonals.
  const WallpaperGroup p4g = sampleGroup(*findGroup("p4g"));
  const RigidMotion map = RigidMotion::reflection({0, 2.5}, {1, 2.5});
  const Alignment snapped = snapToMirror({0.01, {0, 0}}, map, {0, 2.5}, p4g);
  EXPECT_NEAR(std::abs(snapped.angle), kPi / 4, kExact);
  EXPECT_LT(asymmetry(p4g, snapped, snapped, map), kExact);
  // A line on the glide v - u = 1/2 of cm, along w1 + w2 = (16, 8): half the spacing away on either
  // side.
  const WallpaperGroup cm = sampleGroup(*findGroup("cm"));
  const RigidMotion diagonal = RigidMotion::reflection({5.1, 0}, {5.1 + 16, 8});
  const Alignment moved = snapToMirror({}, diagonal, {5.1, 0}, cm);
  const double spacing = 80 / std::hypot(16, 8);
  EXPECT_NEAR(moved.translation.norm(), spacing / 2 - 0.1 * 8 / std::hypot(16, 8), kExact);
  EXPECT_LT(asymmetry(cm, moved, moved, diagonal), kExact);
}

}  // namespace
}  // namespace seamwise
