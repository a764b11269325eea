// Reused results of earlier solves must equal those of a fresh solve.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "io/result_json.h"
#include "support/level.h"
#include "support/solver_samples.h"

namespace seamwise {
namespace {

using testing::Task;
using testing::task;

/// The result file of a solve.
std::string solved(const Task& t, SolveMemo* memo) {
  Outcome<Solver> solver = Solver::make(testing::problemOf(t), memo);
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  const Outcome<Result> result = solver.value().finish();
  EXPECT_TRUE(result.ok()) << result.error().message;
  return writeResult(result.value());
}

Json turnedPrint(double angle) {
  Json print = testing::samplePrint("pmm");
  for (const char* basis : {"w1", "w2"}) {
    const double x = print[basis][0], y = print[basis][1];
    print[basis] = {std::cos(angle) * x - std::sin(angle) * y,
                    std::sin(angle) * x + std::cos(angle) * y};
  }
  return print;
}

/// Steps until all alignments are found.
int searchSteps(const Task& t, SolveMemo* memo) {
  Outcome<Solver> solver = Solver::make(testing::problemOf(t), memo);
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  int steps = 0;
  for (; solver.value().phase() == Phase::kAlignment; ++steps) solver.value().advance(1);
  return steps;
}

/// All steps of a solve.
int allSteps(const Task& t, SolveMemo* memo) {
  Outcome<Solver> solver = Solver::make(testing::problemOf(t), memo);
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  int steps = 1;
  while (solver.value().advance(1)) ++steps;
  return steps;
}

TEST(SolveMemo, GivesTheSameResultsAsNoMemo) {
  SolveMemo memo;
  const Task plain = task("apron", "pmm");
  solved(plain, &memo);
  const auto changed = [&](const std::function<void(Task&)>& change) {
    Task t = plain;
    change(t);
    return t;
  };
  const Task changes[] = {
      changed([](Task& t) { t.print = testing::samplePrint("pmm", 7); }),
      changed([](Task& t) { t.print = testing::samplePrint("p1"); }),  // carries no symmetry
      changed([](Task& t) { t.print = turnedPrint(0.3); }),
      changed([](Task& t) {
        t.options["weights"] = {{"0", 3}};
      }),
      changed([](Task& t) {
        t.options["weights"] = {{"0", 3}};
        t.options["pins"] = {{"skirt", {{"angle", 0.1}, {"translation", {3, 2}}}}};
        t.print = turnedPrint(-0.2);
      }),
      plain,
      changed([](Task& t) {
        t.options["grain"] = {{"default", "on"}};
      }),
      changed([](Task& t) { t.options["maxChangeCm"] = 0.2; }),
      changed([](Task& t) { t.options["edgeLengthCm"] = 0.8; }),
      changed([](Task& t) { t.symmetry = "none"; }),
      task("tee", "pmm"),
  };
  for (const Task& t : changes) EXPECT_EQ(solved(t, &memo), solved(t, nullptr)) << t.options;
}

TEST(SolveMemo, DeformsAsIfForTheFirstTime) {
  SolveMemo memo;
  const Task plain = task("tee", "pmm");
  solved(plain, &memo);
  const auto* const plans = memo.mesh.last->made.plans.get();
  Task changed = plain;
  changed.options["weights"] = {{"0", 3}};
  EXPECT_EQ(solved(changed, &memo), solved(changed, nullptr));
  EXPECT_EQ(solved(plain, &memo), solved(plain, nullptr));
  EXPECT_EQ(memo.mesh.last->made.plans.get(), plans);
  changed.options["alpha"] = 2;
  EXPECT_EQ(solved(changed, &memo), solved(changed, nullptr));
}

TEST(SolveMemo, KeepsTheMeshOverChangesThatLeaveItAsItIs) {
  SolveMemo memo;
  Task t = task("apron", "pmm");
  solved(t, &memo);
  const Pattern* const mesh = &memo.mesh.last->made.pattern;
  const auto* const vertices = mesh->pieces[0].rest.data();
  t.options["weights"] = {{"0", 3}};
  t.print = testing::samplePrint("pmm", 7);
  solved(t, &memo);
  EXPECT_EQ(memo.mesh.last->made.pattern.pieces[0].rest.data(), vertices);
  t.options["edgeLengthCm"] = 0.8;
  solved(t, &memo);
  EXPECT_NE(memo.mesh.last->made.pattern.pieces[0].rest.data(), vertices);
}

TEST(SolveMemo, IsSharedByTwoWhoTakeTurnsFromTheirFirstStepOn) {
  SolveMemo memo;
  Task tasks[] = {task("apron", "pmm"), task("tee", "pmm")};
  std::unique_ptr<SolverSetup> setups[2];
  for (int k : {0, 1}) {
    tasks[k].options["effort"] = 2;  // the second solve meets the other's mesh
    setups[k] = std::make_unique<SolverSetup>(testing::problemOf(tasks[k]), &memo);
  }
  for (bool more = true; more;) {
    const bool first = setups[0]->advance();
    more = setups[1]->advance() || first;
  }
  std::vector<Solver> solvers;
  for (auto& setup : setups) solvers.push_back(setup->take().value());
  for (bool more = true; more;) {
    const bool first = solvers[0].advance(1);
    more = solvers[1].advance(1) || first;
  }
  for (int k : {0, 1}) {
    const Outcome<Result> result = solvers[k].finish();
    ASSERT_TRUE(result.ok()) << result.error().message;
    EXPECT_EQ(writeResult(result.value()), solved(tasks[k], nullptr));
  }
}

TEST(SolveMemo, SeeksAnewOnlyWhatHasChanged) {
  SolveMemo memo;
  const Task plain = task("trousers", "pmm");
  const int anew = searchSteps(plain, &memo);
  EXPECT_LE(searchSteps(plain, &memo), 3);
  Task changed = plain;
  changed.options["weights"] = {{"0", 3}};
  EXPECT_LT(searchSteps(changed, &memo), 0.7 * anew);
  changed = plain, changed.print = turnedPrint(0.1);
  EXPECT_LT(searchSteps(changed, &memo), 0.7 * anew);
  changed.print = testing::samplePrint("pmm", 9);
  EXPECT_GT(searchSteps(changed, &memo), 0.7 * anew);
}

TEST(SolveMemo, KnowsTheSymmetricAnswerWhetherItIsAskedForOrNot) {
  Task with = task(testing::isThorough() ? "trousers" : "tee", "pmm"), without = with;
  without.symmetry = "none";
  SolveMemo memo;
  solved(with, &memo);
  EXPECT_LT(allSteps(without, &memo), 0.8 * allSteps(without, nullptr));
  EXPECT_EQ(allSteps(with, &memo), 1);
  EXPECT_EQ(solved(with, &memo), solved(with, nullptr));
  EXPECT_EQ(solved(without, &memo), solved(without, nullptr));
}

TEST(SolveMemo, RemembersWhichSymmetryWasDroppedAndSaysSoAgain) {
  SolveMemo memo;
  Task t = task("tee", "pmm");
  Json& corner = t.garment["pattern"]["panels"]["front"]["vertices"][0][0];
  corner = corner.get<double>() + 0.03;  // nearly symmetric,
  t.options["maxChangeCm"] = 1e-3;       // too little change allowed to make it symmetric
  const std::string first = solved(t, &memo);
  ASSERT_FALSE(memo.mesh.last->made.notes.empty());
  EXPECT_EQ(solved(t, &memo), first);
}

}  // namespace
}  // namespace seamwise
