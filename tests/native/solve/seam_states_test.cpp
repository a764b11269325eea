#include "solve/seam_states.h"

#include <gtest/gtest.h>

#include <numeric>

#include "methods/seam_rules.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::solved;
using testing::Task;
using testing::task;

/// Share of the group's length within `tolerance` cm. [1]
double shareWithin(const Result& result, const SeamGroup& group, double tolerance) {
  const WallpaperGroup print = WallpaperGroup::make(result.group, result.w1, result.w2).value();
  double within = 0, length = 0;
  for (const int s : group.seams) {
    const SeamMidpoints m = seamMidpoints(result.pattern.seams[s], result.shapes, result.alignment);
    for (std::size_t i = 0; i < m.x.size(); ++i) {
      length += m.length[i];
      if (print.distance(m.x[i], m.y[i]) <= tolerance) within += m.length[i];
    }
  }
  return within / length;
}

Task byPlace(const std::string& garment, const std::string& group) {
  Task t = task(garment, group);
  t.options["visibility"] = "place";
  return t;
}

TEST(SeamStates, FollowTheLengthsWithinTolerance) {
  int seen[5] = {0, 0, 0, 0, 0};
  for (const char* garment : {"tee", "princess-dress", "gathered-skirt"}) {
    const Result result = solved(byPlace(garment, "pmm"));
    ASSERT_EQ(result.states.size(), result.groups.size());
    for (std::size_t g = 0; g < result.groups.size(); ++g) {
      const GroupFigures& of = result.states[g];
      ++seen[static_cast<int>(of.state)];
      const bool matches = shareWithin(result, result.groups[g], 0.3) >= 0.95;
      EXPECT_EQ(of.state == SeamState::kMatches, matches) << garment << " group " << g;
      EXPECT_EQ(of.reason == SeamReason::kNone, matches) << garment << " group " << g;
      if (shareWithin(result, result.groups[g], 0.6) >= 0.95) {
        EXPECT_LE(of.state, SeamState::kClose) << garment << " group " << g;
      } else if (of.state == SeamState::kClose) {
        ASSERT_TRUE(of.end) << garment << " group " << g;
      }
      if (of.end) {
        EXPECT_GE(of.end->cm, 0.5);
      }
    }
  }
  for (const SeamState state : {SeamState::kMatches, SeamState::kOff, SeamState::kCannot})
    EXPECT_GT(seen[static_cast<int>(state)], 0) << static_cast<int>(state);
}

TEST(SeamStates, NameTheChoiceOfTheUser) {
  Task t = byPlace("tee", "pmm");
  t.options["unmatched"] = {0};
  t.options["maxChangeCm"] = 0;
  const Result result = solved(t);
  EXPECT_EQ(result.groups[0].seams, std::vector<int>{0});
  EXPECT_EQ(result.states[0].state, SeamState::kChoice);
  EXPECT_NE(result.states[1].state, SeamState::kChoice);
}

TEST(AnswerCost, IsTheTotalMismatchIfSeamsCountEqually) {
  Task even = task("tee", "pmm"), graded = byPlace("tee", "pmm");
  even.options["maxChangeCm"] = graded.options["maxChangeCm"] = 0;
  const Result a = solved(even), b = solved(graded);
  EXPECT_EQ(a.cost, a.total.nearest);
  EXPECT_GT(b.cost, b.total.nearest);
}

}  // namespace
}  // namespace seamwise
