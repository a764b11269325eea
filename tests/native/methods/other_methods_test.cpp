// The methods for comparison: their invariants, and the options that make the most of them.
#include <algorithm>

#include "alignment/baseline/sweeps.h"
#include "support/cut_layout.h"
#include "support/level.h"
#include "support/meshed_samples.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::solved;
using testing::Task;
using testing::task;

bool says(const Result& r, const std::string& code) {
  return std::any_of(r.notes.begin(), r.notes.end(),
                     [&](const Note& note) { return note.code == code; });
}

TEST(OtherMethods, EndAndKeepTheGreatestChange) {
  SEAMWISE_THOROUGH_ONLY();
  for (Method method : {Method::kPaper, Method::kWs19}) {
    Task t = task("gathered-skirt", "pmm");
    t.method = method;
    const Result r = solved(t);
    EXPECT_EQ(r.method, method);
    EXPECT_GT(r.iterations, 0);
    EXPECT_EQ(r.pattern.mirrors.empty(), method == Method::kWs19);
    EXPECT_LT(testing::shapeAsymmetry(r.pattern, r.shapes), 1e-3);
    EXPECT_LT(testing::seamError(r.pattern, r.shapes), 0.01);
    EXPECT_GT(testing::leastArea(r.pattern, r.shapes), 0);
    EXPECT_LE(r.max_moved_cm, 1);
    EXPECT_LE(r.total.nearest, r.total_aligned);
  }
}

TEST(OtherMethods, LeaveThePiecesAsDraftedWhereAllTheyFindFitsWorse) {
  SEAMWISE_THOROUGH_ONLY();
  // only the worst seam has a weight, so it pulls whole pieces away from seams that matched before
  Task t = task("tee", "pgg");
  t.options["maxChangeCm"] = 0;
  const Result placed = solved(t);
  std::size_t worst = 0;
  for (std::size_t s = 0; s < placed.figures.size(); ++s) {
    const Seam& seam = placed.pattern.seams[s];
    if (!seam.twin && placed.figures[s].final > placed.figures[worst].final) worst = s;
  }
  for (std::size_t s = 0; s < placed.figures.size(); ++s)
    t.options["weights"][std::to_string(s)] = s == worst ? 1 : 0;
  for (std::size_t p = 0; p < placed.alignment.size(); ++p) {
    const Alignment& at = placed.alignment[p];
    t.options["pins"][placed.pattern.pieces[p].name] = {
        {"angle", at.angle}, {"translation", {at.translation.x(), at.translation.y()}}};
  }
  t.options["alpha"] = 1000, t.options["maxChangeCm"] = 1;
  t.method = Method::kPaper;
  const Result r = solved(t);
  EXPECT_TRUE(says(r, "leftAsDrafted"));
  EXPECT_LT(r.max_moved_cm, 1e-9);
  EXPECT_NEAR(r.total.nearest, r.total_aligned, 1e-9 * r.total_aligned);
}

TEST(OtherMethods, PlaceNoWorseWithMoreStartsWhichTheDraftedLayoutIsOneOf) {
  int better = 0;
  for (Method method : {Method::kPaper, Method::kWs19}) {
    Task t = task("tee", "pmm");
    t.method = method;
    t.options["maxChangeCm"] = 0;
    const double one = solved(t).total_search;
    t.options["starts"] = 8;
    const Result eight = solved(t);
    t.options["starts"] = 16;
    EXPECT_LE(eight.total_search, one * (1 + 1e-12));
    better += eight.total_search < 0.99 * one;
    EXPECT_LE(solved(t).total_search, eight.total_search * (1 + 1e-12));
    const WallpaperGroup group = testing::problemOf(t).print.group;
    const MatchProblem match = testing::matchProblem(eight.pattern, group);
    LocalSweeps sweeps(match, match.ofLeaders(eight.drafted));
    while (sweeps.step()) {
    }
    const double drafted =
        totalMismatch(group, eight.pattern, restShapes(eight.pattern), match.expanded(sweeps.at()));
    EXPECT_LE(eight.total_search, drafted * (1 + 1e-9));
  }
  EXPECT_GT(better, 0) << "it could not fail";
}

TEST(OtherMethods, MoveLessTowardsClippedTargets) {
  Task t = task("apron", "p1");
  t.method = Method::kPaper;
  t.options["alpha"] = 4;
  const double moved = solved(t).max_moved_cm;
  t.options["clipTargets"] = true;
  const Result clipped = solved(t);
  EXPECT_GT(moved, 1);
  EXPECT_LT(clipped.max_moved_cm, 0.8 * moved);
  EXPECT_LT(clipped.total.nearest, clipped.total_aligned);
}

}  // namespace
}  // namespace seamwise
