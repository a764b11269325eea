#include "geometry/polygon.h"
#include "solve/reckoning.h"
#include "support/level.h"
#include "support/meshed_samples.h"
#include "support/print_samples.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::Reckoning;
using testing::solved;
using testing::Task;
using testing::task;

/// Greatest movement of an outline vertex in its piece's coordinates. [cm]
double movedAsItLies(const Result& r) {
  double worst = 0;
  for (std::size_t p = 0; p < r.shapes.size(); ++p)
    for (int v : r.pattern.pieces[p].outline)
      worst = std::max(worst, (r.shapes[p][v] - r.pattern.pieces[p].rest[v]).norm());
  return worst;
}

std::vector<Task> tasks() {
  std::vector<Task> all{task("gathered-skirt", "p1"), task("tee", "pmm"),
                        task("princess-dress", "p31m"), task("tee", "pgg")};
  if (testing::isThorough())
    for (const char* garment : {"gathered-skirt", "tee", "princess-dress"})
      for (const char* group : {"p1", "pmm", "p31m", "pgg"}) all.push_back(task(garment, group));
  return all;
}

TEST(Metrics, SayWhatTheGeometrySays) {
  for (const Task& t : tasks()) {
    const Result r = solved(t);
    const Reckoning own(r);
    const Shapes rest = restShapes(r.pattern);
    auto expectClose = [&](double stated, double found) {
      EXPECT_NEAR(stated, found, 1e-9 * (1 + found)) << t.print;
    };
    expectClose(r.total.nearest, own.fit(r.shapes, r.alignment));
    expectClose(r.total.strict, own.fit(r.shapes, r.alignment, true));
    expectClose(r.total.joined, own.seamFit(r.shapes, r.alignment));
    expectClose(r.total_drafted, own.fit(rest, r.drafted));
    expectClose(r.total_search, own.fit(rest, r.search));
    expectClose(r.total_aligned, own.fit(rest, r.alignment));
    EXPECT_LE(r.max_moved_cm, movedAsItLies(r) + 1e-12);
    EXPECT_LE(r.total.nearest, r.total.strict * (1 + 1e-9));
    EXPECT_LE(r.total.nearest, r.total.joined * (1 + 1e-9));
    EXPECT_LT(r.total_search, r.total_random);
  }
}

TEST(Metrics, CountOnlyWhatMayMeetWhereMirroredSeamsAreForbidden) {
  for (const char* group : testing::sampleOf<const char*>(1, {"pgg", "pmm", "p31m"})) {
    Task t = task("tee", group);
    EXPECT_FALSE(solved(t).continuous.has_value());
    t.options["continuousOnly"] = true;
    const Result r = solved(t);
    ASSERT_TRUE(r.continuous.has_value());
    const Reckoning own(r, true);
    const Shapes rest = restShapes(r.pattern);
    auto expectClose = [&](double stated, double found) {
      EXPECT_NEAR(stated, found, 1e-9 * (1 + found)) << group;
    };
    expectClose(r.continuous->total.nearest, own.fit(r.shapes, r.alignment));
    expectClose(r.continuous->total.strict, own.fit(r.shapes, r.alignment, true));
    expectClose(r.continuous->total.joined, own.seamFit(r.shapes, r.alignment));
    expectClose(r.continuous->total_drafted, own.fit(rest, r.drafted));
    expectClose(r.continuous->total_search, own.fit(rest, r.search));
    expectClose(r.continuous->total_aligned, own.fit(rest, r.alignment));
    expectClose(r.total.nearest, Reckoning(r).fit(r.shapes, r.alignment));
    EXPECT_GT(r.continuous->total_random, r.total_random);
    EXPECT_GT(r.continuous->total.nearest, r.total.nearest);
    const double length = own.lengthOver(-1);
    expectClose(r.local.final * length, r.continuous->total.nearest);
    expectClose(r.local.off, own.lengthOver(0.5));
  }
}

TEST(Metrics, NineTenthsOfTheSeamsMissByNoMoreThanP90) {
  const Result r = solved(task("princess-dress", "p31m"));
  const Reckoning own(r);
  const double length = own.lengthOver(-1);
  EXPECT_GT(r.local.p90, r.local.final);
  EXPECT_LE(own.lengthOver(r.local.p90 + 1e-6), 0.1 * length);
  EXPECT_GE(own.lengthOver(r.local.p90 - 1e-6), 0.1 * length);
  EXPECT_NEAR(r.local.off, own.lengthOver(0.5), 1e-9);
}

TEST(Metrics, FitOfRandomAlignmentsIsTheirMean) {
  const Result r = solved(task("tee", "pmm"));
  const Reckoning own(r);
  testing::Random random(1);
  double total = 0;
  constexpr int kDraws = 60;
  for (int k = 0; k < kDraws; ++k) {
    std::vector<Alignment> at(r.pattern.pieces.size());
    for (Alignment& a : at) a = random.alignment();
    total += own.fit(restShapes(r.pattern), at) / kDraws;
  }
  EXPECT_NEAR(r.total_random, total, 0.1 * total);
}

