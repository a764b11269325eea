#include "alignment/model/admissible_alignments.h"

#include <gtest/gtest.h>

#include "alignment/model/symmetric.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::asymmetry;
using testing::kExact;
using testing::Random;
using testing::sampleGroup;

void expectSame(const Alignment& a, const Alignment& b) {
  EXPECT_LT(std::abs(wrapAngle(a.angle - b.angle)), kExact);
  EXPECT_LT((a.translation - b.translation).norm(), 1e-7);
}

/// Least distance of an angle from a set of angles. [rad]
double offAngles(double angle, const std::vector<double>& angles) {
  double off = kPi;
  for (double a : angles) off = std::min(off, std::abs(wrapAngle(angle - a)));
  return off;
}

TEST(AdmissibleAlignments, ThatIsUnboundKeepsEveryWish) {
  Random random(1);
  const AdmissibleAlignments free = AdmissibleAlignments::anywhere();
  EXPECT_TRUE(free.mayRotate());
  for (int k = 0; k < 10; ++k) {
    const Alignment wish = random.alignment();
    expectSame(free.nearest(wish, random.point()), wish);
    EXPECT_EQ(free.basis(wish).cols(), 3);
  }
}

TEST(AdmissibleAlignments, ThatIsPinnedAlwaysGivesThePin) {
  Random random(2);
  const Alignment pin = random.alignment();
  const AdmissibleAlignments pinned = AdmissibleAlignments::pinned(pin);
  EXPECT_TRUE(pinned.isPinned());
  EXPECT_FALSE(pinned.mayRotate());
  for (int k = 0; k < 10; ++k) {
    const Alignment got = pinned.nearest(random.alignment(), random.point());
    EXPECT_EQ(got.angle, pin.angle);
    EXPECT_EQ(got.translation, pin.translation);
    EXPECT_EQ(pinned.basis(got).cols(), 0);
  }
}

TEST(AdmissibleAlignments, OnGrainTurnsByTheLeastAngleAboutTheGivenPoint) {
  Random random(3);
  for (const std::vector<double>& angles :
       {std::vector<double>{0.3}, std::vector<double>{0.3, 0.3 + kPi}}) {
    for (double tolerance : {0.0, 0.1}) {
      AdmissibleAlignments grain;
      ASSERT_TRUE(grain.restrictAngles(angles, tolerance));
      EXPECT_EQ(grain.mayRotate(), tolerance > 0);
      EXPECT_EQ(grain.basis({}).cols(), tolerance > 0 ? 3 : 2);
      for (int k = 0; k < 50; ++k) {
        const Alignment wish = random.alignment();
        const Vec2 centre = random.point();
        const Alignment got = grain.nearest(wish, centre);
        EXPECT_LT(offAngles(got.angle, angles), tolerance + kExact);
        EXPECT_NEAR(std::abs(wrapAngle(got.angle - wish.angle)),
                    std::max(0.0, offAngles(wish.angle, angles) - tolerance), kExact);
        EXPECT_LT((got.toPrint(centre) - wish.toPrint(centre)).norm(), kExact);
        expectSame(grain.nearest(got, centre), got);
      }
    }
  }
}

TEST(AdmissibleAlignments, OfAOneWayPrintNeverTurnsAPieceUpsideDown) {
  Random random(4);
  AdmissibleAlignments one_way;
  ASSERT_TRUE(one_way.restrictAngles({0}, 0.05));
  for (int k = 0; k < 50; ++k)
    EXPECT_LT(std::abs(one_way.nearest(random.alignment(), random.point()).angle), 0.05 + kExact);
}

class MirroredFreedom : public ::testing::TestWithParam<GroupData> {
 protected:
  WallpaperGroup group_ = sampleGroup(GetParam(), 0.6);
  Random random_{5};
};

