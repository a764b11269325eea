#include "solve/seam_reasons.h"

#include <gtest/gtest.h>

#include "pattern/discretise.h"
#include "support/cut_layout.h"
#include "support/small_garments.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::sampleGroup;

/// A panel 30 cm high whose edge 1 or, turned by 180 degrees, edge 3 is sewn.
/// @param bulge  distance of the sewn edge's control point from its straight line. [cm]
Panel panelWith(const char* name, int sewn, double bulge, double height = 30) {
  Panel panel = small::polygon(name, {{0, 0}, {20, 0}, {20, height}, {0, height}});
  const Curve& line = panel.edges[sewn];
  const Vec2 out(sewn == 1 ? bulge : -bulge, 0);
  panel.edges[sewn] =
      Curve::quadratic(line.start(), (line.start() + line.end()) / 2 + out, line.end());
  return panel;
}

/// A seam between the right edge of one panel and the left edge of another.
struct SewnPair {
  SewnPair(const Panel& a, const Panel& b) {
    Garment garment;
    garment.panels = {a, b};
    garment.stitches = {{{0, 1}, {1, 3}}};
    pattern = discretise(garment, {}, {}, 1).value();
  }
  SeamObstacle obstacle(const char* group, const std::vector<PieceRule>& rules = {},
                        bool continuous_only = false,
                        const std::vector<EdgeRef>& locked = {}) const {
    const MatchProblem match =
        matchProblem(pattern, sampleGroup(*findGroup(group)), rules, continuous_only);
    return obstacleOf(pattern, pattern.seams[0], match, locked);
  }
  Pattern pattern;
};

const std::vector<PieceRule> kOnGrain(2, PieceRule{{}, {0}, 0});

TEST(SeamReason, OfSidesThatFitIsThatTheirPiecesFollowOtherSeams) {
  const SewnPair pair(panelWith("a", 1, 6), panelWith("b", 3, -6));
  for (const char* group : {"p1", "pmm"})
    for (const auto& rules : {std::vector<PieceRule>(), kOnGrain}) {
      const SeamObstacle of = pair.obstacle(group, rules);
      EXPECT_EQ(of.reason, SeamReason::kOthers);
      EXPECT_EQ(of.left, 0);
    }
}

TEST(SeamReason, OfSidesThatCurveDifferentlyIsTheirSize) {
  const SewnPair pair(panelWith("a", 1, 8), panelWith("b", 3, 0));
  for (const char* group : {"p1", "pmm"}) {
    const SeamObstacle of = pair.obstacle(group);
    EXPECT_EQ(of.reason, SeamReason::kSize);
    // A parabola 4 cm high runs 4 * 4 / (9 * sqrt(3)) = 1.03 cm from its mean height on average.
    EXPECT_NEAR(of.left, 1.03, 0.1);
  }
}

TEST(SeamReason, OfMirroredSidesIsAPrintWithoutMirrors) {
  const SewnPair pair(panelWith("a", 1, 8), panelWith("b", 3, 8));
  const SeamObstacle without = pair.obstacle("p2");
  EXPECT_EQ(without.reason, SeamReason::kGroup);
  EXPECT_NEAR(without.left, 2 * 1.03, 0.2);
  EXPECT_EQ(pair.obstacle("pmm").reason, SeamReason::kOthers);
  EXPECT_EQ(pair.obstacle("pmm", {}, true).reason, SeamReason::kGroup) << "mirrors are excluded";
}

TEST(SeamReason, OfSidesAtAnAngleIsTheirGrain) {
  const double turn = 0.2;
  const Panel turned = small::moved(panelWith("b", 3, 0), {turn, Vec2::Zero(), false});
  const SewnPair pair(panelWith("a", 1, 0), turned);
  const SeamObstacle of = pair.obstacle("p1", kOnGrain);
  EXPECT_EQ(of.reason, SeamReason::kGrain);
  // Two lines of 30 cm that cross in their middles are 30 / 4 * 2 sin(turn / 2) apart on average.
  EXPECT_NEAR(of.left, 15 * std::sin(turn / 2), 0.1);
  EXPECT_EQ(pair.obstacle("p1").reason, SeamReason::kOthers) << "any angle is allowed";
  std::vector<PieceRule> one_free = kOnGrain;
  one_free[1].angles.clear();
  EXPECT_EQ(pair.obstacle("p1", one_free).reason, SeamReason::kOthers);
  std::vector<PieceRule> fitting = kOnGrain;
  fitting[1].angles = {0, turn};
  EXPECT_EQ(pair.obstacle("p1", fitting).reason, SeamReason::kOthers) << "the second angle fits";
  const auto within = [&](double tolerance) {
    std::vector<PieceRule> rules = kOnGrain;
    for (PieceRule& rule : rules) rule.tolerance = tolerance;
    return pair.obstacle("p1", rules);
  };
  EXPECT_EQ(within(turn / 2).reason, SeamReason::kOthers) << "both sides turn halfway";
  EXPECT_EQ(within(turn / 4).reason, SeamReason::kGrain);
  EXPECT_NEAR(within(turn / 4).left, 15 * std::sin(turn / 4), 0.1)
      << "they turn as far as they may";
}

TEST(SeamReason, OfSidesOfDifferentLengthsIsTheirGather) {
  const SewnPair pair(panelWith("a", 1, 0), panelWith("b", 3, 0, 40));
  const SeamObstacle of = pair.obstacle("pmm");
  EXPECT_EQ(of.reason, SeamReason::kGather);
  EXPECT_EQ(of.left, 0);
}

TEST(SeamReason, OfALockedEdgeIsItsLock) {
  const SewnPair pair(panelWith("a", 1, 8), panelWith("b", 3, 0));
  for (const EdgeRef& edge : {EdgeRef{0, 1}, EdgeRef{1, 3}})
    EXPECT_EQ(pair.obstacle("p1", {}, false, {edge}).reason, SeamReason::kLocked);
  for (const EdgeRef& edge : {EdgeRef{0, 3}, EdgeRef{1, 1}, EdgeRef{0, 0}, EdgeRef{0, 2}})
    EXPECT_EQ(pair.obstacle("p1", {}, false, {edge}).reason, SeamReason::kSize);
}

}  // namespace
}  // namespace seamwise
