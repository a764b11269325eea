// Proofs for a complete garment, run alongside a solve.
#include "methods/proof_run.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/result_json.h"
#include "support/level.h"
#include "support/solver_samples.h"
#include "tuning/proof.h"

namespace seamwise {
namespace {

using testing::problemOf;
using testing::Task;
using testing::task;

Task onGrain(const char* garment, const char* group) {
  Task t = task(garment, group);
  t.options["grain"] = {{"default", "on"}};
  return t;
}

Solver solverOf(const Task& t, SolveMemo* memo) {
  Outcome<Solver> solver = Solver::make(problemOf(t), memo);
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  return std::move(solver).value();
}

TEST(Proof, NeverFallsAndEndsByProvingSmallGarments) {
  for (const char* garment :
       testing::sampleOf<const char*>(1, {"gathered-skirt", "tee", "shift-dress"})) {
    SolveMemo memo;
    Solver solver = solverOf(onGrain(garment, "pmm"), &memo);
    double last = 0;
    while (solver.prove(1)) {
      const double bound = solver.proven().bound;
      EXPECT_GE(bound, last) << garment;
      last = bound;
    }
    EXPECT_DOUBLE_EQ(solver.proven().bound, 1) << garment;
  }
}

TEST(Proof, IsOfTheAlignmentThatTheSolveFound) {
  const Task t = onGrain("raglan", "p31m");
  SolveMemo memo;
  Solver solver = solverOf(t, &memo);
  const Result result = solver.finish().value();
  solver.prove(50);
  EXPECT_DOUBLE_EQ(solver.proven().search_cost, result.search_cost);
  EXPECT_GE(solver.proven().bound, result.search_bound);
}

TEST(Proof, ChangesNoResult) {
  const Task t = task("shift-dress", "pgg");
  SolveMemo memo, other;
  Solver proving = solverOf(t, &memo), plain = solverOf(t, &other);
  proving.prove(200);
  EXPECT_EQ(writeResult(proving.finish().value()), writeResult(plain.finish().value()));
}

TEST(Proof, HoldsForAlignmentsAnywhere) {
  const Task t = onGrain("tee", "p4m");
  SolveMemo memo;
  Solver solver = solverOf(t, &memo);
  solver.prove(400);
  const Proven proven = solver.proven();
  ASSERT_GT(proven.bound, 0.5);
  // other seeds find other answers, none of which may be better than the proven bound
  for (int k = 0; k < testing::cases(2, 6); ++k) {
    Task other = t;
    other.seed = 2 + k;
    other.options["maxChangeCm"] = 0;
    EXPECT_GE(testing::solved(other).search_cost,
              proven.bound * proven.search_cost * (1 - ProofTuning::kProven));
  }
}

TEST(Proof, IsOfTheDefaultMethodAlone) {
  Task t = task("tee", "pmm");
  t.method = Method::kPaper;
  SolveMemo memo;
  Solver solver = solverOf(t, &memo);
  EXPECT_FALSE(solver.prove(10));
  EXPECT_EQ(solver.proven().bound, 0);
}

}  // namespace
}  // namespace seamwise