TEST(Metrics, MismatchOfEverySeamIsThatOfItsJoin) {
  const Result r = solved(task("tee", "p4m"));
  ASSERT_EQ(r.joins.size(), r.pattern.seams.size());
  double total = 0;
  for (std::size_t s = 0; s < r.joins.size(); ++s) {
    const Seam& seam = r.pattern.seams[s];
    ASSERT_EQ(r.mismatch[s].size(), seam.a.vertices.size() - 1);
    const SeamMidpoints m = seamMidpoints(seam, r.shapes, r.alignment);
    for (std::size_t i = 0; i < m.x.size(); ++i)
      if (seam.matched && !seam.twin) total += m.length[i] * r.mismatch[s][i];
  }
  EXPECT_NEAR(total, r.total.joined, 1e-9 * total);
}

TEST(BestMethod, KeepsSymmetrySewabilityAndTheGarmentsLines) {
  for (const Task& t : tasks()) {
    const Result r = solved(t);
    const WallpaperGroup group = testing::problemOf(t).print.group;
    for (const Mirror& m : r.pattern.mirrors) {
      const Alignment &first = r.alignment[m.pieces[0]], &second = r.alignment[m.pieces[1]];
      EXPECT_LT(testing::asymmetry(group, first, second, m.map), 1e-6);
    }
    EXPECT_LT(testing::shapeAsymmetry(r.pattern, r.shapes), 1e-6);
    EXPECT_LT(testing::seamError(r.pattern, r.shapes), 0.01);
    EXPECT_GT(testing::leastArea(r.pattern, r.shapes), 0.3);
    for (std::size_t p = 0; p < r.shapes.size(); ++p) {
      const auto& outline = r.pattern.pieces[p].outline;
      const auto& rest = r.pattern.pieces[p].rest;
      Polyline now;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const int u = outline[k], v = outline[(k + 1) % outline.size()];
        now.push_back(r.shapes[p][u]);
        EXPECT_NEAR((r.shapes[p][v] - r.shapes[p][u]).norm() / (rest[v] - rest[u]).norm(), 1, 0.15);
      }
      EXPECT_FALSE(findCrossing(now).has_value()) << r.pattern.pieces[p].name;
    }
  }
}

TEST(BestMethod, IsStifferWithALargerAlphaAndAveragesSeamShapesWhenAsked) {
  const Task plain = task("tee", "pgg");
  Task soft = plain, stiff = plain, averaged = plain;
  soft.options["alpha"] = 0.1, stiff.options["alpha"] = 100;
  averaged.options["averageSeamShapes"] = true;
  const Result softly = solved(soft), stiffly = solved(stiff), average = solved(averaged);
  EXPECT_LT(softly.total.nearest, stiffly.total.nearest);
  EXPECT_NE(average.shapes, solved(plain).shapes);
  for (const Result* r : {&softly, &stiffly, &average}) {
    EXPECT_LT(r->total.nearest, r->total_aligned);
    EXPECT_LT(testing::seamError(r->pattern, r->shapes), 0.01);
    EXPECT_LE(r->max_moved_cm, 1);
  }
}

TEST(Solver, ReportsPhasesInOrderProgressThatNeverFallsAndAnAlignmentThroughout) {
  for (Method method : testing::sampleOf<Method>(1, {Method::kBest, Method::kPaper})) {
    Task t = task("gathered-skirt", "pmm");
    t.method = method;
    t.options["alpha"] = 4;  // given, so that other methods don't search for it
    Outcome<Solver> made = Solver::make(testing::problemOf(t));
    ASSERT_TRUE(made.ok());
    Solver& solver = made.value();
    double fraction = 0;
    Phase phase = Phase::kAlignment;
    bool more = true;
    while (more) {
      more = solver.advance(1);
      EXPECT_GE(solver.fraction(), fraction);
      EXPECT_GE(solver.phase(), phase);
      EXPECT_EQ(solver.partial().size(), solver.pattern().pieces.size());
      fraction = solver.fraction(), phase = solver.phase();
    }
    EXPECT_EQ(fraction, 1);
    EXPECT_EQ(phase, Phase::kDone);
    EXPECT_FALSE(solver.advance(1));
    EXPECT_TRUE(solver.finish().ok());
  }
}

TEST(SearchBound, SaysHowMuchBetterAnAlignmentCouldBe) {
  const auto boundOf = [](Task t, double proof) {
    t.options["proof"] = proof;
    return solved(t).search_bound;
  };
  EXPECT_EQ(boundOf(task("apron", "pmm"), 0), 1);  // everything matches, so no better result exists
  const Task hard = task("gathered-skirt", "cm");
  const double none = boundOf(hard, 0), little = boundOf(hard, 0.005), much = boundOf(hard, 0.3);
  EXPECT_EQ(none, 0);
  EXPECT_GT(little, 0);
  EXPECT_LT(little, 1);
  EXPECT_EQ(much, 1);
  for (const char* garment : {"gathered-skirt", "tee"}) {
    Task on_grain = task(garment, "pmm");
    on_grain.symmetry = "auto";
    on_grain.options["grain"] = {{"default", "on"}};
    EXPECT_EQ(boundOf(on_grain, 4), 1) << garment;
  }
  Task paper = hard;
  paper.method = Method::kPaper, paper.options["maxChangeCm"] = 0;
  EXPECT_EQ(solved(paper).search_bound, 0);
}

}  // namespace
}  // namespace seamwise
