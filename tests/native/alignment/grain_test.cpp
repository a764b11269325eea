#include "alignment/model/grain.h"

#include <gtest/gtest.h>

#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::sampleGroup;

PieceRule within(double tolerance) { return {{}, {0}, tolerance}; }

/// A mirror line that is turned by 0.05 from the grain, so that the grain of images differs by 0.1.
const RigidMotion kTurned = RigidMotion::reflection(Vec2::Zero(), unit(kPi / 2 + 0.05));

TEST(GrainOfPairs, IsKeptByAPairIfBothTolerancesTogetherSuffice) {
  const WallpaperGroup group = sampleGroup(*findGroup("pmm"));
  const auto keeps = [&](double first, double second) {
    return keepsGrain(group, kTurned, within(first), within(second), false);
  };
  EXPECT_TRUE(keeps(0.04, 0.07));
  EXPECT_TRUE(keeps(0.07, 0.04));
  EXPECT_FALSE(keeps(0.04, 0.05));
  EXPECT_FALSE(keeps(0.05, 0.04));
}

TEST(GrainOfPairs, IsKeptByPinnedAndFreePieces) {
  const WallpaperGroup group = sampleGroup(*findGroup("pmm"));
  PieceRule pinned = within(0), free;
  pinned.pin = Alignment();
  for (const PieceRule& other : {pinned, free}) {
    EXPECT_TRUE(keepsGrain(group, kTurned, within(0), other, false));
    EXPECT_TRUE(keepsGrain(group, kTurned, other, within(0), false));
  }
}

TEST(GrainOfPairs, IsKeptByASinglePieceOnlyNearItsMirrorLine) {
  const WallpaperGroup group = sampleGroup(*findGroup("pmm"));
  EXPECT_TRUE(keepsGrain(group, kTurned, within(0.06), within(0.06), true));
  EXPECT_FALSE(keepsGrain(group, kTurned, within(0.04), within(0.04), true));
}

}  // namespace
}  // namespace seamwise