INSTANTIATE_TEST_SUITE_P(All, MirroredFreedom, ::testing::ValuesIn([] {
                           std::vector<GroupData> found;
                           for (const GroupData& data : wallpaperGroups())
                             if (!data.mirrors.empty()) found.push_back(data);
                           return found;
                         }()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(MirroredFreedom, LaysTheAxisOnAMirrorLineAsNearAsCanBe) {
  for (int k = 0; k < 20; ++k) {
    const RigidMotion map = random_.reflection();
    const AdmissibleAlignments admissible = AdmissibleAlignments::mirrored(map, group_);
    EXPECT_TRUE(admissible.isMirrored());
    EXPECT_FALSE(admissible.mayRotate());
    const Alignment wish = random_.alignment();
    const Vec2 centre = random_.point();
    const Alignment got = admissible.nearest(wish, centre);
    EXPECT_LT(asymmetry(group_, got, got, map), kExact);
    expectSame(got, snapToMirror(wish, map, centre, group_));
    expectSame(admissible.nearest(got, centre), got);
  }
}

TEST_P(MirroredFreedom, KeepsTheAxisOnTheMirrorLineWhereverItSlides) {
  const RigidMotion map = random_.reflection();
  const AdmissibleAlignments admissible = AdmissibleAlignments::mirrored(map, group_);
  ASSERT_FALSE(admissible.places().empty());
  for (const AdmissibleAlignments::Place& place : admissible.places()) {
    for (int k = 0; k < 5; ++k) {
      const Vec2 centre = random_.point();
      const double slide = random_.between(-20, 20);
      const Alignment at = admissible.onPlace(place, centre, slide);
      EXPECT_LT(asymmetry(group_, at, at, map), kExact);
      const auto basis = admissible.basis(at);
      ASSERT_EQ(basis.cols(), 1);
      const Eigen::Vector3d d = 3.7 * basis.col(0);
      const Alignment slid = moved(at, centre, d.x(), d.tail<2>());
      EXPECT_LT(asymmetry(group_, slid, slid, map), kExact);
      EXPECT_GT((slid.translation - at.translation).norm(), 3) << "it could not fail";
    }
  }
}

TEST_P(MirroredFreedom, RepeatsItsPrintAfterOnePeriodAlongTheLine) {
  const AdmissibleAlignments admissible =
      AdmissibleAlignments::mirrored(random_.reflection(), group_);
  for (const AdmissibleAlignments::Place& place : admissible.places()) {
    const Vec2 centre = random_.point(), p = random_.point();
    const Alignment here = admissible.onPlace(place, centre, 1.3);
    const Alignment next = admissible.onPlace(place, centre, 1.3 + place.period);
    EXPECT_LT(group_.reduce(here.toPrint(p) - next.toPrint(p)).norm(), kExact);
  }
}

TEST_P(MirroredFreedom, MissesNoPrintThatTheSymmetryAllows) {
  // Any admissible alignment shows the print of one of the places, at some slide: a rotation of the
  // print maps one onto the other.
  const RigidMotion map = random_.reflection();
  const AdmissibleAlignments admissible = AdmissibleAlignments::mirrored(map, group_);
  const Vec2 centre = random_.point();
  for (int k = 0; k < 30; ++k) {
    const Alignment got = admissible.nearest(random_.alignment(), centre);
    const Vec2 foot = (centre + map(centre)) / 2;
    bool found = false;
    for (const AdmissibleAlignments::Place& place : admissible.places()) {
      for (const Element& e : group_.elements()) {
        if (e.mirrored) continue;
        // slide at which the axis points would coincide if this element is the right one
        const Vec2 off = group_.reduce(e(got.toPrint(foot)) - place.on_line);
        for (int line = -3; line <= 3; ++line) {
          const double slide = off.dot(place.along) + line * place.period / 2;
          const Alignment other = admissible.onPlace(place, centre, slide);
          bool same = true;
          for (const Vec2& p : {Vec2(0, 0), Vec2(7, 2), Vec2(-3, 11)})
            same &= group_.reduce(e(got.toPrint(p)) - other.toPrint(p)).norm() < 1e-6;
          found |= same;
        }
      }
    }
    EXPECT_TRUE(found);
  }
}

TEST_P(MirroredFreedom, WithGrainKeepsBothOrRefusesAndStaysAsItWas) {
  for (int k = 0; k < 20; ++k) {
    const RigidMotion map = random_.reflection();
    const AdmissibleAlignments before = AdmissibleAlignments::mirrored(map, group_);
    const double admissible = before.nearest(random_.alignment(), Vec2::Zero()).angle;
    AdmissibleAlignments both = before;
    ASSERT_TRUE(both.restrictAngles({admissible}, 1e-3));
    const Alignment wish = random_.alignment();
    const Alignment got = both.nearest(wish, Vec2::Zero());
    EXPECT_LT(std::abs(wrapAngle(got.angle - admissible)), 1e-3 + kExact);
    EXPECT_LT(asymmetry(group_, got, got, map), kExact);
    expectSame(both.nearest(got, Vec2::Zero()), got);

    // mirror lines are at multiples of 15 degrees, so 7.5 degrees is off every one
    AdmissibleAlignments refused = before;
    EXPECT_FALSE(refused.restrictAngles({admissible + kPi / 24}, 0.05));
    expectSame(refused.nearest(wish, Vec2::Zero()), before.nearest(wish, Vec2::Zero()));
  }
}

}  // namespace
}  // namespace seamwise
